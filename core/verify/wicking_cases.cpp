// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid along yarns and across the network against Lucas and Washburn, Darcy, and Barenblatt.
#include "core/base/error.h"
#include "core/physics/water.h"
#include "core/physics/wicking.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace hygroloom {
namespace {

/// A front so sharp that the yarn fills like a tube: D = D0 s^p with D0 / (p + 1) kept and p large.
constexpr double tube_exponent = 1999;

/// x^2 / 2t of the ideal front in a level tube, m2/s: the diffusivity that a run gives pores of that radius, without its share of 1/5.
double tube_mobility(double temperature, double contact_angle, double radius)
{
    return 5.0 * saturated_liquid_diffusivity(water_surface_tension(temperature), contact_angle, radius, water_viscosity(temperature));
}

/// How far liquid has run at times/64, /16, /4 and 1 into a yarn whose end is in it; mobility = x^2 / 2t of the ideal front.
std::vector<double> front_distances(Backend& backend, double temperature, double mobility, double time, double farthest)
{
    constexpr int cells = 1200;
    Scene scene = bare_scene(1, cells, 1.2 * farthest / cells, temperature);
    scene.rules.wicking = true;
    scene.cloth.yarns[0].exponent = tube_exponent;
    scene.cloth.yarns[0].liquid_diffusivity = mobility * (tube_exponent + 1);
    scene.supply.fed.assign(static_cast<std::size_t>(scene.cloth.segments()), 0);
    scene.supply.fed[0] = 1;
    scene.rules.network_step = time / 4000;
    const double capacity = scene.climate.density * scene.cloth.yarns[0].pore_area;
    std::vector<double> distances;
    for (const Frame& frame : frames_at(backend, scene, {time / 64, time / 16, time / 4, time})) {
        // The water that ran in, as length of full tube from the middle of the fed segment.
        const double held = std::accumulate(frame.liquid.begin() + 1, frame.liquid.begin() + cells, 0.0);
        distances.push_back(held > 0 ? held / capacity + 0.5 * scene.cloth.length[0] : 0.0);
    }
    return distances;
}

/// Slope of log distance over log time between times 4 apart, least squares.
double front_exponent(const std::vector<double>& distances)
{
    double sum = 0;
    const double middle = 0.5 * (static_cast<double>(distances.size()) - 1);
    double squares = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const double t = (static_cast<double>(i) - middle) * std::log(4.0);
        sum += t * std::log(distances[i]);
        squares += t * t;
    }
    return sum / squares;
}

/// A tube that stands in liquid: time for the front to reach each cell's end, or less than nothing when it did not.
struct StandingTube {
    Scene scene;
    double cell = 0; ///< m

    StandingTube(double temperature, double radius, double contact_angle, double length, double step)
    {
        constexpr int cells = 800;
        cell = length / cells;
        scene = bare_scene(1, cells, cell, temperature);
        scene.rules.wicking = true;
        const double suction = capillary_pressure(scene.climate.surface_tension, contact_angle, radius);
        const double mobility = tube_mobility(temperature, contact_angle, radius);
        const PoreFlow flow = pore_flow(mobility * (tube_exponent + 1), tube_exponent, suction, scene.climate.density);
        scene.cloth.yarns[0].exponent = flow.exponent;
        scene.cloth.yarns[0].liquid_diffusivity = flow.diffusivity;
        scene.cloth.yarns[0].fall = flow.fall;
        scene.cloth.gravity_along_warp = gravity_acceleration;
        scene.supply.fed.assign(static_cast<std::size_t>(scene.cloth.segments()), 0);
        scene.supply.fed[0] = 1;
        scene.rules.network_step = step;
    }
    /// The liquid in it as length of full tube above the middle of the cell that hangs in the liquid; 0 when none has risen.
    double height(const Frame& frame) const
    {
        const double capacity = scene.climate.density * scene.cloth.yarns[0].pore_area;
        const double held = std::accumulate(frame.liquid.begin() + 1, frame.liquid.begin() + scene.cloth.picks, 0.0);
        return held > 0 ? held / capacity + 0.5 * cell : 0.0;
    }
};

/// Time to rise to a height (Washburn 1921 with gravity).
double rising_time(double radius, double equilibrium, double viscosity, double density, double height)
{
    return 8.0 * viscosity / (density * gravity_acceleration * radius * radius) *
           (-height - equilibrium * std::log1p(-height / equilibrium));
}

