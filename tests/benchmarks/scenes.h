// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the benchmarks run: a drop and wet cloth, of textile F of the paper.
#pragma once

#include "core/plan/model_plan.h"
#include "core/project/project_file.h"
#include "core/run/plan_run.h"
#include "core/scene/scene.h"

namespace hygroloom {

constexpr double drop_volume_ul = 15;

/// A falling drop that is not absorbed, on yarns that step only on request.
inline Scene drop_scene(int particles, double height_mm)
{
    Design design = read_project(HYGROLOOM_SOURCE_DIR "/resources/examples/textile-F.hygro");
    design.fabrics[0].contact_angle_deg = 120; // nothing is absorbed: the number of particles stays
    Experiment experiment = standard_experiment(ExperimentType::droplet);
    experiment.closure = Closure::paper;
    experiment.sample_mm = {20, 20};
    experiment.droplets[0].volume_ul = drop_volume_ul;
    experiment.droplets[0].height_mm = height_mm;
    design.experiments = {experiment};
    const ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::reference);
    Scene scene = build_scene(design, build_textile(design, design.fabrics[0], plan.region), design.experiments[0], plan, 1);
    scene.rules.particles_per_droplet = particles;
    scene.rules.sorption = scene.rules.vapour = scene.rules.heat = false;
    scene.rules.network_step = scene.rules.calm_network_step = 1; // the liquid's steps alone
    scene.rules.step_share = 0;
    return scene;
}

inline Design pool_on_textile_f(double sample_mm, double volume_ul)
{
    Design design = read_project(HYGROLOOM_SOURCE_DIR "/resources/examples/textile-F.hygro");
    Experiment experiment = standard_experiment(ExperimentType::moisture_management);
    experiment.name = "pool";
    experiment.closure = Closure::paper; // by saturation, in yarns alone
    experiment.sample_mm = {sample_mm, sample_mm};
    experiment.volume_ul = volume_ul;
    experiment.drop_ul = 0;
    experiment.feed_s = 1;
    design.experiments = {experiment};
    return design;
}

inline Scene scene_of(const Design& design, const ForcedParts& forced)
{
    const ModelPlan plan = plan_run(design, design.fabrics[0], design.experiments[0], Fidelity::draft, forced);
    return build_scene(design, build_textile(design, design.fabrics[0], plan.region), design.experiments[0], plan, 1);
}

/// Doubles of a segment that a step with every part reads or writes at least once: length, pores, flux and uptake; liquid, vapour, warmth,
/// evaporated, released, lost and every shell there and back. Without wicking's partners: length, pores, liquid and flux.
inline double least_bytes(const Scene& scene) { return 8.0 * (scene.rules.vapour ? 4 + 2 * (6 + scene.rules.fibre_shells) : 6); }

/// Every segment wet, steps of one length (wet_cloth_step), each with its exchange with fibres and air.
constexpr double wet_cloth_step = 0.01; // s

inline Scene wet_cloth(double side_mm, bool everything, Closure closure = Closure::paper)
{
    Design design = pool_on_textile_f(side_mm, 1);
    design.experiments[0].closure = closure;
    Scene scene = scene_of(design, {{"growth", false}, {"sorption", everything}, {"vapour", everything}, {"heat", everything}});
    scene.supply.pools.clear();
    scene.rules.step_error = 0;
    scene.rules.network_step = scene.rules.calm_network_step = wet_cloth_step;
    scene.rules.step_share = 0;
    const double pores = scene.cloth.yarns[0].pore_area * scene.climate.density;
    for (std::size_t i = 0; i < static_cast<std::size_t>(scene.cloth.segments()); ++i)
        scene.cloth.start.liquid.push_back((0.2 + 0.3 * static_cast<double>(i % 97) / 97) * pores * scene.cloth.length[i]);
    return scene;
}

} // namespace hygroloom
