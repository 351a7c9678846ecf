// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/cli_replicates.h"

namespace hygroloom {

std::vector<Job> jobs_of(const Design& design, const std::vector<std::string>& fabrics, const std::string& experiment,
                         const std::vector<Textile>& textiles, const RunOptions& how, int replicates)
{
    std::vector<Job> jobs;
    for (int number = 0; number < replicates; ++number)
        for (std::size_t f = 0; f < fabrics.size(); ++f) {
            Job job{drawn(design, fabrics[f], experiment, {how.seed, number, replicates}), fabrics[f], how};
            job.how.seed = job.drawn.seed;
            if (number > 0) job.how.recording.clear();
            if (replicates == 1) job.how.textile = std::make_shared<const Textile>(textiles[f]);
            jobs.push_back(std::move(job));
        }
    return jobs;
}

CandidateRun candidate_of(const Job& job, FinishedRun finished)
{
    finished.run.textile = {};
    CandidateRun run{candidate_of(std::make_shared<const RunRecord>(std::move(finished.run)),
                                  std::make_shared<const Metrics>(std::move(finished.metrics))),
                     !finished.device_failure.empty()};
    run.candidate.replicates.front()->places = job.drawn.places;
    run.candidate.unknowns = job.drawn.names;
    if (run.device_failed) run.candidate.notes.push_back(finished.device_failure);
    return run;
}

void add_replicates_option(CLI::App& verb, int& replicates, const std::string& whose)
{
    verb.add_option(
            "--replicates", replicates,
            "Runs" + whose +
                "; 1: the cloth as given. Of more all have yarns as uneven as is typical, and all but the first inputs drawn within "
                "what is not known of them")
        ->check(CLI::Range(1, 1000));
}

} // namespace hygroloom
