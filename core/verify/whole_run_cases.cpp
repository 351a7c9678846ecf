// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whole runs: what must stay, stays; and every machine computes the same.
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/sim/runner.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <algorithm>

namespace hygroloom {
namespace {

/// Textile F of the paper with one drop.
Design drop_on_cotton(double volume, double duration, double contact_angle)
{
    Design design;
    Fabric fabric;
    fabric.name = "cotton";
    fabric.warp.diameter_mm = fabric.weft.diameter_mm = 0.2;
    fabric.ends_per_cm = fabric.picks_per_cm = 35;
    fabric.contact_angle_deg = contact_angle;
    design.fabrics.push_back(fabric);
    Experiment experiment;
    experiment.name = "drop";
    experiment.duration_s = duration;
    experiment.sample_mm = {12, 12};
    experiment.droplets[0].volume_ul = volume;
    design.experiments.push_back(experiment);
    return design;
}

std::vector<VerifyResult> conservation(const VerifyValues& v, Backend& backend)
{
    const Design design = drop_on_cotton(v.at("volume_ul").value, v.at("duration_s").value, v.at("contact_angle_deg").value);
    RunOptions options;
    options.fidelity = Fidelity::draft;
    options.forced = {{"vapour", true}, {"heat", true}, {"sorption", true}};
    RunControl control;
    double mass = 0, energy = 0;
    RunCallbacks callbacks;
    callbacks.frame = [&](std::shared_ptr<const Frame> frame) {
        const Ledger& l = frame->ledger;
        if (l.water_delivered <= 0) return;
        mass = std::max(mass, std::abs(l.water_imbalance()) / l.water_delivered);
        energy = std::max(energy, std::abs(l.energy_imbalance()) / std::max(1e-12, std::abs(l.energy_released)));
    };
    run_experiment(design, "cotton", "drop", options, backend, control, callbacks);
    return {{"mass_drift", mass, 0, 1e-9}, {"energy_drift", energy, 0, 1e-9}};
}

/// Greatest difference of a field over its greatest value.
double difference(const std::vector<float>& a, const std::vector<float>& b)
{
    double largest = 1e-30, apart = 0;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<double>(b[i])));
        apart = std::max(apart, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    }
    return a.size() == b.size() ? apart / largest : 1.0;
}

/// The yarn network alone: a wet spot wicks, sorbs, dries and cools on 37 x 41 crossings (odd, more than a block).
Scene wet_spot()
{
    const Design design = drop_on_cotton(1, 1, 35);
    const Textile textile = build_textile(design, design.fabrics[0], {0, 0, 37, 41});
    ModelPlan plan;
    for (const char* part : {"wicking", "sorption", "vapour", "heat"}) plan.parts.push_back({part, true, false, ""});
    plan.fibre_shells = 6;
    plan.network_step_limit = 5e-3;
    plan.saturation_change = 0.1;
    Scene scene = build_scene(design, textile, design.experiments[0], plan, 1);
    scene.initial_liquid.assign(static_cast<std::size_t>(scene.segments()), 0.0);
    for (int end = 12; end < 25; ++end)
        for (int pick = 14; pick < 27; ++pick) {
            const auto i = static_cast<std::size_t>(textile.segment(YarnKind::warp, end, pick));
            scene.initial_liquid[i] = 0.9 * scene.climate.density * scene.yarns[0].pore_area * scene.length[i];
        }
    return scene;
}

/// The wet spot on yarns that pass nothing to each other, in steps of the same length whatever they are.
Scene wet_spot_on_lone_yarns()
{
    Scene scene = wet_spot();
    scene.crossing.assign(1, {});
    scene.saturation_change = 1e3;
    return scene;
}

/// The same on coarser, slower yarns that take up more.
Scene wet_spot_on_coarse_yarns()
{
    Scene scene = wet_spot_on_lone_yarns();
    for (YarnParameters& yarn : scene.yarns) {
        yarn.pore_area *= 1.5;
        yarn.fibre_radius *= 2;
        yarn.fibre_specific_heat *= 0.8;
        yarn.liquid_diffusivity *= 0.3;
        yarn.vapour_diffusivity *= 0.6;
        yarn.isotherm.saturation_regain *= 1.2;
    }
    return scene;
}