/// Above the liquid outside (Jurin).
double equilibrium_for(const VerifyValues& v, double temperature, double contact_angle_deg)
{
    return equilibrium_height(water_surface_tension(temperature), radian_from_degree(contact_angle_deg),
                              metre_from_um(value(v, "radius_um")), water_density(temperature));
}

/// From 90 degrees on water does not get into a tube by itself.
bool wets(const VerifyValues& v) { return value(v, "contact_angle_deg") < 90; }

std::vector<VerifyResult> washburn_gravity(const VerifyValues& v, Backend& backend)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c")), radius = metre_from_um(value(v, "radius_um"));
    const double height = metre_from_mm(value(v, "height_mm")), angle = value(v, "contact_angle_deg");
    if (!wets(v))
        throw Error(fmt::format("contact_angle_deg: At {:g} degrees the liquid does not rise to any height; give less than 90.", angle));
    const double highest = equilibrium_for(v, temperature, angle);
    if (height >= 0.98 * highest)
        throw Error(
            fmt::format("height_mm: The liquid rises to {:.4g} mm in this tube; give less than {:.4g}.", 1e3 * highest, 980 * highest));
    const double expected = rising_time(radius, highest, water_viscosity(temperature), water_density(temperature), height);
    constexpr int samples = 150;
    std::vector<double> times;
    for (int i = 1; i <= samples; ++i) times.push_back(1.5 * expected * i / samples);
    const StandingTube tube(temperature, radius, radian_from_degree(angle), std::min(1.4 * height, 1.05 * highest), expected / 2000);
    double before = 0, before_time = 0, computed = std::numeric_limits<double>::quiet_NaN();
    for (const Frame& frame : frames_at(backend, tube.scene, times)) {
        const double now = tube.height(frame);
        if (now >= height) {
            computed = before_time + (height - before) / (now - before) * (frame.time - before_time);
            break;
        }
        before = now;
        before_time = frame.time;
    }
    return {{"time_s", computed, expected, 0.03 * expected}};
}

std::vector<VerifyResult> jurin(const VerifyValues& v, Backend& backend)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c")), radius = metre_from_um(value(v, "radius_um"));
    const double angle = value(v, "contact_angle_deg"), expected = wets(v) ? equilibrium_for(v, temperature, angle) : 0.0;
    const double extent = wets(v) ? expected : equilibrium_for(v, temperature, 0); // of a tube as long as it could have risen
    const double slowness =
        8.0 * water_viscosity(temperature) * extent / (water_density(temperature) * gravity_acceleration * radius * radius);
    const StandingTube tube(temperature, radius, radian_from_degree(angle), 1.2 * extent, 0.02 * slowness);
    const Frame frame = frames_at(backend, tube.scene, {12.0 * slowness}).back();
    return {{"height_mm", 1e3 * tube.height(frame), 1e3 * expected, 0.01 * 1e3 * expected}};
}

/// A plane that absorbs from a round source in its middle, as one wedge of it: a yarn that widens with the distance.
std::vector<VerifyResult> radial_wicking(const VerifyValues& v, Backend& backend)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c")), porosity = value(v, "porosity");
    const double source = metre_from_mm(value(v, "source_radius_mm")), radius = metre_from_mm(value(v, "radius_mm"));
    if (radius <= source) throw Error(fmt::format("radius_mm: The front starts at the source's radius of {} mm; give more.", 1e3 * source));
    const double mobility = value(v, "permeability_m2") * value(v, "pressure_pa") / (water_viscosity(temperature) * porosity);
    const double expected = (0.5 * radius * radius * (std::log(radius / source) - 0.5) + 0.25 * source * source) / mobility;
    constexpr int cells = 1000;
    const double cell = (1.1 * radius - source) / cells;
    Scene scene = bare_scene(1, cells, cell, temperature);
    scene.rules.wicking = true;
    scene.cloth.yarns[0].exponent = tube_exponent;
    scene.cloth.yarns[0].liquid_diffusivity = mobility * (tube_exponent + 1);
    constexpr double width = 1e-4; // m2 of pores per m of radius
    scene.cloth.pores.assign(static_cast<std::size_t>(scene.cloth.segments()), 1e-12);
    for (int i = 0; i < cells; ++i) scene.cloth.pores[static_cast<std::size_t>(i)] = width * (source + i * cell) * cell;
    scene.supply.fed.assign(static_cast<std::size_t>(scene.cloth.segments()), 0);
    scene.supply.fed[0] = 1;
    scene.rules.network_step = expected / 3000;
    constexpr int samples = 150;
    std::vector<double> times;
    for (int i = 1; i <= samples; ++i) times.push_back(1.2 * expected * i / samples);
    double before = source, before_time = 0, computed = std::numeric_limits<double>::quiet_NaN();
    for (const Frame& frame : frames_at(backend, scene, times)) {
        const double held = std::accumulate(frame.liquid.begin() + 1, frame.liquid.begin() + cells, 0.0) / (scene.climate.density * width);
        const double now = std::sqrt((source + 0.5 * cell) * (source + 0.5 * cell) + 2.0 * held);
        if (now >= radius) {
            computed = before_time + (radius - before) / (now - before) * (frame.time - before_time);
            break;
        }
        before = now;
        before_time = frame.time;
    }
    return {{"time_s", computed, expected, 0.03 * expected}};
}

