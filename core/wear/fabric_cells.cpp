// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/wear/fabric_cells.h"

#include "core/base/units.h"
#include "core/design/wear.h"
#include "core/scene/coarse_scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {
namespace {

constexpr int most_repeat = 1200; // threads of a tile, where weave and cells repeat together after more

/// Threads after which both the weave, or the order of its yarns, and the cells begin anew.
int repeat_of(int weave, std::size_t order, int per_cell)
{
    const auto yarns = static_cast<int>(std::min<std::size_t>(order, most_repeat));
    const long repeat = std::lcm(static_cast<long>(std::lcm(weave, std::max(1, yarns))), static_cast<long>(per_cell));
    return repeat <= most_repeat ? static_cast<int>(repeat) : most_repeat / per_cell * per_cell;
}

/// The scene of a sample on which nothing has happened yet.
Experiment as_sample(const WearExperiment& wear)
{
    constexpr double torso_mm = 300; // that air flows along: about the breadth of a chest; an assumption
    Experiment experiment = standard_experiment(ExperimentType::sweat);
    experiment.climate = wear.climate;
    experiment.liquid = wear.liquid;
    experiment.duration_s = wear.duration_s;
    experiment.sample_mm = {torso_mm, torso_mm};
    experiment.rate_g_m2_h = 0;
    return experiment;
}

/// Two parts of a list, each the other's place.
template <typename Value> void exchange(std::vector<Value>& values, std::size_t first)
{
    std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first), values.end());
}

/// Of each crossing, end x picks + pick.
template <typename Value> std::vector<Value> transposed(const std::vector<Value>& values, int ends, int picks)
{
    std::vector<Value> across;
    across.reserve(values.size());
    const auto along = static_cast<std::size_t>(picks), all = static_cast<std::size_t>(ends) * along;
    for (std::size_t pick = 0; pick < along && !values.empty(); ++pick)
        for (std::size_t at = pick; at < all; at += along) across.push_back(values[at]);
    return across;
}

CrossingParameters turned(CrossingParameters crossing)
{
    std::swap(crossing.warp_rise, crossing.weft_rise);
    BetweenParameters& between = crossing.between;
    std::swap(between.along_warp, between.along_weft);
    std::swap(between.quarters_along_warp, between.quarters_along_weft);
    for (int condition : {0, covered}) std::swap(between.retention[condition + 1], between.retention[condition + 2]);
    std::swap(between.to_warp, between.to_weft);
    const double below = between.on_warp[0];
    between.on_warp[0] = 1 - between.on_warp[1];
    between.on_warp[1] = 1 - below;
    return crossing;
}

} // namespace

FabricCells turned(const FabricCells& cells)
{
    FabricCells made = cells;
    std::swap(made.ends, made.picks);
    std::swap(made.end_pitch, made.pick_pitch);
    made.turned = !cells.turned;
    const Cloth& from = cells.tile.cloth;
    Cloth& cloth = made.tile.cloth;
    const auto ends = static_cast<std::size_t>(from.ends), crossings = static_cast<std::size_t>(from.crossings()),
               warps = static_cast<std::size_t>(from.warp_types), wefts = static_cast<std::size_t>(from.weft_types());
    std::swap(cloth.ends, cloth.picks);
    std::swap(cloth.warp_pitch, cloth.weft_pitch);
    exchange(cloth.length, crossings); // a segment has its place in the order of its line and of its place along that
    if (!cloth.touching.empty()) exchange(cloth.touching, crossings);
    cloth.warp_up = transposed(from.warp_up, from.ends, from.picks);
    for (std::uint8_t& up : cloth.warp_up) up = up == 0 ? 1 : 0;
    cloth.warp_up_share = transposed(from.warp_up_share, from.ends, from.picks);
    for (float& share : cloth.warp_up_share) share = 1 - share;
    exchange(cloth.yarns, warps);
    exchange(cloth.type, ends);
    for (std::uint8_t& type : cloth.type) type = static_cast<std::uint8_t>(type < warps ? type + wefts : type - warps);
    cloth.warp_types = static_cast<int>(wefts);
    cloth.crossing.clear();
    for (std::size_t weft = 0; weft < wefts; ++weft)
        for (std::size_t warp = 0; warp < warps; ++warp) cloth.crossing.push_back(turned(from.crossing[warp * wefts + weft]));
    return made;
}

FabricCells fabric_cells(const Design& design, const Fabric& fabric, const WearExperiment& wear, const Knobs& knobs, double side)
{
    const double warp_pitch = metre_from_mm(10 / fabric.ends_per_cm), weft_pitch = metre_from_mm(10 / fabric.picks_per_cm);
    FabricCells cells;
    cells.crossings_per_cell = std::clamp(static_cast<int>(std::lround(side / std::sqrt(warp_pitch * weft_pitch))), 1, most_repeat / 2);
    const Experiment experiment = as_sample(wear);
    const Textile whole = textile_of_run(design, fabric, experiment, {0, 0, 1, 1});
    const int k = cells.crossings_per_cell;
    const int ends = repeat_of(whole.weave.ends(), whole.warp.order.size(), k),
              picks = repeat_of(whole.weave.picks(), whole.weft.order.size(), k);
    ModelPlan plan;
    plan.knobs = knobs;
    for (const char* part : {"wicking", "sorption", "vapour", "heat"}) plan.parts.push_back({part, true, false, {}});
    plan.fibre_shells = static_cast<int>(knobs.fibre_shells);
    plan.crossings_per_cell = k;
    const auto with_margin = [k](int repeat) { return repeat + (repeat / k % 2 == 0 ? 2 * k : k); }; // an even number of bundles
    const Textile textile = textile_of_run(design, fabric, experiment, {0, 0, with_margin(ends), with_margin(picks)});
    Scene scene = build_scene(design, textile, experiment, plan, 1);
    scene.cloth.pores.clear(); // even yarns
    scene.cloth.room_along.clear();
    cells.tile = k > 1 ? coarsened(scene, {k}) : std::move(scene);
    cells.ends = ends / k;
    cells.picks = picks / k;
    cells.end_pitch = k * warp_pitch;
    cells.pick_pitch = k * weft_pitch;
    return cells;
}

} // namespace hygroloom
