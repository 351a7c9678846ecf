// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid along yarns against Lucas and Washburn, and Darcy.
#include "core/base/error.h"
#include "core/physics/retention.h"
#include "core/physics/water.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace hygroloom {
namespace {

/// Pores that all fill at one suction, Pa, and let none go below three times as much: what they hold falls from all to nothing on a
/// straight line about it, wider than suction differs from a cell of a standing tube to the next.
Retention one_suction(double suction)
{
    constexpr double narrow = 2e-3, keeps = 3, stiff = 1e3; // of the suction
    Retention pores;
    pores.twice_shape = 0;
    pores.quarters = 1;
    pores.entry = suction;
    pores.full = (1.0 - narrow) * suction;
    pores.knee = pores.front = suction;
    pores.at_knee = pores.threshold = 0.5;
    pores.dry = (1.0 + narrow) * suction;
    pores.gives = keeps * suction;
    pores.emptying = pores.gives + pores.entry;
    pores.breaks = pores.gives + stiff * suction;
    return pores;
}

/// What draws water into a tube, and what lets it through.
struct Draw {
    double suction = 0;  ///< Pa
    double mobility = 0; ///< m2/(Pa s), permeability over viscosity and porosity
};
/// A round tube's (Hagen and Poiseuille); from 90 degrees on nothing draws.
Draw draw_of_tube(double temperature, double contact_angle, double radius)
{
    const double tension = water_surface_tension(temperature);
    if (!wets_pores(tension, contact_angle)) return {capillary_pressure(tension, 0, radius), 0};
    return {capillary_pressure(tension, contact_angle, radius), radius * radius / (8.0 * water_viscosity(temperature))};
}
/// Of the values that the cases of Darcy share.
Draw draw_of_strip(const VerifyValues& v)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c"));
    return {value(v, "pressure_pa"), value(v, "permeability_m2") / (water_viscosity(temperature) * value(v, "porosity"))};
}

/// A yarn whose first cell hangs in the liquid; its picks take no part.
Scene tube(double temperature, const Draw& draw, int cells, double cell)
{
    Scene scene = bare_scene(1, cells, cell, temperature);
    scene.rules.wicking = true;
    scene.rules.saturation_change = 1e3; // steps end where the case asks
    scene.rules.network_step = 1e12;
    scene.cloth.by_suction = true;
    for (YarnParameters& yarn : scene.cloth.yarns) yarn.on_face[0] = yarn.on_face[1] = {one_suction(draw.suction), 1.0};
    scene.cloth.yarns[0].flow_along = draw.mobility * scene.cloth.yarns[0].pore_area;
    BetweenParameters& between = scene.cloth.crossing[0].between;
    between.volume = scene.cloth.yarns[0].pore_area * cell;
    std::fill(std::begin(between.retention), std::end(between.retention), one_suction(draw.suction));
    scene.supply.fed.assign(static_cast<std::size_t>(scene.cloth.segments()), 0);
    scene.supply.fed[0] = 1;
    scene.cloth.start.liquid.assign(static_cast<std::size_t>(scene.cloth.segments()), 0.0);
    scene.cloth.start.liquid[0] = scene.climate.density * scene.cloth.yarns[0].pore_area * cell;
    return scene;
}

/// kg that have run in beyond the first cell.
double drawn_in(const Scene& scene, const Frame& frame)
{
    return std::accumulate(frame.liquid.begin() + 1, frame.liquid.begin() + scene.cloth.picks, 0.0);
}
/// As length of full tube from the middle of the first cell.
double distance_in_tube(const Scene& scene, const Frame& frame)
{
    const double held = drawn_in(scene, frame);
    return held > 0 ? held / (scene.climate.density * scene.cloth.yarns[0].pore_area) + 0.5 * scene.cloth.length[0] : 0.0;
}

