// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/queue/compared_runs.h"

#include "core/wear/worn_candidate.h"

namespace hygroloom {
namespace {

Candidate of_sample(FinishedRun& finished)
{
    Textile described; // reports give what follows from its description
    described.quantities = std::move(finished.run.textile.quantities);
    finished.run.textile = std::move(described);
    return candidate_of(std::make_shared<const RunRecord>(std::move(finished.run)),
                        std::make_shared<const Metrics>(std::move(finished.metrics)));
}

Candidate of_garment(const FinishedGarment& finished, int replicate, bool drawn)
{
    Candidate made = candidate_of(*finished.record, *finished.metrics, finished.wall);
    if (drawn) add_error_of_cells(made);
    if (replicate == 0)
        made.notes = finished.issues;
    else
        made.worn.reset();
    return made;
}

} // namespace

std::vector<NamedJob> jobs_of(const Design& design, const std::vector<std::string>& fabrics, const std::string& experiment,
                              const std::vector<Textile>& textiles, const RunOptions& how)
{
    const auto shared = std::make_shared<const Design>(design);
    std::vector<NamedJob> jobs;
    for (std::size_t i = 0; i < fabrics.size(); ++i) {
        jobs.push_back({fabrics[i], {shared, experiment, fabrics[i]}});
        jobs.back().job.how = how;
        jobs.back().job.how.textile = std::make_shared<const Textile>(textiles[i]);
    }
    return jobs;
}

Candidate candidate_of(const std::string& name, int replicate, RunResult& result)
try {
    if (result.error) std::rethrow_exception(result.error);
    const std::string device_failure = result.device_failure();
    Candidate made = result.garment ? of_garment(*result.garment, replicate, !result.drawn.names.empty()) : of_sample(*result.sample);
    made.fabric = name;
    made.unknowns = result.drawn.names;
    made.replicates.front()->places = result.drawn.places;
    if (!device_failure.empty()) made.notes.push_back(device_failure);
    return made;
} catch (const std::exception& error) {
    Candidate failed;
    failed.fabric = name;
    failed.failure = result.error ? result.failure() : error.what();
    return failed;
}

void run_comparison(Comparison& comparison, const std::vector<NamedJob>& candidates, RunQueue& queue,
                    const std::shared_ptr<RunPlaces>& places, const std::atomic<bool>& cancel, const ComparedWatch& watch)
{
    std::vector<std::optional<Candidate>> known(candidates.size());
    const std::size_t all = candidates.size() * static_cast<std::size_t>(comparison.replicates);
    std::size_t done = 0;
    RunBatch batch;
    batch.name = comparison.experiment;
    batch.count = all;
    batch.places = places;
    batch.paused = watch.paused;
    batch.room = watch.room;
    batch.job = [&](std::size_t i) {
        RunJob job = candidates[i % candidates.size()].job;
        job.replicate = static_cast<int>(i / candidates.size());
        job.replicates = comparison.replicates;
        if (job.replicate > 0) job.how.recording.clear();
        if (watch.begins) watch.begins(i, job);
        return job;
    };
    batch.ended = [&](std::size_t i, RunResult& result) {
        if (!result.ended() && result.failure().empty()) return;
        if (result.ended() && watch.came) watch.came(i, result);
        const auto replicate = static_cast<int>(i / candidates.size());
        auto& candidate = known[i % candidates.size()];
        if (!candidate) candidate.emplace();
        add_replicate(*candidate, candidate_of(candidates[i % candidates.size()].name, replicate, result), replicate);
        comparison.candidates.clear();
        for (const auto& each : known)
            if (each) comparison.candidates.push_back(*each);
        comparison.complete = ++done == all;
        judge(comparison);
        if (watch.ended) watch.ended(i);
    };
    queue.run(batch, cancel);
}

} // namespace hygroloom
