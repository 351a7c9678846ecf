// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/sim/scene.h"

#include "core/physics/heat_moisture.h"
#include "core/physics/wicking.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

ClimateParameters make_climate(const Experiment& experiment)
{
    ClimateParameters climate;
    climate.temperature = kelvin_from_celsius(experiment.climate.temperature_c);
    climate.humidity = experiment.climate.relative_humidity;
    climate.vapour = climate.humidity * saturation_concentration(climate.temperature);
    const double sample = metre_from_mm(std::max(experiment.sample_mm[0], experiment.sample_mm[1]));
    const double convection = convective_heat_transfer(experiment.climate.air_speed_m_s, sample);
    climate.heat_transfer = convection + radiative_heat_transfer(climate.temperature);
    climate.mass_transfer = mass_transfer(convection, climate.temperature);
    climate.surface_tension = water_surface_tension(climate.temperature);
    climate.viscosity = water_viscosity(climate.temperature);
    climate.density = water_density(climate.temperature);
    return climate;
}

FibreDiffusivity diffusivity_of(const Material& fibre)
{
    if (!fibre.diffusion.two_stage) return {DiffusionLaw::constant, fibre.diffusion.constant_m2_s};
    return {two_stage_law(fibre) == "wool" ? DiffusionLaw::wool_two_stage : DiffusionLaw::cotton_two_stage, 0};
}

YarnParameters make_yarn(const YarnSystem& system, double crossing_pitch, const ClimateParameters& climate)
{
    const Material& fibre = system.fibre;
    YarnParameters yarn;
    yarn.pore_area = system.area * (1.0 - system.packing);
    yarn.fibre_area = system.area * system.packing;
    yarn.fibre_radius = metre_from_um(fibre.fibre_radius_um);
    yarn.fibre_density = fibre.density_kg_m3;
    yarn.fibre_specific_heat = fibre.specific_heat_j_kgk;
    yarn.fibre_conductivity = fibre.thermal_conductivity_w_mk;
    yarn.isotherm = {fibre.standard_regain, fibre.saturation_regain, fibre.gab.monolayer_regain, fibre.gab.c, fibre.gab.k};
    yarn.diffusivity = diffusivity_of(fibre);
    yarn.exponent = spreading_exponent;
    yarn.liquid_diffusivity =
        saturated_liquid_diffusivity(climate.surface_tension, system.contact_angle, system.pore_radius, climate.viscosity) / system.tortuosity;
    yarn.vapour_diffusivity = vapour_diffusivity(climate.temperature) / system.tortuosity;
    yarn.face_area = system.section.width * crossing_pitch;
    yarn.adhesion = work_of_adhesion(climate.surface_tension, system.contact_angle);
    yarn.initial_regain = yarn.resting_regain = equilibrium_regain(yarn.isotherm, climate.humidity, climate.temperature);
    if (yarn.liquid_diffusivity > 0) {
        yarn.suction_radius = system.pore_radius / std::cos(system.contact_angle);
        // Darcy flow across the fibres from the skin to half-way to the yarn's middle.
        yarn.intake_flux = climate.density * permeability_across(yarn.fibre_radius, system.packing) *
                           capillary_pressure(climate.surface_tension, system.contact_angle, system.pore_radius) /
                           (climate.viscosity * 0.25 * system.section.height);
    }
    return yarn;
}

/// A prism between the two axes, as wide as the yarns overlap: liquid and vapour pass across the fibres of each, half the way in each.
CrossingParameters make_crossing(const Textile& textile, const YarnParameters& warp, const YarnParameters& weft, const ClimateParameters& climate)
{
    const double area = textile.warp.section.width * textile.weft.section.width;
    const double half_warp = 0.5 * textile.warp.section.height, half_weft = 0.5 * textile.weft.section.height;
    const auto in_series = [&](double a, double b) { return a > 0 && b > 0 ? area / (half_warp / a + half_weft / b) : 0.0; };
    // The obstruction of the crossing: how much less permeable a bundle is across its fibres than along them (Gebart).
    const auto across = [](const YarnSystem& system, const YarnParameters& yarn) {
        const double obstruction = permeability_across(yarn.fibre_radius, system.packing) / permeability_along(yarn.fibre_radius, system.packing);
        return yarn.liquid_diffusivity * obstruction * (1.0 - system.packing);
    };
    CrossingParameters crossing;
    crossing.liquid_conductance = climate.density * in_series(across(textile.warp, warp), across(textile.weft, weft));
    crossing.heat_conductance = in_series(mean_conductivity(textile.warp.packing, warp.fibre_conductivity, 0),
                                          mean_conductivity(textile.weft.packing, weft.fibre_conductivity, 0));
    crossing.vapour_conductance =
        in_series(warp.vapour_diffusivity * (1.0 - textile.warp.packing), weft.vapour_diffusivity * (1.0 - textile.weft.packing));
    return crossing;
}

