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

YarnParameters make_yarn(const YarnType& type, double crossing_pitch, const ClimateParameters& climate)
{
    const Material& fibre = type.fibre;
    YarnParameters yarn;
    yarn.pore_area = type.area * (1.0 - type.packing);
    yarn.fibre_area = type.area * type.packing;
    yarn.fibre_radius = metre_from_um(fibre.fibre_radius_um);
    yarn.fibre_density = fibre.density_kg_m3;
    yarn.fibre_specific_heat = fibre.specific_heat_j_kgk;
    yarn.fibre_conductivity = fibre.thermal_conductivity_w_mk;
    yarn.isotherm = {fibre.standard_regain, fibre.saturation_regain, fibre.gab.monolayer_regain, fibre.gab.c, fibre.gab.k};
    yarn.diffusivity = diffusivity_of(fibre);
    yarn.exponent = spreading_exponent;
    yarn.liquid_diffusivity =
        saturated_liquid_diffusivity(climate.surface_tension, type.contact_angle, type.pore_radius, climate.viscosity) / type.tortuosity;
    yarn.vapour_diffusivity = vapour_diffusivity(climate.temperature) / type.tortuosity;
    yarn.face_area = type.section.width * crossing_pitch;
    yarn.adhesion = work_of_adhesion(climate.surface_tension, type.contact_angle);
    yarn.initial_regain = yarn.resting_regain = equilibrium_regain(yarn.isotherm, climate.humidity, climate.temperature);
    if (yarn.liquid_diffusivity > 0) {
        yarn.suction_radius = type.pore_radius / std::cos(type.contact_angle);
        // Darcy flow across the fibres from the skin to half-way to the yarn's middle.
        yarn.intake_flux = climate.density * permeability_across(yarn.fibre_radius, type.packing) *
                           capillary_pressure(climate.surface_tension, type.contact_angle, type.pore_radius) /
                           (climate.viscosity * 0.25 * type.section.height);
    }
    return yarn;
}

/// A prism between the two axes, as wide as the yarns overlap: liquid and vapour pass across the fibres of each, half the way in each.
CrossingParameters make_crossing(const YarnType& warp_type, const YarnType& weft_type, const YarnParameters& warp,
                                 const YarnParameters& weft, const ClimateParameters& climate)
{
    const double area = warp_type.section.width * weft_type.section.width;
    const double half_warp = 0.5 * warp_type.section.height, half_weft = 0.5 * weft_type.section.height;
    const auto in_series = [&](double a, double b) { return a > 0 && b > 0 ? area / (half_warp / a + half_weft / b) : 0.0; };
    // The obstruction of the crossing: how much less permeable a bundle is across its fibres than along them (Gebart).
    const auto across = [](const YarnType& type, const YarnParameters& yarn) {
        const double obstruction = permeability_across(yarn.fibre_radius, type.packing) / permeability_along(yarn.fibre_radius, type.packing);
        return yarn.liquid_diffusivity * obstruction * (1.0 - type.packing);
    };
    CrossingParameters crossing;
    crossing.liquid_conductance = climate.density * in_series(across(warp_type, warp), across(weft_type, weft));
    crossing.heat_conductance = in_series(mean_conductivity(warp_type.packing, warp.fibre_conductivity, 0),
                                          mean_conductivity(weft_type.packing, weft.fibre_conductivity, 0));
    crossing.vapour_conductance =
        in_series(warp.vapour_diffusivity * (1.0 - warp_type.packing), weft.vapour_diffusivity * (1.0 - weft_type.packing));
    return crossing;
}

ContactShape make_shape(const YarnSystem& system, std::size_t own)
{
    const YarnType& type = system.types[own];
    ContactShape shape{0.5 * type.section.height, 0.5 * type.section.width, {}};
    const std::size_t paths = system.paths.size() / system.types.size();
    for (std::size_t p = own * paths; p < (own + 1) * paths; ++p) {
        const YarnPath& path = system.paths[p];
        for (std::size_t i = 0; i < path.height.size(); ++i)
            for (double value : {path.height[i], path.slope[i], path.half_height[i], path.half_width[i]})
                shape.profiles.push_back(static_cast<float>(value));
    }
    return shape;
}

/// The types of yarn, what they are like where they cross, and which each end and pick is of.
void add_yarns(Scene& scene, const Textile& textile)
{
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const YarnSystem& system = textile.system(kind);
        const auto before = static_cast<int>(scene.yarns.size());
        for (std::size_t type = 0; type < system.types.size(); ++type) {
            scene.yarns.push_back(make_yarn(system.types[type], textile.system(other_kind(kind)).pitch, scene.climate));
            scene.shapes.push_back(make_shape(system, type));
        }
        for (int yarn = 0; yarn < system.count; ++yarn)
            scene.type.push_back(static_cast<std::uint8_t>(before + textile.type_of(kind, yarn)));
    }
    const std::size_t warps = textile.warp.types.size(), wefts = textile.weft.types.size();
    scene.warp_types = static_cast<int>(warps);
    for (std::size_t warp = 0; warp < warps; ++warp)
        for (std::size_t weft = 0; weft < wefts; ++weft) {
            const YarnType &over = textile.warp.types[warp], &under = textile.weft.types[weft];
            scene.crossing.push_back(make_crossing(over, under, scene.yarns[warp], scene.yarns[warps + weft], scene.climate));
            scene.crossing.back().warp_rise = over.rise[weft];
            scene.crossing.back().weft_rise = under.rise[warp];
        }
    scene.warp_pitch = textile.warp.pitch;
    scene.weft_pitch = textile.weft.pitch;
    scene.profile_samples = static_cast<int>(textile.warp.paths[0].height.size());
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
    scene.shift.resize(static_cast<std::size_t>(scene.segments()));
    scene.warp_up.resize(static_cast<std::size_t>(scene.crossings()));
    for (int end = 0; end < scene.ends; ++end)
        for (int pick = 0; pick < scene.picks; ++pick) {
            for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
                const auto segment = static_cast<std::size_t>(textile.segment(kind, end, pick));
                scene.length[segment] = textile.segment_length(kind, end, pick);
                scene.shift[segment] = static_cast<float>(textile.shift_at_crossing(kind, end, pick));
            }
            scene.warp_up[static_cast<std::size_t>(end * scene.picks + pick)] = textile.warp_up(end, pick);
        }
    scene.cell_area = textile.warp.pitch * textile.weft.pitch;
    scene.half_thickness = textile.half_thickness();
    scene.climate = make_climate(experiment);
    add_yarns(scene, textile);
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
