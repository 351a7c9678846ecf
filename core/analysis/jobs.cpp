// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/jobs.h"

#include <utility>

namespace hygroloom {

std::vector<Textile> textiles_of_runs(const Design& design, const std::vector<std::shared_ptr<const FittedFabric>>& fitted,
                                      const std::vector<std::string>& fabrics, const Experiment& experiment)
{
    std::vector<Textile> textiles;
    for (const std::string& name : fabrics) {
        const Fabric& fabric = *find_fabric(design, name);
        const auto place = static_cast<std::size_t>(&fabric - design.fabrics.data());
        textiles.push_back(textile_of_run(design, fabric, experiment, fitted[place].get()));
    }
    return textiles;
}

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
    Textile described; // reports give what follows from its description
    described.quantities = std::move(finished.run.textile.quantities);
    finished.run.textile = std::move(described);
    CandidateRun run{candidate_of(std::make_shared<const RunRecord>(std::move(finished.run)),
                                  std::make_shared<const Metrics>(std::move(finished.metrics))),
                     !finished.device_failure.empty()};
    run.candidate.replicates.front()->places = job.drawn.places;
    run.candidate.unknowns = job.drawn.names;
    if (run.device_failed) run.candidate.notes.push_back(finished.device_failure);
    return run;
}

} // namespace hygroloom
