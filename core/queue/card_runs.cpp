// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/queue/card_runs.h"

#include "core/base/error.h"
#include "core/design/validate.h"
#include "core/run/recording.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

/// The fabric alone, with the test.
Design design_of(const Design& design, const Fabric& fabric, const CardTest& test)
{
    Design alone;
    alone.materials = design.materials;
    alone.liquids = design.liquids;
    alone.fabrics = {fabric};
    alone.experiments = {test.experiment};
    return alone;
}

/// Throws Error with the first.
void require_no_error(const Design& design)
{
    for (const Issue& issue : validate(design))
        if (issue.severity == Severity::error) throw Error(issue.text());
}

std::optional<Candidate> kept_run(const std::filesystem::path& file, const Design& design, Fidelity least)
{
    if (!std::filesystem::exists(file)) return {};
    Recording recording(file);
    if (!recording.finished() || recording.run().plan.fidelity < least || recording.run().design != design) return {};
    MetricsCollector collector;
    collector.start(recording.run());
    recording.read_frames([&](const Frame& frame) {
        collector.add(frame);
        return true;
    });
    if (!recording.problems().empty()) return {};
    return candidate_of(std::make_shared<const RunRecord>(recording.run()), std::make_shared<const Metrics>(collector.metrics()));
}

std::string run_text(const Candidate& candidate, int replicates, bool kept)
{
    if (!candidate.run) return {};
    std::string text = fmt::format("{}, {}", name_of(candidate.run->plan.fidelity), candidate.run->backend);
    if (replicates > 1) text += fmt::format(", {} runs", runs_of(candidate));
    return kept ? text + ", kept run" : text;
}

const Candidate* named(const std::vector<Candidate>& candidates, const std::string& name)
{
    for (const Candidate& candidate : candidates)
        if (candidate.fabric == name) return &candidate;
    return nullptr;
}

LaboratoryNumbers numbers_of(const CardJobs& jobs, const std::vector<Candidate>& ran, int replicates)
{
    LaboratoryNumbers numbers = jobs.numbers;
    for (const CardTest& test : jobs.tests) {
        const Candidate *kept = named(jobs.kept, test.key), *own = named(ran, test.key);
        if (const Candidate* any = kept ? kept : own) add_test_numbers(numbers, test, *any, run_text(*any, replicates, kept != nullptr));
    }
    return numbers;
}

} // namespace

CardJobs card_jobs(const Design& design, const Fabric& fabric, const LaboratoryNumbers& known, const CardRuns& what)
{
    CardJobs all;
    all.numbers = known;
    for (const std::string& key : what.tests) {
        try {
            CardTest test = card_test(key, fabric, known.found);
            const auto alone = std::make_shared<const Design>(design_of(design, fabric, test));
            require_no_error(*alone);
            NamedJob job{key, {alone, key, fabric.name, {}, what.how}};
            if (!what.kept.empty()) {
                job.job.how.recording = what.kept / (key + ".hygrorec");
                if (auto kept = what.replicates == 1 ? kept_run(job.job.how.recording, *alone, what.how.fidelity) : std::nullopt) {
                    kept->fabric = key;
                    all.kept.push_back(std::move(*kept));
                }
            }
            if (!named(all.kept, key)) {
                all.bytes = std::max(all.bytes, bytes_of(job.job));
                all.jobs.push_back(std::move(job));
            }
            all.tests.push_back(std::move(test));
        } catch (const Error& error) {
            all.numbers.missing.push_back(fmt::format("The card's test \"{}\" is missing. {}", key, error.what()));
        }
    }
    return all;
}

LaboratoryNumbers run_card_jobs(const CardJobs& jobs, int replicates, RunQueue& queue, const std::shared_ptr<RunPlaces>& places,
                                const std::atomic<bool>& cancel, const ComparedWatch& watch,
                                const std::function<void(const LaboratoryNumbers&)>& numbers)
{
    Comparison comparison;
    comparison.experiment = jobs.jobs.empty() ? std::string() : jobs.jobs.front().job.fabric;
    comparison.replicates = replicates;
    ComparedWatch telling = watch;
    telling.ended = [&](std::size_t i) {
        if (numbers) numbers(numbers_of(jobs, comparison.candidates, replicates));
        if (watch.ended) watch.ended(i);
    };
    run_comparison(comparison, jobs.jobs, queue, places, cancel, telling);
    return numbers_of(jobs, comparison.candidates, replicates);
}

} // namespace hygroloom
