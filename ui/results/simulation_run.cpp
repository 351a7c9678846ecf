// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/simulation_run.h"

namespace hygroloom {

SimulationRun::SimulationRun(WindowQueue& queue, QObject* parent)
    : QueuedRun(queue, tr("Choose a smaller sample or a lower fidelity."), parent)
{
}

void SimulationRun::start(const std::shared_ptr<const Design>& design, const std::string& fabric, const std::string& experiment,
                          const RunOptions& options, const std::string& backend)
{
    RunJob job{design, experiment, fabric, {}, options};
    job.beside.started = [this](const RunRecord& record) {
        post([this, run = std::make_shared<const RunRecord>(record)] { Q_EMIT started(run); });
    };
    job.measured = [this](const std::shared_ptr<const Frame>& frame, const std::shared_ptr<const MetricsCollector>& so_far) {
        post([this, frame, metrics = std::make_shared<const Metrics>(so_far->metrics())] { Q_EMIT frameArrived(frame, metrics); });
    };
    begin(std::move(job), backend, [this](RunResult& result) {
        post([this, run = std::make_shared<const RunRecord>(result.sample->run)] { Q_EMIT completed(run); });
    });
    Q_EMIT begun();
}

} // namespace hygroloom
