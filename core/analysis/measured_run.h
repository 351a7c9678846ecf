// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The run of a sample with its numbers.
#pragma once

#include "core/analysis/metrics.h"
#include "core/design/fitted_fabric.h"
#include "core/run/run_options.h"

namespace hygroloom {

class Backend;

/// A finished run with its numbers.
struct FinishedRun {
    RunRecord run;
    Metrics metrics;
    std::string device_failure; ///< a sentence, after which the run went on on the CPU; empty: none
};

/// Each frame, with what all frames so far come to, which goes on with the run.
using MeasuredFrame = std::function<void(const std::shared_ptr<const Frame>&, const std::shared_ptr<const MetricsCollector>&)>;

/// Runs an experiment to its end and measures it; the callbacks are called beside. Throws Cancelled and Error.
FinishedRun run_and_measure(const Design& design, const std::string& fabric, const std::string& experiment, const RunOptions& options,
                            Backend& backend, RunControl& control, const RunCallbacks& beside = {}, const MeasuredFrame& measured = {});

/// Of each of the fabrics, with its fit, those in the design's order; see textile_of_run().
std::vector<Textile> textiles_of_runs(const Design& design, const std::vector<std::shared_ptr<const FittedFabric>>& fitted,
                                      const std::vector<std::string>& fabrics, const Experiment& experiment);

} // namespace hygroloom
