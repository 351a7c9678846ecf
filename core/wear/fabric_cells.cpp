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

} // namespace

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
    const Textile textile = textile_of_run(design, fabric, experiment, {0, 0, ends + k, picks + k});
    Scene scene = build_scene(design, textile, experiment, plan, 1);
    scene.cloth.pores.clear(); // even yarns
    cells.tile = k > 1 ? coarsened(scene, k) : std::move(scene);
    cells.ends = ends / k;
    cells.picks = picks / k;
    cells.end_pitch = k * warp_pitch;
    cells.pick_pitch = k * weft_pitch;
    return cells;
}

} // namespace hygroloom