std::vector<VerifyResult> washburn(const VerifyValues& v, Backend& backend)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c"));
    const double radius = metre_from_um(value(v, "radius_um")), time = value(v, "time_s");
    const double angle = radian_from_degree(value(v, "contact_angle_deg"));
    const auto front = [&](double contact_angle) { // Lucas and Washburn, m
        return std::sqrt(adhesion_tension(water_surface_tension(temperature), contact_angle) * radius * time /
                         (2.0 * water_viscosity(temperature)));
    };
    const double expected = wets(v) ? front(angle) : 0.0;
    const double extent = wets(v) ? expected : front(0);
    const std::vector<double> distances = front_distances(backend, temperature, tube_mobility(temperature, angle, radius), time, extent);
    std::vector<VerifyResult> results{{"distance_mm", 1e3 * distances.back(), 1e3 * expected, 0.02 * 1e3 * expected}};
    if (wets(v)) results.push_back({"exponent", front_exponent(distances), 0.5, 0.02}); // what stands still has none
    return results;
}

std::vector<VerifyResult> darcy_strip(const VerifyValues& v, Backend& backend)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c"));
    const double mobility = value(v, "permeability_m2") * value(v, "pressure_pa") / (water_viscosity(temperature) * value(v, "porosity"));
    const double time = value(v, "time_s"), expected = std::sqrt(2.0 * mobility * time);
    const double distance = front_distances(backend, temperature, mobility, time, expected).back();
    return {{"distance_mm", 1e3 * distance, 1e3 * expected, 0.02 * 1e3 * expected}};
}

/// Barenblatt's spreading of a finite drop on a plane: s(r, t) with front and centre.
struct Barenblatt {
    double p, d0, mass; ///< mass in m2: volume / (thickness x porosity)
    double tau(double t) const { return d0 * t / (p + 1); }
    double kappa() const { return p / (4.0 * (p + 1) * (p + 1)); }
    double constant() const { return std::pow(mass * kappa() * (p + 1) / (pi * p), p / (p + 1)); }
    double radius(double t) const { return std::sqrt(constant() / kappa()) * std::pow(tau(t), 0.5 / (p + 1)); }
    double saturation(double r, double t) const
    {
        const double scale = std::pow(tau(t), -1.0 / (p + 1));
        return scale * std::pow(std::max(0.0, constant() - kappa() * r * r * scale), 1.0 / p);
    }
};

