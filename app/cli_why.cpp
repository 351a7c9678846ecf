// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_why.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

const Candidate& candidate_named(const Comparison& comparison, const std::string& fabric)
{
    return *std::find_if(comparison.candidates.begin(), comparison.candidates.end(),
                         [&](const Candidate& candidate) { return candidate.fabric == fabric; });
}

} // namespace

void find_why(Comparison& comparison, const WhyPlan& plan, const Design& design, const RunOptions& how, bool quiet, RunQueue& queue,
              const std::shared_ptr<RunPlaces>& places, const std::atomic<bool>& cancel)
{
    const Candidate &fabric = candidate_named(comparison, plan.fabric), &against = candidate_named(comparison, plan.against);
    const Why first = why_of(plan, comparison.ranked_by, fabric, against, comparison.replicates);
    if (!first.nothing.empty()) {
        comparison.why = std::make_shared<const Why>(first);
        return;
    }
    const std::vector<Mixture> all(plan.mixtures.begin(), plan.mixtures.end());
    const std::size_t count = all.size() * static_cast<std::size_t>(comparison.replicates);
    if (!quiet && count > 0) print_note("Why: {} runs of mixtures of {} and {}.\n", count, plan.fabric, plan.against);
    std::map<Mixture, Candidate> mixtures;
    std::size_t done = 0;
    RunBar bar(quiet, std::max<std::size_t>(count, 1));
    RunBatch batch;
    batch.count = count;
    batch.places = places;
    batch.job = [&](std::size_t i) {
        RunJob job{std::make_shared<const Design>(mixed(design, plan, all[i % all.size()])), plan.experiment, plan.fabric};
        job.how = how;
        job.how.recording.clear();
        job.replicate = static_cast<int>(i / all.size());
        job.replicates = comparison.replicates;
        job.beside = shown_in(bar, i, plan.fabric);
        return job;
    };
    batch.ended = [&](std::size_t i, RunResult& result) {
        bar.end(i);
        if (!result.ended() && result.failure().empty()) return;
        const auto replicate = static_cast<int>(i / all.size());
        add_replicate(mixtures[all[i % all.size()]], candidate_of(plan.fabric, replicate, result), replicate);
        ++done;
    };
    queue.run(std::move(batch), cancel);
    bar.clear();
    if (done < count) {
        if (!quiet) print_note("Why: cancelled after {} of {} runs of mixtures.\n", done, count);
        return;
    }
    comparison.why = std::make_shared<const Why>(explain(plan, comparison.ranked_by, fabric, against, mixtures, comparison.replicates));
}

std::vector<Textile> textiles_of_mixtures(const Design& design, const WhyPlan& plan)
{
    std::vector<Textile> textiles;
    for (const Mixture mixture : plan.mixtures) {
        const Design own = mixed(design, plan, mixture);
        textiles.push_back(textile_of_run(own, own.fabrics.front(), own.experiments.front()));
    }
    return textiles;
}

} // namespace hygroloom
