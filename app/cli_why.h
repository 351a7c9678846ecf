// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// compare --why: runs the mixtures of two fabrics that tell which of the inputs make their difference.
#pragma once

#include "app/cli_replicates.h"

#include "core/analysis/why.h"
#include "core/queue/compared_runs.h"

namespace hygroloom {

/// The mixtures' runs are as those of the fabrics; experiment, replicates and number are the comparison's. Says nothing where the two
/// fabrics do not differ, and runs nothing then. Cancelled: the comparison stays without its why. Precondition: the comparison has ended.
void find_why(Comparison& comparison, const WhyPlan& plan, const Design& design, const RunOptions& how, bool quiet, RunQueue& queue,
              const std::shared_ptr<RunPlaces>& places, const std::atomic<bool>& cancel);

/// Of the mixtures, for the choice of a fidelity by time.
std::vector<Textile> textiles_of_mixtures(const Design& design, const WhyPlan& plan);

} // namespace hygroloom
