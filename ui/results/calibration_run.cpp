// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/calibration_run.h"

#include "core/base/error.h"
#include "core/run/plan_run.h"
#include "gpu/backends.h"

#include <numeric>

namespace hygroloom {

CalibrationRun::~CalibrationRun() { cancel(); }

void CalibrationRun::post(std::function<void()> work) { QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection); }

void CalibrationRun::start(Task task)
{
    if (thread_.joinable()) { thread_.join(); }
    cancel_ = false;
    running_ = true;
    thread_ = std::jthread([this, task = std::move(task)] {
        std::shared_ptr<const Calibration> result;
        QString sentence;
        try {
            result = fitted(task);
        } catch (const Cancelled&) {
            // nothing to say
        } catch (const std::bad_alloc&) {
            sentence = tr("Not enough memory for these runs. Choose a smaller sample or a lower fidelity.");
        } catch (const std::exception& error) {
            sentence = QString::fromStdString(error.what());
        }
        post([this, result, sentence] {
            running_ = false;
            Q_EMIT ended(result, sentence);
        });
    });
}

std::shared_ptr<const Calibration> CalibrationRun::fitted(const Task& task)
{
    const Fabric& fabric = *find_fabric(*task.design, task.fabric);
    const Experiment& experiment = *find_experiment(*task.design, task.experiment);
    const std::size_t bytes = bytes_of_largest(*task.design, experiment, {textile_of_run(*task.design, fabric, experiment)}, task.how);
    const auto places = std::make_shared<RunPlaces>(make_backends(task.backend, 0, 2 * static_cast<int>(task.inputs.size()), bytes));
    CalibrationRuns runs{*task.design,
                         task.fabric,
                         task.experiment,
                         task.data,
                         task.inputs,
                         task.how,
                         queue_.runs(),
                         places,
                         expected_backend(task.backend),
                         cancel_,
                         tr("Calibration of %1").arg(QString::fromStdString(task.fabric)).toStdString()};
    int done = 0;
    std::mutex mutex; // several run side by side
    std::vector<double> shares;
    runs.started = [&](std::size_t points) {
        done += static_cast<int>(shares.size());
        shares.assign(points, 0);
        post([this, done] { Q_EMIT progressed(done, 0); });
    };
    runs.progress = [&](std::size_t point, const RunProgress& progress) {
        const std::lock_guard lock(mutex);
        shares[point] = progress.duration > 0 ? progress.simulated / progress.duration : 0;
        const double share = std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
        post([this, done, share] { Q_EMIT progressed(done, share); });
    };
    return std::make_shared<Calibration>(calibrate(runs));
}

} // namespace hygroloom