/// A front's distances (m) at time x (n / steps)^2, n = 1, 2, …: as it goes with the root of time, it comes as far in each step.
constexpr int steps_of_front = 1600, cells_to_front = 500;
template <typename Distance> std::vector<double> course_of(Backend& backend, const Scene& scene, double time, const Distance& distance)
{
    backend.load(scene);
    std::vector<double> distances;
    for (int n = 1; n <= steps_of_front; ++n) {
        const double until = time * n * n / (static_cast<double>(steps_of_front) * steps_of_front);
        while (backend.advance(until) < until) {}
        distances.push_back(distance(scene, backend.frame()));
    }
    return distances;
}
/// s, when a course of so many seconds that begins at a distance comes to another; not a number where it does not.
double time_at(const std::vector<double>& course, double time, double begins, double distance)
{
    for (std::size_t n = 0; n < course.size(); ++n) {
        const double before = n == 0 ? begins : course[n - 1];
        if (course[n] < distance) continue;
        const double root = (static_cast<double>(n) + (distance - before) / (course[n] - before)) / steps_of_front;
        return time * root * root;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// How far liquid has run at time/64, /16, /4 and 1 into a level yarn.
std::vector<double> front_distances(Backend& backend, double temperature, const Draw& draw, double time, double farthest)
{
    const Scene scene = tube(temperature, draw, static_cast<int>(1.2 * cells_to_front), farthest / cells_to_front);
    const std::vector<double> all = course_of(backend, scene, time, distance_in_tube);
    std::vector<double> distances;
    for (int part : {8, 4, 2, 1}) distances.push_back(all[steps_of_front / part - 1]);
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
    Scene scene = tube(temperature, draw_of_tube(temperature, radian_from_degree(angle), radius), static_cast<int>(1.2 * cells_to_front),
                       std::min(1.4 * height, 1.05 * highest) / (1.2 * cells_to_front));
    scene.cloth.gravity_along_warp = gravity_acceleration;
    const double longest = 1.5 * expected;
    const double computed = time_at(course_of(backend, scene, longest, distance_in_tube), longest, 0, height);
    return {{"time_s", computed, expected, 0.03 * expected}};
}

std::vector<VerifyResult> jurin(const VerifyValues& v, Backend& backend)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c")), radius = metre_from_um(value(v, "radius_um"));
    const double angle = value(v, "contact_angle_deg"), expected = wets(v) ? equilibrium_for(v, temperature, angle) : 0.0;
    const double extent = wets(v) ? expected : equilibrium_for(v, temperature, 0); // of a tube as long as it could have risen
    constexpr int cells = 800;
    constexpr double left = 12; // s
    Draw draw = draw_of_tube(temperature, radian_from_degree(angle), radius);
    if (draw.mobility > 0) draw.mobility = extent * extent / draw.suction; // of some seconds: only when it rests hangs on it, not where
    Scene scene = tube(temperature, draw, cells, 1.2 * extent / cells);
    scene.cloth.gravity_along_warp = gravity_acceleration;
    const double height = course_of(backend, scene, left, distance_in_tube).back();
    return {{"height_mm", 1e3 * height, 1e3 * expected, 0.01 * 1e3 * expected}};
}

/// A plane that absorbs from a round source in its middle, as one wedge of it: a yarn that widens with the distance.
std::vector<VerifyResult> radial_wicking(const VerifyValues& v, Backend& backend)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c"));
    const double source = metre_from_mm(value(v, "source_radius_mm")), radius = metre_from_mm(value(v, "radius_mm"));
    if (radius <= source) throw Error(fmt::format("radius_mm: The front starts at the source's radius of {} mm; give more.", 1e3 * source));
    const Draw draw = draw_of_strip(v);
    const double expected =
        (0.5 * radius * radius * (std::log(radius / source) - 0.5) + 0.25 * source * source) / (draw.mobility * draw.suction);
    constexpr int cells = 600;
    const double cell = (1.1 * radius - source) / cells;
    Scene scene = tube(temperature, draw, cells, cell);
    const double width = scene.cloth.yarns[0].pore_area / radius; // m2 of pores per m of radius
    scene.cloth.pores.assign(static_cast<std::size_t>(scene.cloth.segments()), scene.cloth.yarns[0].pore_area * cell);
    for (int i = 0; i < cells; ++i) scene.cloth.pores[i] = width * (source + i * cell) * cell;
    scene.cloth.start.liquid[0] = scene.climate.density * scene.cloth.pores[0];
    const auto front = [&](const Scene& at, const Frame& frame) {
        const double inner = source + 0.5 * cell;
        return std::sqrt(inner * inner + 2.0 * drawn_in(at, frame) / (at.climate.density * width));
    };
    const double longest = 1.2 * expected;
    const double computed = time_at(course_of(backend, scene, longest, front), longest, source, radius);
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
    const std::vector<double> distances = front_distances(backend, temperature, draw_of_tube(temperature, angle, radius), time, extent);
    std::vector<VerifyResult> results{{"distance_mm", 1e3 * distances.back(), 1e3 * expected, 0.02 * 1e3 * expected}};
    if (wets(v)) results.push_back({"exponent", front_exponent(distances), 0.5, 0.02}); // what stands still has none
    return results;
}

std::vector<VerifyResult> darcy_strip(const VerifyValues& v, Backend& backend)
{
    const double temperature = kelvin_from_celsius(value(v, "temperature_c"));
    const Draw draw = draw_of_strip(v);
    const double time = value(v, "time_s"), expected = std::sqrt(2.0 * draw.mobility * draw.suction * time);
    const double distance = front_distances(backend, temperature, draw, time, expected).back();
    return {{"distance_mm", 1e3 * distance, 1e3 * expected, 0.02 * 1e3 * expected}};
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
    };
}

} // namespace hygroloom
