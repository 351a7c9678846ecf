// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Drops that stand as caps, on a plate that takes up nothing: their shape, how they spread, and where they stay when they lose liquid.
#include "core/physics/caps.h"
#include "core/physics/heat_moisture.h"
#include "core/solver/cap_air.h"
#include "core/solver/cap_shapes.h"
#include "core/solver/caps.h"
#include "core/solver/drop_shapes.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

const double temperature = kelvin_from_celsius(20);

/// A plate on which one drop lands at 0 s without a fall.
Scene plate(double volume, double advancing, double receding)
{
    Scene scene = bare_scene(4, 4, 1e-3, temperature);
    SceneDroplet drop;
    drop.volume = volume;
    drop.centre.z = scene.cloth.half_thickness + std::cbrt(3.0 * volume / (4.0 * pi));
    scene.supply.droplets = {drop};
    scene.caps = {true, advancing, receding};
    return scene;
}

/// So much surface tension that no drop's weight flattens it.
void make_weightless(Scene& scene) { scene.climate.surface_tension *= 1e4; }

double weight_of(const Scene& scene) { return scene.climate.density * gravity_acceleration / scene.climate.surface_tension; }

/// m, after a time in 400 equal steps.
double base_after(Caps& caps, const Scene& scene, double time)
{
    constexpr int steps = 400;
    caps.load(scene);
    caps.release(1e-9);
    caps.spread(1e-9, 1e-9);
    for (int k = 0; k < steps; ++k) caps.spread((k + 1) * time / steps, time / steps);
    return caps.on_face(1e9).at(0).base;
}

std::vector<VerifyResult> cap_shape(const VerifyValues& v, Backend&)
{
    const double volume = cubic_metre_from_ul(value(v, "volume_ul")), angle = radian_from_degree(value(v, "contact_angle_deg"));
    const Scene scene = plate(volume, angle, angle);
    const bool heavy = value(v, "gravity") > 0;
    const DropOnPlate expected = drop_of_volume(volume, angle, heavy ? weight_of(scene) : 0.0);
    const double weight = heavy ? weight_of(scene) : 1e-9 * weight_of(scene); // of what hardly weighs
    const double base = CapShapes::table().base(volume, angle, weight), height = CapShapes::table().shape(volume, base, weight).height;
    return {{"base_radius_mm", 1e3 * base, 1e3 * expected.base_radius, 0.01 * 1e3 * expected.base_radius},
            {"height_mm", 1e3 * height, 1e3 * expected.height, 0.01 * 1e3 * expected.height}};
}

/// m, by the same law of the contact line over outlines integrated one by one, from angle to angle.
double spread_by_outlines(const Scene& scene, double volume, double time)
{
    constexpr int pieces = 300;
    const ClimateParameters& c = scene.climate;
    const double ball = std::cbrt(3.0 * volume / (4.0 * pi)), weight = weight_of(scene), first = 0.2 * ball;
    double flattest = scene.caps.advancing, steepest = pi - 1e-3;
    for (int k = 0; k < 40; ++k) { // the angle on the base on which it begins
        const double middle = 0.5 * (flattest + steepest);
        (drop_of_volume(volume, middle, weight).base_radius > first ? flattest : steepest) = middle;
    }
    double passed = 0, base = first;
    for (int k = 1; k < pieces; ++k) {
        const double angle = steepest + (scene.caps.advancing - steepest) * k / pieces;
        const double next = drop_of_volume(volume, angle, weight).base_radius, middle = 0.5 * (base + next);
        const double speed = std::min(speed_of_contact_line(c.surface_tension, c.viscosity,
                                                            angle - 0.5 * (scene.caps.advancing - steepest) / pieces, scene.caps.advancing),
                                      speed_of_inertia(c.surface_tension, c.density, ball, 0, middle));
        const double takes = (next - base) / speed;
        if (passed + takes >= time) return std::sqrt(base * base + (next * next - base * base) * (time - passed) / takes);
        passed += takes;
        base = next;
    }
    return base;
}

std::vector<VerifyResult> cap_spreading(const VerifyValues& v, Backend&)
{
    const double volume = cubic_metre_from_ul(value(v, "volume_ul")), angle = radian_from_degree(value(v, "contact_angle_deg"));
    const double time = value(v, "time_s");
    const Scene scene = plate(volume, angle, 0);
    Caps caps;
    const double radius = base_after(caps, scene, time), expected = spread_by_outlines(scene, volume, time);
    return {{"radius_mm", 1e3 * radius, 1e3 * expected, 0.02 * 1e3 * expected}};
}

