// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/queue/card_runs.h"

#include "core/analysis/replicate_file.h"
#include "core/base/error.h"
#include "core/design/looks.h"
#include "core/design/validate.h"
#include "core/run/recording.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

/// What the test's run depends on. Throws Error where it cannot be run.
Design design_of(Design design, const Fabric& fabric, const CardTest& test)
{
    design.experiments = {test.experiment};
    Design alone = part_of_run(design, fabric.name, test.experiment.name);
    const std::vector<Issue> issues = validate(alone);
    if (const Issue* error = first_error(issues)) throw Error(error->text());
    return alone;
}

/// Whether a run has nothing but the fidelity's own plan.
bool is_plain(const RunRecord& run)
{
    return std::none_of(run.plan.parts.begin(), run.plan.parts.end(), [](const PlannedPart& part) { return part.forced; });
}

std::optional<Candidate> kept_in(const std::filesystem::path& file, const Design& design, const RunOptions& how)
{
    Recording recording(file);
    const RunRecord& run = recording.run();
    if (!recording.finished() || run.plan.fidelity < how.fidelity || without_look(run.design) != without_look(design)) return {};
    if (run.answers != answers_code || run.seed != how.seed || !is_plain(run)) return {};
    MetricsCollector collector;
    collector.start(recording.run());
    recording.read_frames([&](const Frame& frame) {
        collector.add(frame);
        return true;
    });
    if (!recording.problems().empty()) return {};
    return candidate_of(std::make_shared<const RunRecord>(recording.run()), std::make_shared<const Metrics>(collector.metrics()));
}

/// A test's recordings in a folder, by number: "drying.hygrorec", "drying-2.hygrorec".
std::filesystem::path recording_of(const std::filesystem::path& folder, const std::string& test, int number)
{
    return folder / (number == 1 ? test + ".hygrorec" : fmt::format("{}-{}.hygrorec", test, number));
}

/// The first that stands for a run; else the path that is still free. What cannot be read is left as it is.
std::pair<std::optional<Candidate>, std::filesystem::path> look_for_kept(const CardRuns& what, const std::string& test,
                                                                         const Design& design)
{
    const bool may_stand = what.replicates == 1 && what.how.forced.empty() && what.how.knobs.empty();
    for (int number = 1;; ++number) {
        const std::filesystem::path file = recording_of(what.kept, test, number);
        if (!std::filesystem::exists(file)) return {std::nullopt, file};
        if (!may_stand) continue;
        try {
            if (auto kept = kept_in(file, design, what.how)) return {std::move(kept), file};
        } catch (const Error&) { // of another program, or spoilt
        }
    }
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
    if (!what.kept.empty()) std::filesystem::create_directories(what.kept);
    for (const std::string& key : what.tests) {
        try {
            CardTest test = card_test(key, fabric, known.found);
            const auto alone = std::make_shared<const Design>(design_of(design, fabric, test));
            NamedJob job{key, {alone, key, fabric.name, {}, what.how}};
            if (!what.kept.empty()) {
                auto [kept, file] = look_for_kept(what, key, *alone);
                job.job.how.recording = file;
                if (kept) {
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
