// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/bundling.h"

#include "core/plan/bundles.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

constexpr const char* mixing = "bundles of that size would mix different yarns";

/// Whether each bundle's yarns are of one type.
bool bundles_are_alike(const Textile& textile, YarnKind kind, const Bundles& bundles)
{
    for (int yarn = 0; yarn < bundles.yarns; ++yarn)
        for (int bundle : {bundles.first_of(yarn), bundles.last_of(yarn)})
            if (textile.type_of(kind, yarn) != textile.type_of(kind, bundles.middle_of(bundle))) return false;
    return true;
}

/// Ends, and picks, of a bundle where only the edges differ from the rest: as many as leave some bundles between.
int wanted_where_even(const Knobs& knobs, const Textile& textile)
{
    constexpr int least_bundles = 8;
    return std::min(static_cast<int>(knobs.crossings_per_even_cell), std::min(textile.ends(), textile.picks()) / least_bundles);
}

/// Ends, and picks, that the fidelity puts into a bundle.
int wanted_in_bundle(const Knobs& knobs, const Textile& textile, ExperimentType type)
{
    const int at_fronts = static_cast<int>(knobs.crossings_per_cell);
    return stays_uniform(type) ? std::max(at_fronts, wanted_where_even(knobs, textile)) : at_fronts;
}

/// Why each yarn is simulated alone whatever the fidelity asks for; nullptr: it need not be.
const char* why_single(const ModelPlan& plan, const Textile& textile, ExperimentType type)
{
    if (plan.on("wicking") && (textile.face_angle || textile.back_angle)) return "a finish lies on one face";
    if (plan.on("liquid") && !plan.on("cap")) return "free liquid meets single yarns";
    return info_of(type).source == WaterSource::face ? "sweat wets yarns where they lie on one face" : nullptr;
}

/// Why frames cannot show cells of several yarns; empty: they can.
const char* why_not_in_cells(const Textile& textile, ExperimentType type)
{
    if (textile.warp.types.size() + textile.weft.types.size() > 2) return "its yarns are of several types";
    if (is_strip(type)) return "how high a strip is wet is read on single yarns";
    if (uses_field(type, "feed_s")) return "the tester's pins stand on single yarns";
    return "";
}

} // namespace

std::string decide_bundles(ModelPlan& plan, const Textile& textile, ExperimentType type)
{
    const int wanted = wanted_in_bundle(plan.knobs, textile, type);
    plan.crossings_per_cell = 1;
    plan.whole_bundles = false;
    if (wanted <= 1) return "";
    const bool whole = wets_a_spot(type);
    const auto alike = [&](int of) {
        return bundles_are_alike(textile, YarnKind::warp, bundles_of(textile.ends(), {of, whole})) &&
               bundles_are_alike(textile, YarnKind::weft, bundles_of(textile.picks(), {of, whole}));
    };
    int most = wanted;
    while (most > 1 && !alike(most)) --most;
    const char* why_not = why_single(plan, textile, type);
    if (!why_not && most == 1) why_not = mixing;
    if (why_not)
        return fmt::format(" Each crossing stays a cell of its own, although the fidelity would put {} ends and picks into one: {}.",
                           wanted, why_not);
    plan.crossings_per_cell = most;
    plan.whole_bundles = whole;
    const Bundles ends = bundles_of(textile.ends(), plan.bundling()), picks = bundles_of(textile.picks(), plan.bundling());
    return fmt::format(" The {} ends and {} picks are simulated as {} and {} bundles; what a frame shows of a yarn is its bundle's.",
                       ends.yarns, picks.yarns, ends.count, picks.count);
}

void decide_shown_cells(ModelPlan& plan, const Textile& textile, ExperimentType type, double side)
{
    constexpr double most_unasked = 500'000; // cells
    constexpr double most_yarns = 64;        // of each system in a cell, which one thread of a GPU sums up
    plan.shown_ends = plan.shown_picks = 0;
    plan.not_in_cells.clear();
    const double crossings = double(textile.ends()) * textile.picks();
    const double wanted = std::min(most_yarns, side > 0 ? std::round(side / std::sqrt(textile.warp.pitch * textile.weft.pitch))
                                                        : std::ceil(std::sqrt(crossings / most_unasked)));
    if (wanted <= 1) return;
    plan.not_in_cells = why_not_in_cells(textile, type);
    if (!plan.not_in_cells.empty()) return;
    const auto cells = [&](int yarns) {
        const int simulated = bundles_of(yarns, plan.bundling()).count;
        return std::min(simulated, std::max(1, static_cast<int>(std::lround(yarns / wanted))));
    };
    plan.shown_ends = cells(textile.ends());
    plan.shown_picks = cells(textile.picks());
}

void find_idle_bundle_knobs(ModelPlan& plan, const Textile& textile, ExperimentType type)
{
    auto &at_fronts = plan.idle_knobs["crossings_per_cell"], &where_even = plan.idle_knobs["crossings_per_even_cell"];
    const double fronts = plan.knobs.crossings_per_cell, even = wanted_where_even(plan.knobs, textile);
    if (const char* why = why_single(plan, textile, type))
        at_fronts = where_even = why;
    else if (!stays_uniform(type))
        where_even = "only in drying and conditioning is all of the cloth alike";
    else if (wanted_in_bundle(plan.knobs, textile, type) > 1 && plan.crossings_per_cell == 1)
        at_fronts = where_even = mixing;
    else if (fronts < even)
        at_fronts = "crossings_per_even_cell sets larger bundles";
    else if (plan.knobs.crossings_per_even_cell > 1 && even <= 1)
        where_even = "the sample has too few yarns for bundles";
    else if (even < fronts)
        where_even = "crossings_per_cell sets larger bundles";
}

} // namespace hygroloom
