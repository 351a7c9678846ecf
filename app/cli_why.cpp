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

/// One replicate of a mixture.
struct MixtureJob {
    Mixture mixture = 0;
    int number = 0;
    Job job;
};

std::vector<MixtureJob> jobs_of(const Design& design, const WhyPlan& plan, const RunOptions& how, int replicates)
{
    std::vector<MixtureJob> jobs;
    for (int number = 0; number < replicates; ++number)
        for (const Mixture mixture : plan.mixtures) {
            MixtureJob one{
                mixture,
                number,
                {drawn(mixed(design, plan, mixture), plan.fabric, plan.experiment, {how.seed, number, replicates}), plan.fabric, how}};
            one.job.how.seed = one.job.drawn.seed;
            one.job.how.recording.clear();
            jobs.push_back(std::move(one));
        }
    return jobs;
}

CandidateRun run_of(const MixtureJob& one, const std::string& experiment, std::mutex& one_on_cpu, Backend& backend, RunControl& control,
                    RunBar& bar, std::size_t i)
{
    try {
        RunOptions how = one.job.how;
        how.one_on_cpu = &one_on_cpu;
        return candidate_of(one.job, run_with_bar(one.job.drawn.design, one.job.fabric, experiment, how, backend, control, bar, i));
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        CandidateRun failed;
        failed.candidate.fabric = one.job.fabric;
        failed.candidate.failure = error.what();
        return failed;
    }
}

} // namespace

void find_why(Comparison& comparison, const WhyPlan& plan, const Design& design, const RunOptions& how, bool quiet,
              const std::vector<std::unique_ptr<Backend>>& backends, RunControl& control)
{
    const Candidate &fabric = candidate_named(comparison, plan.fabric), &against = candidate_named(comparison, plan.against);
    const Why first = why_of(plan, comparison.ranked_by, fabric, against, comparison.replicates);
    if (!first.nothing.empty()) {
        comparison.why = std::make_shared<const Why>(first);
        return;
    }
    const std::vector<MixtureJob> jobs = jobs_of(design, plan, how, comparison.replicates);
    if (!quiet && !jobs.empty()) print_note("Why: {} runs of mixtures of {} and {}.\n", jobs.size(), plan.fabric, plan.against);
    std::map<Mixture, Candidate> mixtures;
    std::mutex mutex, one_on_cpu;
    std::size_t done = 0;
    RunBar bar(quiet, std::max<std::size_t>(jobs.size(), 1));
    run_side_by_side(backends, jobs.size(), control, [&](std::size_t i, Backend& backend) {
        CandidateRun finished = run_of(jobs[i], plan.experiment, one_on_cpu, backend, control, bar, i);
        const std::lock_guard lock(mutex);
        add_replicate(mixtures[jobs[i].mixture], finished.candidate, jobs[i].number);
        ++done;
        bar.end(i);
        return finished.device_failed;
    });
    bar.clear();
    if (done < jobs.size()) {
        if (!quiet) print_note("Why: cancelled after {} of {} runs of mixtures.\n", done, jobs.size());
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
