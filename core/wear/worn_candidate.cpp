// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/worn_candidate.h"

#include "core/base/error.h"
#include "core/wear/wear_outcomes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Of any number, at least: cells of 10 in place of 40 mm moved areas of a tee by 1.3 %, water by 1 %.
constexpr double error_of_cells = 0.02;

} // namespace

Design cut_from(const Design& design, const std::string& experiment, const std::string& fabric)
{
    Design cut = design;
    const std::string& garment = find_wear(design, experiment)->garment;
    for (Garment& each : cut.garments)
        if (each.name == garment && !fabric.empty()) cut_all_from(each, fabric);
    return cut;
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

WearPlan plan_worn(const Design& design, const std::string& experiment, const std::filesystem::path& base, const RunOptions& how,
                   const std::string& backend)
{
    const WearExperiment& wear = *find_wear(design, experiment);
    return plan_wear(garment_scene(garment_parts(design, wear, base), resolution_of(how)), wear, how.fidelity, backend);
}

} // namespace hygroloom
