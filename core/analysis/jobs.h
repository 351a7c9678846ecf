// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The runs of a comparison: each fabric's textile, and its replicates.
#pragma once

#include "core/analysis/sweep.h"
#include "core/design/fitted_fabric.h"

namespace hygroloom {

/// Of each of the fabrics, with its fit, those in the design's order; see textile_of_run().
std::vector<Textile> textiles_of_runs(const Design& design, const std::vector<std::shared_ptr<const FittedFabric>>& fitted,
                                      const std::vector<std::string>& fabrics, const Experiment& experiment);

/// One run of a fabric's replicate.
struct Job {
    Drawn drawn;
    std::string fabric;
    RunOptions how;
};

/// Replicate 0 of each fabric, then replicate 1 of each, and so on. textiles: of the fabrics as given.
std::vector<Job> jobs_of(const Design& design, const std::vector<std::string>& fabrics, const std::string& experiment,
                         const std::vector<Textile>& textiles, const RunOptions& how, int replicates);

/// What its run gave, without the run's textile but for its quantities. Takes the run.
CandidateRun candidate_of(const Job& job, FinishedRun finished);

} // namespace hygroloom
