// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/simulation_run.h"

#include "core/base/error.h"
#include "core/run/learned_times.h"
#include "gpu/backends.h"
#include "ui/basics/quantity.h"

namespace hygroloom {

SimulationRun::SimulationRun(QObject* parent) : QObject(parent), control_(std::make_unique<RunControl>()) {}

SimulationRun::~SimulationRun()
{
    cancel();
    if (thread_.joinable()) { thread_.join(); }
}

void SimulationRun::post(std::function<void()> work) { mail_.post(std::move(work)); }

void SimulationRun::start(const std::shared_ptr<const Design>& design, const std::string& fabric, const std::string& experiment,
                          const RunOptions& options, const std::string& backend)
{
    if (thread_.joinable()) { thread_.join(); }
    control_->cancel = false;
    control_->pause = false;
    was_paused_ = false;
    running_ = true;
    thread_ = std::jthread([this, design, fabric, experiment, options, backend] {
        MetricsCollector collector;
        RunCallbacks callbacks;
        callbacks.started = [&](const RunRecord& record) {
            collector.start(record);
            post([this, run = std::make_shared<const RunRecord>(record)] { Q_EMIT started(run); });
        };
        callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) {
            collector.add(*frame);
            post([this, frame, metrics = std::make_shared<const Metrics>(collector.metrics())] { Q_EMIT frameArrived(frame, metrics); });
        };
        callbacks.memory_is_short = [this](const std::string&) { post([this] { Q_EMIT memoryIsShort(); }); };
        callbacks.switched_on = [&](const SwitchedPart& part) { collector.add(part); };
        callbacks.progress = [this](const RunProgress& progress) { post([this, progress] { Q_EMIT progressed(progress); }); };
        Outcome outcome = Outcome::finished;
        QString sentence;
        QString device_failure;
        callbacks.device_failed = [&](const std::string& failure) { device_failure = QString::fromStdString(failure); };
        try {
            const std::unique_ptr<Backend> machine = make_backend(backend);
            const auto run =
                std::make_shared<const RunRecord>(run_experiment(*design, fabric, experiment, options, *machine, *control_, callbacks));
            if (!was_paused_ && device_failure.isEmpty()) learn_time(*run);
            post([this, run] { Q_EMIT completed(run); });
        } catch (const Cancelled&) {
            outcome = Outcome::cancelled;
        } catch (const DeviceError& error) {
            outcome = Outcome::device_failed;
            sentence = QString::fromStdString(error.what());
        } catch (const NotEnoughMemory& error) {
            outcome = Outcome::memory_short;
            sentence = tr("This run takes about %1 of memory; %2 are free. Choose a smaller sample or a lower fidelity.")
                           .arg(bytesText(error.needed), bytesText(error.available));
        } catch (const std::bad_alloc&) {
            outcome = Outcome::failed;
            sentence = tr("Not enough memory for this run. Choose a smaller sample or a lower fidelity.");
        } catch (const std::exception& error) {
            outcome = Outcome::failed;
            sentence = QString::fromStdString(error.what());
        }
        sentence = QStringList{device_failure, sentence}.join(' ').trimmed();
        post([this, outcome, sentence] { end(outcome, sentence); });
    });
    Q_EMIT begun();
}

void SimulationRun::end(Outcome outcome, const QString& sentence)
{
    running_ = false;
    Q_EMIT ended(outcome, sentence);
}

void SimulationRun::setPaused(bool paused)
{
    if (running_ && control_->pause != paused) {
        control_->pause = paused;
        was_paused_ = true;
        Q_EMIT pausedChanged(paused);
    }
}

void SimulationRun::cancel()
{
    control_->cancel = true;
    control_->pause = false;
}

} // namespace hygroloom