std::vector<VerifyResult> cap_pinning(const VerifyValues& v, Backend&)
{
    const double volume = cubic_metre_from_ul(value(v, "volume_ul")), angle = radian_from_degree(value(v, "contact_angle_deg")),
                 receding = std::min(angle, radian_from_degree(value(v, "receding_angle_deg")));
    const double left = std::min(volume, cubic_metre_from_ul(value(v, "left_ul")));
    Scene scene = plate(volume, angle, receding);
    if (value(v, "gravity") < 0.5) make_weightless(scene);
    const double weight = weight_of(scene);
    Caps caps;
    base_after(caps, scene, 30);
    constexpr int pieces = 50;
    const auto wanted = [&](int k) { // quanta
        return std::llround((volume + (left - volume) * k / pieces) * scene.climate.density / water_quantum);
    };
    for (int k = 1; k <= pieces; ++k) {
        caps.take({{0, caps.water() - wanted(k)}});
        caps.spread(30 + k, 1);
    }
    const double base = caps.on_face(1e9).at(0).base, shown = CapShapes::table().shape(left, base, weight).angle;
    const double pinned = drop_of_volume(volume, angle, weight).base_radius,
                 drawn_back = drop_of_volume(left, receding, weight).base_radius;
    double low = 1e-3, high = pi - 1e-3; // of what is left on the base that stays
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        (drop_of_volume(left, middle, weight).base_radius > pinned ? low : high) = middle;
    }
    const double expected = std::min(pinned, drawn_back), expected_angle = drawn_back < pinned ? receding : low;
    return {{"base_radius_mm", 1e3 * base, 1e3 * expected, 0.01 * 1e3 * expected},
            {"angle_deg", shown * 180 / pi, expected_angle * 180 / pi, 0.01 * expected_angle * 180 / pi}};
}

std::vector<VerifyResult> cap_evaporation(const VerifyValues& v, Backend&)
{
    const double degrees = value(v, "contact_angle_deg"), angle = radian_from_degree(degrees);
    // Popov's integral by Simpson's rule, in a place that goes to 1 as the integrand's own goes without end.
    constexpr int pieces = 20000;
    double sum = 0;
    for (int k = 1; k < pieces; ++k) {
        const double part = static_cast<double>(k) / pieces, place = part / (1.0 - part);
        sum += (k % 2 == 1 ? 4.0 : 2.0) * evaporation_integrand(angle, place) / ((1.0 - part) * (1.0 - part));
    }
    const double first = (pi - angle) / pi; // at 0: four exponentials of 1 over 4 pi times the place, times the tangent's slope
    const double expected = cap_steepness(angle) + 4.0 * (sum + first) / (3.0 * pieces);
    return {{"factor", evaporation_factor(angle), expected, 1e-4 * expected}};
}

