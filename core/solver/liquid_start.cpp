// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/liquid_start.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom::inline HL_PRECISION {
namespace {

constexpr double drip_distance = 5e-3;      // m below the fabric, or beside it, at which a particle counts as dripped off
constexpr double pressure_relaxation = 0.5; // of a pressure correction; whole ones overshoot between close particles

Vec3 rounded(const Vec3d& v) { return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)}; }

/// The liquid's own and the numerical one, m2/s.
double viscosity(const ClimateParameters& climate, const LiquidStart& start)
{
    return viscosity_of_particles(climate.viscosity / climate.density, climate.surface_tension / climate.density,
                                  static_cast<double>(start.spacing));
}

/// Longest step for what stands in the vessel from the start, s; on cloth no drop stands as deep.
double weight_step(const Scene& scene, const LiquidStart& start)
{
    double depth = 0;
    if (scene.liquid.vessel)
        for (const Vec3d& place : scene.liquid.places) depth = std::max(depth, place.z - scene.liquid.vessel->low.z);
    return longest_weight_step(static_cast<double>(start.spacing), scene.liquid.gravity, depth);
}

Vessel vessel_of(const Scene& scene)
{
    if (!scene.liquid.vessel) return {};
    return {true, rounded(scene.liquid.vessel->low), rounded(scene.liquid.vessel->high),
            static_cast<Real>(scene.liquid.vessel->adhesion / scene.climate.surface_tension - 1.0)};
}

} // namespace

std::size_t LiquidStart::particles_of(double of_volume) const
{
    return static_cast<std::size_t>(std::max(1LL, std::llround(of_volume / std::pow(static_cast<double>(spacing), 3))));
}

LiquidStart liquid_start(const Scene& scene)
{
    LiquidStart start;
    const std::size_t drops = scene.supply.droplets.size(), standing = scene.liquid.places.size();
    if (drops + standing == 0 || scene.caps.on) return start;
    double volume = 0;
    for (const SceneDroplet& d : scene.supply.droplets) volume += d.volume;
    start.volume = scene.liquid.particle_volume > 0
                       ? scene.liquid.particle_volume
                       : volume / (static_cast<double>(scene.rules.particles_per_droplet) * static_cast<double>(drops));
    start.mass = static_cast<Real>(start.volume * scene.climate.density);
    start.lattice_spacing = std::cbrt(start.volume);
    start.spacing = static_cast<Real>(start.lattice_spacing);
    start.support = Real(support_in_spacings) * start.spacing;
    start.reach = static_cast<Real>(surface_support_in_spacings) * start.spacing;
    static_assert(2 * support_in_spacings >= surface_support_in_spacings); // see DistantPairs
    std::size_t room = standing;
    for (const SceneDroplet& d : scene.supply.droplets) room += start.particles_of(d.volume);
    if (scene.cloth.swelling > 0) room += room / 2; // for what swollen yarns give back
    start.room = static_cast<int>(room);
    return start;
}

LiquidRules liquid_rules(const Scene& scene, const LiquidStart& start)
{
    const ClimateParameters& climate = scene.climate;
    LiquidRules rules;
    rules.spacing = start.spacing;
    rules.particle_mass = static_cast<double>(start.mass);
    rules.density = climate.density;
    rules.surface_tension = climate.surface_tension;
    const LiquidSteps longest =
        longest_steps(climate.surface_tension / climate.density, viscosity(climate, start), static_cast<double>(start.spacing));
    const double weight = weight_step(scene, start);
    rules.correction_time = std::min(longest.capillary, 4.0 * weight); // over one, what stands is 3 to 7 % too high in pressure
    rules.capillary_dt = scene.rules.liquid_step_factor * longest.capillary;
    rules.viscous_dt = scene.rules.liquid_step_factor * longest.viscous;
    rules.weight_dt = scene.rules.liquid_step_factor * weight;
    rules.courant = scene.rules.liquid_step_factor * 0.4;
    rules.steps_between_absorption = scene.rules.steps_between_absorption;
    rules.stiffness = pressure_relaxation * pressure_stiffness(start.lattice_spacing, static_cast<double>(start.support));
    rules.settle_share = scene.rules.settle_share;
    rules.drag = 20.0 * climate.viscosity / climate.density;
    double thinnest = scene.cloth.shapes[0].half_height;
    for (const ContactShape& shape : scene.cloth.shapes) thinnest = std::min(thinnest, shape.half_height);
    rules.thinnest2 = thinnest * thinnest;
    return rules;
}

LiquidParameters liquid_parameters(const Scene& scene, const LiquidStart& start)
{
    LiquidParameters l;
    l.density = static_cast<Real>(scene.climate.density);
    l.kinematic_viscosity = static_cast<Real>(viscosity(scene.climate, start));
    l.surface_tension = static_cast<Real>(scene.climate.surface_tension);
    l.gravity = static_cast<Real>(scene.liquid.gravity);
    l.surface = surface_energy(l.surface_tension, start.spacing);
    l.vessel = vessel_of(scene);
    return l;
}

CellGrid grid_about(const Scene& scene, const LiquidStart& start)
{
    double width = scene.cloth.ends * 1.0 * scene.cloth.warp_pitch, height = scene.cloth.picks * 1.0 * scene.cloth.weft_pitch,
           highest = scene.cloth.half_thickness;
    for (const SceneDroplet& d : scene.supply.droplets) highest = std::max(highest, d.centre.z + std::cbrt(d.volume));
    for (const Vec3d& place : scene.liquid.places) {
        highest = std::max(highest, place.z);
        width = std::max(width, 4 * std::abs(place.x)); // with room to spread
        height = std::max(height, 4 * std::abs(place.y));
    }
    const bool stands_in_vessel = scene.liquid.vessel && !scene.liquid.places.empty();
    const double lowest = stands_in_vessel ? scene.liquid.vessel->low.z : -scene.cloth.half_thickness - drip_distance;
    const double size = std::max(0.5 * static_cast<double>(start.reach), std::max({width, height, highest - lowest}) * 1e-5);
    CellGrid grid;
    grid.size = static_cast<Real>(size);
    grid.per_size = Real(1) / grid.size;
    grid.origin = {static_cast<Real>(-0.5 * width - 2 * size), static_cast<Real>(-0.5 * height - 2 * size), static_cast<Real>(lowest)};
    const auto cells = [&](double extent) { return static_cast<int>(extent / size) + 5; };
    grid.whole_x = narrower * cells(width);
    grid.whole_y = cells(height);
    grid.whole_z = cells(highest - lowest);
    return grid;
}

Room room_about_sample(const Scene& scene)
{
    double half_x = 0.5 * scene.cloth.ends * scene.cloth.warp_pitch, half_y = 0.5 * scene.cloth.picks * scene.cloth.weft_pitch;
    for (const SceneDroplet& drop : scene.supply.droplets) {
        const double radius = std::cbrt(drop.volume * 3.0 / (4.0 * pi));
        half_x = std::max(half_x, std::abs(drop.centre.x) + radius);
        half_y = std::max(half_y, std::abs(drop.centre.y) + radius);
    }
    const double beside = scene.liquid.places.empty() ? drip_distance : std::numeric_limits<float>::max();
    return {static_cast<Real>(half_x + beside), static_cast<Real>(half_y + beside),
            static_cast<Real>(-scene.cloth.half_thickness - drip_distance)};
}

std::vector<Vec3> rounded(const std::vector<Vec3d>& values)
{
    std::vector<Vec3> result;
    result.reserve(values.size());
    for (const Vec3d& v : values) result.push_back(rounded(v));
    return result;
}

} // namespace hygroloom::inline HL_PRECISION
