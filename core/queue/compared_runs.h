// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Many runs for one answer: fabrics or garments on the same experiment, each as often as it has replicates.
#pragma once

#include "core/analysis/comparison.h"
#include "core/queue/run_queue.h"

namespace hygroloom {

/// A candidate of a comparison.
struct NamedJob {
    std::string name; ///< of the fabric, or of the project
    RunJob job;       ///< replicate 0, which alone is recorded
};

/// Of fabrics on an experiment of samples. textiles: theirs, in their order, see textiles_of_runs().
std::vector<NamedJob> jobs_of(const Design& design, const std::vector<std::string>& fabrics, const std::string& experiment,
                              const std::vector<Textile>& textiles, const RunOptions& how);

/// What a run gave as its replicate, without the run's textile but for its quantities. What reports need of a garment is kept of
/// replicate 0 alone. Takes the run.
Candidate candidate_of(const std::string& name, int replicate, RunResult& result);

/// How a comparison's runs are followed. Run i is replicate i / candidates of candidate i % candidates.
struct ComparedWatch {
    std::function<void(std::size_t, RunJob&)> begins = {};        ///< from its thread: it may add its callbacks
    std::function<void(std::size_t, const RunResult&)> came = {}; ///< one that came to its end, before it is judged
    std::function<void(std::size_t)> ended = {};                  ///< any, after it was judged; never two at a time
    std::function<void(bool)> paused = {};                        ///< see RunBatch
    std::function<double()> room = {};                            ///< see RunBatch
};

/// Runs every candidate as often as the comparison has replicates: all have their first before one has its second. An Error in a run
/// concerns that run alone. After each the comparison is judged anew. Throws what the watch throws; runs that were stopped are left out.
void run_comparison(Comparison& comparison, const std::vector<NamedJob>& candidates, RunQueue& queue,
                    const std::shared_ptr<RunPlaces>& places, const std::atomic<bool>& cancel, const ComparedWatch& watch = {});

} // namespace hygroloom
