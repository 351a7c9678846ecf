// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// --replicates: runs of cloths that the descriptions leave open.
#pragma once

#include "app/cli_run.h"

#include "core/analysis/sweep.h"

namespace hygroloom {

/// One run of a fabric's replicate.
struct Job {
    Drawn drawn;
    std::string fabric;
    RunOptions how;
};

/// Replicate 0 of each fabric, then replicate 1 of each, and so on. textiles: of the fabrics as given.
std::vector<Job> jobs_of(const Design& design, const std::vector<std::string>& fabrics, const std::string& experiment,
                         const std::vector<Textile>& textiles, const RunOptions& how, int replicates);

/// What its run gave, without the run's textile. Takes the run.
CandidateRun candidate_of(const Job& job, FinishedRun finished);

/// whose: "" or " of each fabric".
void add_replicates_option(CLI::App& verb, int& replicates, const std::string& whose);

} // namespace hygroloom