ContactShape make_shape(const YarnSystem& system)
{
    ContactShape shape{system.pitch, system.path.amplitude, 0.5 * system.section.height, 0.5 * system.section.width,
                       static_cast<int>(system.profile.height.size()), {}};
    for (std::size_t i = 0; i < system.profile.height.size(); ++i)
        for (double value : {system.profile.height[i], system.profile.slope[i], system.profile.half_height[i], system.profile.half_width[i]})
            shape.profile.push_back(static_cast<float>(value));
    return shape;
}

std::vector<SceneDroplet> make_droplets(const Textile& textile, const Experiment& experiment)
{
    std::vector<SceneDroplet> droplets;
    for (const Droplet& d : experiment.droplets) {
        SceneDroplet drop;
        drop.time = d.time_s;
        drop.volume = cubic_metre_from_ul(d.volume_ul);
        drop.speed = d.speed_m_s;
        const double radius = std::cbrt(3.0 * drop.volume / (4.0 * pi));
        drop.centre = {metre_from_mm(d.at_mm[0]), metre_from_mm(d.at_mm[1]), textile.half_thickness() + metre_from_mm(d.height_mm) + radius};
        droplets.push_back(drop);
    }
    std::stable_sort(droplets.begin(), droplets.end(), [](const SceneDroplet& a, const SceneDroplet& b) { return a.time < b.time; });
    return droplets;
}

} // namespace

Scene build_scene(const Textile& textile, const Experiment& experiment, const ModelPlan& plan, std::uint64_t seed)
{
    Scene scene;
    scene.ends = textile.ends();
    scene.picks = textile.picks();
    scene.length.resize(static_cast<std::size_t>(scene.segments()));
    scene.warp_up.resize(static_cast<std::size_t>(scene.crossings()));
    for (int end = 0; end < scene.ends; ++end)
        for (int pick = 0; pick < scene.picks; ++pick) {
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
                scene.length[static_cast<std::size_t>(textile.segment(kind, end, pick))] = textile.segment_length(kind, end, pick);
            scene.warp_up[static_cast<std::size_t>(end * scene.picks + pick)] = textile.warp_up(end, pick);
        }
    scene.cell_area = textile.warp.pitch * textile.weft.pitch;
    scene.half_thickness = textile.half_thickness();
    scene.climate = make_climate(experiment);
    scene.warp = make_yarn(textile.warp, textile.weft.pitch, scene.climate);
    scene.weft = make_yarn(textile.weft, textile.warp.pitch, scene.climate);
    scene.crossing = make_crossing(textile, scene.warp, scene.weft, scene.climate);
    scene.warp_shape = make_shape(textile.warp);
    scene.weft_shape = make_shape(textile.weft);
    if (plan.on("liquid")) scene.droplets = make_droplets(textile, experiment);
    scene.particles_per_droplet = plan.particles_per_droplet;
    scene.fibre_shells = plan.fibre_shells;
    scene.wicking = plan.on("wicking");
    scene.sorption = plan.on("sorption");
    scene.vapour = plan.on("vapour");
    scene.heat = plan.on("heat");
    scene.network_step = plan.network_step_limit;
    scene.saturation_change = plan.saturation_change;
    scene.density_tolerance = plan.density_tolerance;
    scene.burst_steps = plan.burst_steps;
    scene.seed = seed;
    return scene;
}

} // namespace hygroloom
