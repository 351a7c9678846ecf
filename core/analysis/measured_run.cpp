// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/measured_run.h"

#include "core/run/runner.h"

namespace hygroloom {

FinishedRun run_and_measure(const Design& design, const std::string& fabric, const std::string& experiment, const RunOptions& options,
                            Backend& backend, RunControl& control, const RunCallbacks& beside, const MeasuredFrame& measured)
{
    const auto collector = std::make_shared<MetricsCollector>();
    FinishedRun finished;
    RunCallbacks callbacks = beside;
    callbacks.started = [&](const RunRecord& record) {
        collector->start(record);
        if (beside.started) beside.started(record);
    };
    callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) {
        collector->add(*frame);
        if (beside.frame) beside.frame(frame);
        if (measured) measured(frame, collector);
    };
    callbacks.switched_on = [&](const SwitchedPart& part) {
        collector->add(part);
        if (beside.switched_on) beside.switched_on(part);
    };
    callbacks.device_failed = [&](const std::string& sentence) {
        finished.device_failure = sentence;
        if (beside.device_failed) beside.device_failed(sentence);
    };
    finished.run = run_experiment(design, fabric, experiment, options, backend, control, callbacks);
    finished.metrics = collector->metrics();
    return finished;
}

std::vector<Textile> textiles_of_runs(const Design& design, const std::vector<std::shared_ptr<const FittedFabric>>& fitted,
                                      const std::vector<std::string>& fabrics, const Experiment& experiment)
{
    std::vector<Textile> textiles;
    for (const std::string& name : fabrics) {
        const Fabric& fabric = *find_fabric(design, name);
        const auto place = static_cast<std::size_t>(&fabric - design.fabrics.data());
        textiles.push_back(textile_of_run(design, fabric, experiment, fitted[place].get()));
    }
    return textiles;
}

} // namespace hygroloom
