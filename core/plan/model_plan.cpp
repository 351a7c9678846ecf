// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/model_plan.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/plan/bundles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr const char* part_names[] = {"liquid", "wicking", "sorption", "vapour", "heat", "growth"};

} // namespace

bool ModelPlan::on(const std::string& part) const
{
    return std::any_of(parts.begin(), parts.end(), [&](const PlannedPart& p) { return p.name == part && p.on; });
}

bool ModelPlan::watches(const std::string& part) const
{
    return std::any_of(parts.begin(), parts.end(), [&](const PlannedPart& p) { return p.name == part && p.watched; });
}

std::vector<std::string> notes_of(const ModelPlan& plan)
{
    std::vector<std::string> notes;
    if (plan.crossings_per_cell > 1)
        notes.push_back(fmt::format("Yarns side by side went in bundles: {} ends and {} picks as {} and {}.", plan.region.ends,
                                    plan.region.picks, bundles_of(plan.region.ends, plan.bundling()).count,
                                    bundles_of(plan.region.picks, plan.bundling()).count));
    if (plan.shown_ends > 0)
        notes.push_back(fmt::format("Frames, maps and the recording show the sample in {} by {} cells, of about {:.3g} by {:.3g} yarns.",
                                    plan.shown_ends, plan.shown_picks, double(plan.region.ends) / plan.shown_ends,
                                    double(plan.region.picks) / plan.shown_picks));
    if (!plan.not_in_cells.empty())
        notes.push_back(fmt::format("Frames, maps and the recording show each crossing of the sample, not cells: {}.", plan.not_in_cells));
    const SceneCounts& scene = plan.counts;
    if (plan.on("wicking") && scene.closure == name_of(Closure::pores) && scene.suction > 0 && scene.uptake <= 0)
        notes.push_back(
            fmt::format("Dry yarns take no liquid in: at a contact angle of {:.3g} degrees it does not run between their fibres.",
                        std::acos(scene.suction) * 180.0 / pi));
    for (const KnobInfo* knob : changed_knobs(knobs_of(plan.fidelity), plan.knobs))
        if (const auto idle = plan.idle_knobs.find(knob->name); idle != plan.idle_knobs.end())
            notes.push_back(fmt::format("{} was set and had no effect: {}.", knob->name, idle->second));
    return notes;
}

ModelPlan with_part(ModelPlan plan, const std::string& part)
{
    for (PlannedPart& planned : plan.parts)
        if (planned.name == part) planned.on = true;
    if (part == "sorption") plan.fibre_shells = static_cast<int>(plan.knobs.fibre_shells);
    return plan;
}

ForcedParts parse_forced_parts(const std::string& text)
{
    ForcedParts forced;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const std::string item = text.substr(at, comma - at);
        at = comma + 1;
        const std::size_t equals = std::min(item.find('='), item.size());
        const std::string name = item.substr(0, equals), value = equals < item.size() ? item.substr(equals + 1) : "";
        if (std::find(std::begin(part_names), std::end(part_names), name) == std::end(part_names) || (value != "on" && value != "off"))
            throw Error("Each part of the physics is given as name=on or name=off, with the names liquid, wicking, sorption, vapour, heat "
                        "and growth; \"" +
                        item + "\" was given.");
        forced[name] = value == "on";
    }
    return forced;
}

} // namespace hygroloom