/// Stripes of two yarns, three ends or two picks wide: every yarn must do what it does among its own kind.
std::vector<VerifyResult> mixed_yarns(const VerifyValues&, Backend& backend)
{
    const Scene fine = wet_spot_on_lone_yarns(), coarse = wet_spot_on_coarse_yarns();
    Scene mixed = fine;
    mixed.warp_types = 2;
    mixed.yarns = {fine.yarns[0], coarse.yarns[0], fine.yarns[1], coarse.yarns[1]};
    mixed.shapes = {fine.shapes[0], fine.shapes[0], fine.shapes[1], fine.shapes[1]};
    mixed.crossing.assign(4, {});
    for (int end = 0; end < mixed.ends; ++end) mixed.type[static_cast<std::size_t>(end)] = end / 3 % 2 == 1;
    for (int pick = 0; pick < mixed.picks; ++pick) mixed.type[static_cast<std::size_t>(mixed.ends + pick)] = pick / 2 % 2 == 1 ? 3 : 2;

    const std::vector<double> times{0.2};
    const Frame of_fine = frames_at(backend, fine, times).back(), of_coarse = frames_at(backend, coarse, times).back();
    const Frame here = frames_at(backend, mixed, times).back();
    std::vector<VerifyResult> results;
    for (const auto& [name, field] : {std::pair{"saturation", &Frame::saturation}, std::pair{"regain", &Frame::regain},
                                      std::pair{"vapour", &Frame::vapour}, std::pair{"temperature", &Frame::temperature}}) {
        std::vector<float> expected = of_fine.*field;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const int segment = static_cast<int>(i), weft = segment - mixed.crossings();
            const int line = weft < 0 ? segment / mixed.picks : mixed.ends + weft / mixed.ends;
            if (mixed.type[static_cast<std::size_t>(line)] % 2 == 1) expected[i] = (of_coarse.*field)[i];
        }
        results.push_back({name, difference(here.*field, expected), 0, 0});
    }
    return results;
}

/// The liquid alone: a drop in the air falls and settles into its shape for a few steps.
Scene falling_drop(int particles)
{
    Scene scene = bare_scene(20, 20, 3e-4, 293.15);
    scene.particles_per_droplet = particles;
    scene.droplets.push_back({0, 5e-9, {1e-4, -2e-4, 3e-3}, 0.2});
    scene.network_step = 1.0;
    return scene;
}

std::vector<VerifyResult> backends_agree(const VerifyValues&, Backend& backend)
{
    const auto reference = make_cpu_backend();
    reference->set_threads(1);
    const std::vector<double> times{0.05, 0.2};
    const Frame here = frames_at(backend, wet_spot(), times).back(), there = frames_at(*reference, wet_spot(), times).back();
    std::vector<VerifyResult> results{
        {"network_saturation", difference(here.saturation, there.saturation), 0, 1e-6},
        {"network_regain", difference(here.regain, there.regain), 0, 1e-6},
        {"network_vapour", difference(here.vapour, there.vapour), 0, 1e-6},
        {"network_temperature", difference(here.temperature, there.temperature), 0, 1e-6},
    };
    // Single precision: the sines and roots of two machines differ in the last bit, and a step carries that on.
    const Scene drop = falling_drop(1003);
    const std::vector<double> moments{1e-4};
    const Frame a = frames_at(backend, drop, moments).back(), b = frames_at(*reference, drop, moments).back();
    double apart = a.positions.size() == b.positions.size() ? 0.0 : 1.0;
    for (std::size_t i = 0; i < a.positions.size() && i < b.positions.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) apart = std::max(apart, static_cast<double>(std::abs(a.positions[i][k] - b.positions[i][k])));
    results.push_back({"drop_position_mm", 1e3 * apart, 0, 1e-5});
    return results;
}

} // namespace

std::vector<VerifyCase> whole_run_cases()
{
    return {
        {"conservation",
         "A drop on Textile F with all physics: drift of mass over the water delivered, and of energy over the heat released.",
         {{"volume_ul", 3, 1e-3, 100, ""}, {"duration_s", 1, 1e-3, 1e3, ""}, {"contact_angle_deg", 35, 0, 180, ""}},
         conservation},
        {"mixed_yarns",
         "A wet spot on stripes of two yarns that pass nothing to each other: every yarn against a cloth of its own kind, exactly.",
         {},
         mixed_yarns},
        {"backends_agree", "The yarn network and a drop in the air on this backend against one thread of the CPU.", {}, backends_agree},
    };
}

} // namespace hygroloom
