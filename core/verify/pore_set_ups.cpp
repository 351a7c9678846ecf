// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/pore_set_ups.h"

#include "core/base/error.h"
#include "core/physics/scattered_gate.h"
#include "core/physics/water.h"

#include <fmt/format.h>

namespace hygroloom {

double FibreBundle::mobility() const { return permeability / (water_viscosity(pore_temperature) * (1.0 - packing)); }
double RoomBeside::mobility() const { return permeability / (water_viscosity(pore_temperature) * porosity); }

FibreBundle fibre_bundle(const VerifyValues& values)
{
    const auto given = [&](const char* name) { return values.count(name) > 0 ? values.at(name).value : 0.0; };
    const double advancing = given("contact_angle_deg"), receding = given("receding_angle_deg"), hysteresis = given("hysteresis");
    if (receding > advancing)
        throw Error(
            fmt::format("receding_angle_deg: A receding angle is at most the contact angle, {}; {} was given.", advancing, receding));
    if (hysteresis > 0 && hysteresis < 1)
        throw Error(fmt::format("hysteresis: Must be at least 1, or 0 for the closure's own; {} was given.", hysteresis));
    FibreBundle bundle;
    bundle.packing = given("packing");
    bundle.fibre_radius = metre_from_um(given("fibre_radius_um"));
    bundle.pores = pores_of_bundle(bundle.packing, bundle.fibre_radius, water_surface_tension(pore_temperature),
                                   radian_from_degree(advancing), radian_from_degree(receding));
    if (hysteresis > 0) bundle.pores.hysteresis = hysteresis;
    bundle.permeability = permeability_along(bundle.fibre_radius, bundle.packing);
    bundle.gate = gate_of_dry_fibres(bundle.packing, radian_from_degree(advancing));
    return bundle;
}

Scene lone_yarn(const FibreBundle& bundle, int cells, double cell)
{
    constexpr double section = 1e-8; // m2; nothing hangs on it
    Scene scene = bare_scene(1, cells, cell, pore_temperature);
    scene.rules.wicking = true;
    scene.cloth.by_suction = true;
    const WettedPores wetted{retention_of(bundle.pores), bundle.gate};
    for (YarnParameters& yarn : scene.cloth.yarns) {
        yarn.fibre_radius = bundle.fibre_radius;
        yarn.fibre_area = bundle.packing * section;
        yarn.pore_area = (1.0 - bundle.packing) * section;
        yarn.on_face[0] = yarn.on_face[1] = wetted;
    }
    scene.cloth.yarns[0].flow_along = bundle.permeability * section / scene.climate.viscosity;
    BetweenParameters& between = scene.cloth.crossing[0].between;
    between.volume = section * cell;
    std::fill(std::begin(between.retention), std::end(between.retention), wetted.retention);
    scene.cloth.start.liquid.assign(static_cast<std::size_t>(scene.cloth.segments()), 0.0);
    scene.cloth.start.between.assign(static_cast<std::size_t>(cells), 0.0);
    std::fill(scene.cloth.start.liquid.begin() + cells, scene.cloth.start.liquid.end(), cell_capacity(scene));
    return scene;
}

void open_rooms(Scene& scene, const RoomBeside& room)
{
    const double section = 1e-8, cell = scene.cloth.length[0];
    BetweenParameters& between = scene.cloth.crossing[0].between;
    between.volume = room.porosity * section * cell;
    Retention retention = retention_of(room.pores);
    retention.gives = retention.emptying; // its menisci stand until it empties
    std::fill(std::begin(between.retention), std::end(between.retention), retention);
    between.along_warp = room.permeability * section / (scene.climate.viscosity * cell);
    between.quarters_along_warp = 8; // halves, as its curve is one of pores between fibres
}

double cell_capacity(const Scene& scene) { return scene.climate.density * scene.cloth.yarns[0].pore_area * scene.cloth.length[0]; }
double room_capacity(const Scene& scene) { return scene.climate.density * scene.cloth.crossing[0].between.volume; }

std::vector<double> saturations(const Frame& frame, const Scene& scene)
{
    return {frame.saturation.begin(), frame.saturation.begin() + scene.cloth.picks};
}
std::vector<double> room_saturations(const Frame& frame, const Scene& scene)
{
    std::vector<double> all;
    all.reserve(static_cast<std::size_t>(scene.cloth.picks));
    for (int i = 0; i < scene.cloth.picks; ++i) // half of a room's liquid is shown with each of its yarns
        all.push_back(2.0 * static_cast<double>(frame.between[i]) / room_capacity(scene));
    return all;
}

double wet_length(const std::vector<double>& saturation, double threshold, double cell)
{
    double length = 0;
    for (double s : saturation) length += cell * std::min(1.0, s / threshold);
    return length;
}

namespace {

/// From the front to the first full pores for a front at y sqrt(t).
struct FrontProfile {
    double full = 0;  ///< y of the first full pores; 0: there are none
    double taken = 0; ///< I
};
template <typename Diffusivity> FrontProfile profile_behind(double front, double threshold, const Diffusivity& diffusivity)
{
    constexpr int steps = 4000;
    const double ds = (1.0 - threshold) / steps;
    double y = front, taken = front * threshold;
    for (int i = 0; i < steps; ++i) { // Runge and Kutta
        const double s = threshold + i * ds;
        const auto slope = [&](double at, double all) { return -2.0 * diffusivity(at) / all; };
        const double a = slope(s, taken), b = slope(s + 0.5 * ds, taken + 0.5 * ds * y);
        const double c = slope(s + 0.5 * ds, taken + 0.5 * ds * (y + 0.5 * ds * a));
        const double d = slope(s + ds, taken + ds * (y + 0.5 * ds * b));
        taken += ds * (y + ds * (a + b + c) / 6.0);
        y += ds * (a + 2 * b + 2 * c + d) / 6.0;
        if (y <= 0) return {};
    }
    return {y, taken};
}

} // namespace

SuppliedFront supplied_front(const PoreClosure& pores, double mobility, double power)
{
    const double at_full = mobility * pores.entry_suction;
    const auto diffusivity = [&](double s) {
        const double connected = std::max(0.0, (s - pores.threshold) / (1.0 - pores.threshold));
        return at_full / pores.shape * std::pow(connected, power) * std::pow(s, -1.0 - 1.0 / pores.shape);
    };
    double low = 0, high = 20.0 * std::sqrt(at_full / pores.threshold), front = high;
    FrontProfile profile;
    for (int i = 0; i < 60; ++i) {
        front = 0.5 * (low + high);
        profile = profile_behind(front, pores.threshold, diffusivity);
        (profile.full > 0 && at_full / profile.full < 0.5 * profile.taken ? high : low) = front;
    }
    return {front * front, profile.full / front};
}

} // namespace hygroloom
