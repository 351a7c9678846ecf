// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/garment_jobs.h"

#include "core/base/error.h"
#include "core/wear/wear_outcomes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hygroloom {
namespace {

/// One run of a candidate's replicate.
struct GarmentJob {
    Drawn drawn;
    GarmentRunOptions how;
};

std::vector<GarmentJob> jobs_of(const std::vector<GarmentCandidate>& candidates, const GarmentRunOptions& how, std::uint64_t seed,
                                int replicates)
{
    std::vector<GarmentJob> jobs;
    for (int number = 0; number < replicates; ++number)
        for (const GarmentCandidate& candidate : candidates) {
            const WearExperiment& wear = *find_wear(candidate.design, candidate.experiment);
            const std::vector<std::string> fabrics = fabrics_of(*find_garment(candidate.design, wear.garment));
            jobs.push_back({drawn(candidate.design, fabrics, {seed, number, replicates}), how});
            if (number > 0) jobs.back().how.recording.clear();
        }
    return jobs;
}

/// Of any number, at least: cells of 10 in place of 40 mm moved areas of a tee by 1.3 %, water by 1 %.
constexpr double error_of_cells = 0.02;

/// first: what reports need is kept.
CandidateRun candidate_of(const GarmentCandidate& candidate, const Drawn& drawn, const FinishedGarment& finished, bool first)
{
    CandidateRun run;
    Candidate& made = run.candidate;
    made = candidate_of(*finished.record, *finished.metrics, finished.wall);
    made.fabric = candidate.name;
    if (!drawn.names.empty()) add_error_of_cells(made);
    made.unknowns = drawn.names;
    made.replicates.front()->places = drawn.places;
    if (!first) made.worn.reset();
    if (first) made.notes = finished.issues;
    run.device_failed = !finished.device_failure.empty();
    if (run.device_failed) made.notes.push_back(finished.device_failure);
    return run;
}

} // namespace

GarmentCandidate cut_from(const Design& design, const std::string& experiment, const std::filesystem::path& base, const std::string& fabric)
{
    GarmentCandidate made{fabric, design, experiment, base};
    const std::string& garment = find_wear(design, experiment)->garment;
    for (Garment& each : made.design.garments)
        if (each.name == garment) cut_all_from(each, fabric);
    return made;
}

Design part_of_run(const Design& design, const std::string& experiment)
{
    Design part;
    part.wears.push_back(*find_wear(design, experiment));
    part.garments.push_back(*find_garment(design, part.wears.front().garment));
    part.materials = design.materials;
    for (const std::string& name : fabrics_of(part.garments.front()))
        if (const Fabric* fabric = find_fabric(design, name)) part.fabrics.push_back(*fabric);
    for (const Liquid& liquid : design.liquids)
        if (liquid.name == part.wears.front().liquid) part.liquids.push_back(liquid);
    return part;
}

Design with_absolute_files(Design design, const std::filesystem::path& base)
{
    const std::filesystem::path from = std::filesystem::absolute(base.empty() ? "." : base);
    const auto whole = [&](std::string& file) {
        if (!file.empty()) file = (from / file).lexically_normal().string();
    };
    for (Garment& garment : design.garments) {
        whole(garment.source);
        if (garment.wearer.zones.ends_with(".csv")) whole(garment.wearer.zones);
    }
    for (WearExperiment& wear : design.wears) whole(wear.activity_file);
    return design;
}

Candidate candidate_of(const WearRecord& record, const WearMetrics& metrics, double wall)
{
    const WearExperiment* const found = find_wear(record.design, record.layout.experiment);
    const Garment* const garment = found ? find_garment(record.design, found->garment) : nullptr;
    if (!garment || metrics.all().course.empty())
        throw Error(fmt::format("The run of \"{}\" has no frame, or its project lacks the experiment.", record.layout.experiment));
    const WearExperiment& wear = *found;
    Candidate made;
    made.fabric = one_fabric_of(*garment);
    if (made.fabric.empty()) made.fabric = wear.garment;
    made.outcomes = outcomes_of(metrics);
    made.duration = wear.duration_s;
    made.wall = wall;
    made.timed = 1;
    ReplicateRun numbers;
    for (const Outcome& outcome : made.outcomes)
        if (outcome.value) numbers.numbers[outcome.key] = *outcome.value;
    RunTrace trace;
    trace.series.time = trace_times(wear.duration_s);
    trace.worn = courses_of(metrics, trace.series.time);
    numbers.trace = std::make_shared<const RunTrace>(std::move(trace));
    made.replicates.emplace_back(std::move(numbers));
    made.worn = std::make_shared<const WornCandidate>(WornCandidate{wear_json(metrics), part_of_run(record.design, wear.name),
                                                                    fmt::format("{}, {}", record.fidelity, record.backend), record.device});
    return made;
}

void add_error_of_cells(Candidate& candidate)
{
    for (const Outcome& outcome : candidate.outcomes)
        if (outcome.value) candidate.numerical[outcome.key] = error_of_cells * std::abs(*outcome.value);
}

WearPlan plan_of(const GarmentCandidate& candidate, const WearOptions& how, const std::string& backend)
{
    const WearExperiment& wear = *find_wear(candidate.design, candidate.experiment);
    const GarmentScene scene = garment_scene(garment_parts(candidate.design, wear, candidate.base), resolution_of(how));
    return plan_wear(scene, wear, how.fidelity, backend);
}

std::size_t bytes_of_largest(const std::vector<GarmentCandidate>& candidates, const WearOptions& how)
{
    double most = 0;
    for (const GarmentCandidate& candidate : candidates) most = std::max(most, plan_of(candidate, how, "cpu").bytes);
    return static_cast<std::size_t>(most);
}

std::vector<FinishedGarment> run_comparison(Comparison& comparison, const std::vector<GarmentCandidate>& candidates,
                                            const GarmentRunOptions& how, std::uint64_t seed,
                                            const std::vector<std::unique_ptr<Backend>>& backends, RunControl& control,
                                            const std::function<GarmentRunCallbacks(std::size_t)>& callbacks,
                                            const std::function<void(std::size_t)>& ended)
{
    std::mutex one_on_cpu;
    std::vector<GarmentJob> jobs = jobs_of(candidates, how, seed, comparison.replicates);
    std::vector<FinishedGarment> firsts(candidates.size());
    const auto run = [&](std::size_t i, Backend& backend) {
        const GarmentCandidate& candidate = candidates[i % candidates.size()];
        GarmentJob& job = jobs[i];
        job.how.one_on_cpu = &one_on_cpu;
        const Design& design = job.drawn.design;
        const GarmentParts parts =
            garment_parts(design, *find_wear(design, candidate.experiment), candidate.base, [&control] { return control.cancel.load(); });
        const FinishedGarment finished = run_garment(parts, job.how, backend, control, callbacks(i));
        learn_time(finished);
        if (i < candidates.size()) firsts[i] = finished;
        return candidate_of(candidate, job.drawn, finished, i < candidates.size());
    };
    std::vector<std::string> names;
    for (const GarmentCandidate& candidate : candidates) names.push_back(candidate.name);
    run_comparison(comparison, names, backends, control, run, ended);
    return firsts;
}

} // namespace hygroloom
