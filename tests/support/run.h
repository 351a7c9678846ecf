// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A design's first experiment with its first fabric, run to its end by default on a CPU.
#pragma once

#include "core/analysis/metrics.h"
#include "core/run/runner.h"
#include "core/solver/backend.h"

namespace hygroloom {

struct Run {
    RunRecord record;
    std::vector<Frame> frames;
    Metrics metrics;

    const Frame& end() const { return frames.back(); }
};

inline RunOptions draft(const ForcedParts& forced = {}, const KnobSettings& knobs = {})
{
    RunOptions options;
    options.fidelity = Fidelity::draft;
    options.forced = forced;
    options.knobs = knobs;
    return options;
}

inline Run run(const Design& design, const RunOptions& options, Backend& backend)
{
    Run run;
    RunControl control;
    MetricsCollector collector;
    RunCallbacks callbacks;
    callbacks.started = [&](const RunRecord& record) { collector.start(record); };
    callbacks.frame = [&](std::shared_ptr<const Frame> frame) {
        collector.add(*frame);
        run.frames.push_back(*frame);
    };
    callbacks.switched_on = [&](const SwitchedPart& part) { collector.add(part); };
    run.record = run_experiment(design, design.fabrics[0].name, design.experiments[0].name, options, backend, control, callbacks);
    run.metrics = collector.metrics();
    return run;
}

inline Run run(const Design& design, const RunOptions& options) { return run(design, options, *make_cpu_backend()); }

} // namespace hygroloom