std::vector<VerifyResult> barenblatt(const VerifyValues& v, Backend& backend)
{
    const double porosity = value(v, "porosity"), thickness = 1e-3 * value(v, "thickness_mm"), time = value(v, "time_s");
    const Barenblatt exact{value(v, "exponent"), value(v, "diffusivity_m2_s"), 1e-9 * value(v, "volume_ul") / (thickness * porosity)};
    constexpr int cells = 101;
    const double pitch = 2.3 * exact.radius(time) / cells, temperature = kelvin_from_celsius(value(v, "temperature_c"));
    Scene scene = bare_scene(cells, cells, pitch, temperature);
    scene.rules.wicking = true;
    for (YarnParameters& yarn : scene.cloth.yarns) {
        yarn.pore_area = 0.5 * thickness * porosity * pitch; // each system holds half of the plane's liquid
        yarn.exponent = exact.p;
        yarn.liquid_diffusivity = 2.0 * exact.d0; // and carries all of one direction's flow
        yarn.suction_radius = 1e-5;
    }
    scene.cloth.crossing[0].liquid_conductance = 1e3 * scene.climate.density * scene.cloth.yarns[0].pore_area * exact.d0 / pitch;

    // From the exact profile of an earlier time, once the centre is no longer over-full.
    const double full_until = std::pow(std::pow(exact.constant(), 1.0 / exact.p), exact.p + 1) * (exact.p + 1) / exact.d0;
    const double start = std::max(time / 16, 1.01 * full_until);
    if (time <= start) throw Error(fmt::format("time_s: The spot's middle is more than full until {:.4g} s; give more.", start));
    scene.cloth.start.liquid.resize(static_cast<std::size_t>(scene.cloth.segments()));
    const auto radius_of = [&](int end, int pick) { return pitch * std::hypot(end - cells / 2, pick - cells / 2); };
    const double capacity = scene.climate.density * scene.cloth.yarns[0].pore_area * pitch;
    for (int end = 0; end < cells; ++end)
        for (int pick = 0; pick < cells; ++pick) {
            const double liquid = capacity * exact.saturation(radius_of(end, pick), start);
            scene.cloth.start.liquid[static_cast<std::size_t>(end * cells + pick)] = liquid;
            scene.cloth.start.liquid[static_cast<std::size_t>(scene.cloth.crossings() + pick * cells + end)] = liquid;
        }
    scene.rules.network_step = time / 600;
    const Frame frame = frames_at(backend, scene, {std::max(1e-9, time - start)}).front();

    const double centre = 0.5 * (frame.saturation[static_cast<std::size_t>((cells / 2) * cells + cells / 2)] +
                                 frame.saturation[static_cast<std::size_t>(scene.cloth.crossings() + (cells / 2) * cells + cells / 2)]);
    constexpr double front = 1e-4; // of the centre: low, because a small exponent's profile ends in a long flat foot
    const auto wet = std::count_if(frame.saturation.begin(), frame.saturation.end(), [&](float s) { return s > front * centre; });
    const double radius = std::sqrt(0.5 * static_cast<double>(wet) * pitch * pitch / pi);
    const double expected_radius = exact.radius(time), expected_centre = exact.saturation(0, time);
    return {{"radius_mm", 1e3 * radius, 1e3 * expected_radius, 0.03 * 1e3 * expected_radius},
            {"centre_saturation", centre, expected_centre, 0.02 * expected_centre}};
}

} // namespace

std::vector<VerifyCase> wicking_cases()
{
    const VerifyParameter temperature{"temperature_c", 20, 0, 90, ""};
    return {
        {"washburn",
         "A horizontal tube draws water in: distance against Lucas and Washburn, and the exponent of time. From 90 degrees on it draws "
         "nothing in, which has no exponent.",
         {{"radius_um", 10, 1e-2, 1e3, ""}, {"contact_angle_deg", 60, 0, 180, ""}, {"time_s", 5, 1e-3, 1e5, ""}, temperature},
         washburn},
        {"darcy_strip",
         "A strip draws water in under a given suction: distance against Darcy with a sharp front.",
         {{"permeability_m2", 1e-12, 1e-18, 1e-6, ""},
          {"pressure_pa", 5e3, 1e-2, 1e7, ""},
          {"porosity", 0.6, 0.01, 1, ""},
          {"time_s", 30, 1e-3, 1e5, ""},
          temperature},
         darcy_strip},
        {"washburn_gravity",
         "An upright tube draws water up: time to a height against Washburn with gravity.",
         {{"radius_um", 50, 1, 1e3, ""}, {"contact_angle_deg", 0, 0, 180, ""}, {"height_mm", 50, 1e-2, 1e4, ""}, temperature},
         washburn_gravity},
        {"jurin",
         "An upright tube left long in water: the height of the column, which is nothing from 90 degrees on.",
         {{"radius_um", 100, 1, 1e3, ""}, {"contact_angle_deg", 0, 0, 180, ""}, temperature},
         jurin},
        {"radial_wicking",
         "A plane draws water from a round source under a given suction: time for the front to reach a radius.",
         {{"permeability_m2", 1e-12, 1e-18, 1e-6, ""},
          {"pressure_pa", 5e3, 1e-2, 1e7, ""},
          {"porosity", 0.6, 0.01, 1, ""},
          {"source_radius_mm", 2, 0.1, 100, ""},
          {"radius_mm", 10, 0.2, 1000, ""},
          temperature},
         radial_wicking},
        {"barenblatt",
         "A finite drop spreads in a plane with D = D0 s^p: front and centre against Barenblatt's solution.",
         {{"exponent", 2, 0.3, 5, ""},
          {"volume_ul", 50, 1e-3, 5e3, ""},
          {"thickness_mm", 0.4, 1e-3, 10, ""},
          {"porosity", 0.6, 0.01, 1, ""},
          {"diffusivity_m2_s", 1e-5, 1e-9, 1e-3, ""},
          {"time_s", 20, 1e-3, 1e5, ""},
          temperature},
         barenblatt},
    };
}

} // namespace hygroloom
