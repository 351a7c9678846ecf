// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Many runs for one answer: all fabrics of a comparison, side by side.
#pragma once

#include "core/analysis/comparison.h"
#include "core/analysis/metrics.h"
#include "core/run/run_options.h"
#include "core/run/side_by_side.h"

#include <functional>
#include <optional>

namespace hygroloom {

/// What one run of a comparison gave.
struct CandidateRun {
    Candidate candidate;
    bool device_failed = false; ///< the run went on on the CPU
};

/// Runs every fabric as often as the comparison has replicates, side by side, each run on one of the backends: run(i, backend) gives
/// replicate i / fabrics of fabric i % fabrics, so that all fabrics have their first before one has its second. An Error in it concerns
/// that run alone. After each the comparison is judged anew, and ended(i) is called, never two at a time. Throws what ended() throws;
/// cancelled runs are left out.
void run_comparison(Comparison& comparison, const std::vector<std::string>& fabrics, const std::vector<std::unique_ptr<Backend>>& backends,
                    RunControl& control, const std::function<CandidateRun(std::size_t, Backend&)>& run,
                    const std::function<void(std::size_t)>& ended);

/// A finished run with its numbers.
struct FinishedRun {
    RunRecord run;
    Metrics metrics;
    std::string device_failure; ///< a sentence, after which the run went on on the CPU; empty: none
};

/// Runs an experiment to its end and measures it; the callbacks are called beside. Throws Cancelled and Error.
FinishedRun run_and_measure(const Design& design, const std::string& fabric, const std::string& experiment, const RunOptions& options,
                            Backend& backend, RunControl& control, const RunCallbacks& beside = {});

} // namespace hygroloom