/// Heat of evaporation that diffuses away is what the air conducts to a drop that nothing else warms; K.
double insulated_temperature(double air, double humidity)
{
    const double vapour = humidity * saturation_concentration(air), diffusivity = vapour_diffusivity(air);
    double low = air - 60, high = air;
    for (int round = 0; round < 60; ++round) {
        const double middle = 0.5 * (low + high);
        const double taken = diffusivity * heat_of_evaporation(middle) * (saturation_concentration(middle) - vapour);
        (taken > air_conductivity * (air - middle) ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

/// s; what a drop without weight has lost by diffusion (Popov 2005) with one angle, or on one base.
double lifetime_of_drop(double volume, double angle, bool pinned, double density, double diffusivity, double difference)
{
    const double base = cap_base(volume, angle), per_kg = 1.0 / (diffusivity * difference);
    if (!pinned)
        return density * 1.5 * cap_fullness(angle) * base * base * per_kg / (pi * evaporation_factor(angle)); // volume^(2/3) falls evenly
    constexpr int pieces = 400;
    double time = 0;
    for (int k = 0; k < pieces; ++k) {
        const double from = angle * k / pieces, to = angle * (k + 1) / pieces;
        const double lost = density * (cap_fullness(to) - cap_fullness(from)) * base * base * base;
        time += lost * per_kg / (pi * base * evaporation_factor(0.5 * (from + to)));
    }
    return time;
}

/// A drop on cloth without pores and of next to no mass, in still air.
Scene drop_to_dry(double volume, double angle, bool pinned, double air, double humidity)
{
    constexpr int threads = 24;
    const Retention closed{1e4, 5e3, 1.2e4, 1.5e4, 1e4, 0.2, 8};
    const double base = cap_base(volume, angle);
    Scene scene = bare_scene(threads, threads, base / 8, air);
    for (YarnParameters& yarn : scene.cloth.yarns) {
        yarn.pore_area *= 1e-6;
        yarn.fibre_area *= 1e-6;
        for (WettedPores& face : yarn.on_face) face.retention = closed;
    }
    scene.cloth.by_suction = true; // as caps ask for; nothing wicks
    scene.cloth.crossing[0].between.volume = 1e-6 * base * base * base;
    for (Retention& retention : scene.cloth.crossing[0].between.retention) retention = closed;
    SceneDroplet drop;
    drop.volume = volume;
    drop.centre.z = scene.cloth.half_thickness + std::cbrt(3.0 * volume / (4.0 * pi));
    scene.supply.droplets = {drop};
    scene.caps = {true, angle, pinned ? radian_from_degree(0.1) : angle};
    scene.climate.humidity = humidity;
    scene.climate.vapour = humidity * saturation_concentration(air);
    make_weightless(scene);
    scene.cloth.face_only = true;
    scene.rules.vapour = true;
    return scene;
}

std::vector<VerifyResult> standing_drop_dries(const VerifyValues& v, Backend& backend)
{
    const double volume = cubic_metre_from_ul(value(v, "volume_ul")), angle = radian_from_degree(value(v, "contact_angle_deg"));
    const double air = kelvin_from_celsius(value(v, "temperature_c")), humidity = value(v, "relative_humidity");
    const bool pinned = value(v, "pinned") > 0.5, isothermal = value(v, "isothermal") > 0.5;
    Scene scene = drop_to_dry(volume, angle, pinned, air, humidity);
    scene.rules.heat = !isothermal;
    const double surface = isothermal ? air : insulated_temperature(air, humidity);
    const double difference = saturation_concentration(surface) - scene.climate.vapour;
    const double expected = lifetime_of_drop(volume, angle, pinned, scene.climate.density, vapour_diffusivity(air), difference);
    constexpr int looks = 400;
    scene.rules.network_step = expected / looks;
    backend.load(scene);
    double lived = 0;
    for (int look = 1; look <= 2 * looks; ++look) {
        const double time = expected * look / looks;
        while (backend.advance(time) < time) {}
        const Ledger ledger = backend.frame().ledger;
        if (ledger.water_free > 1e-5 * ledger.water_delivered) lived = time;
    }
    return {{"lifetime_s", lived + 0.5 * expected / looks, expected, 0.02 * expected}};
}

} // namespace

std::vector<VerifyCase> cap_cases()
{
    return {
        {"cap_evaporation",
         "How a contact angle changes what diffuses from a drop, tabled, against Popov's integral.",
         {{"contact_angle_deg", 90, 1, 175, ""}},
         cap_evaporation},
        {"standing_drop_dries",
         "How long a drop stands on cloth that takes nothing in, in still air, against diffusion from its cap: with a line of contact that "
         "stays (pinned 1) or an angle that does; as warm as the air (isothermal 1) or with no heat but the air's.",
         {{"volume_ul", 5, 0.1, 100, ""},
          {"contact_angle_deg", 90, 10, 150, ""},
          whole_number("pinned", 0, 0, 1),
          {"temperature_c", 21, 0, 50, ""},
          {"relative_humidity", 0.65, 0, 0.95, ""},
          whole_number("isothermal", 1, 0, 1)},
         standing_drop_dries},
        {"cap_shape",
         "The tabled shape of a drop on a plate, against Young and Laplace's equation, or a ball's cap where it has no weight.",
         {{"volume_ul", 15, 0.01, 1000, ""}, {"contact_angle_deg", 60, 6, 160, ""}, whole_number("gravity", 1, 0, 1)},
         cap_shape},
        {"cap_spreading",
         "The base of a drop that spreads, against Voinov's and Tanner's law and the limit by inertia over integrated outlines.",
         {{"volume_ul", 5, 0.01, 200, ""}, {"contact_angle_deg", 20, 6, 120, ""}, {"time_s", 0.05, 1e-4, 100, ""}},
         cap_spreading},
        {"cap_pinning",
         "The base of a drop that loses liquid: it stays down to the receding angle, then the angle stays.",
         {{"volume_ul", 10, 0.01, 1000, ""},
          {"contact_angle_deg", 90, 10, 150, ""},
          {"receding_angle_deg", 40, 6, 150, ""},
          {"left_ul", 5, 0.01, 1000, ""},
          whole_number("gravity", 0, 0, 1)},
         cap_pinning}};
}

} // namespace hygroloom
