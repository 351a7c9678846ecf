// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/laboratory/wet_cloth.h"

#include "core/base/units.h"
#include "core/physics/pores.h"
#include "core/physics/water.h"
#include "core/scene/suction.h"

#include <cmath>

namespace hygroloom {
namespace {

const double room_temperature = kelvin_from_celsius(20);
LiquidInPores water() { return {water_surface_tension(room_temperature), water_viscosity(room_temperature)}; }
double density() { return water_density(room_temperature); }

/// How far off what is known of a cloth may be.
struct Off {
    double room_suctions = 1; ///< factor
    double packing = 0;       ///< more
    double permeability = 1;  ///< factor
};

/// Of a square metre.
struct Pores {
    double yarns = 0, room = 0, bound = 0; ///< m3
    Retention of_yarn[2], of_room;
    double yarn_share[2] = {0, 0}; ///< of the yarns' pores that is the warp's, the weft's; 0 where these do not wet
    bool room_fills = false;       ///< in a bath
    double solid_depth = 0;        ///< m of cloth for each kg/m2
};

Retention scaled_suctions(Retention pores, double by) { return narrowed(pores, by); }

bool wets(const Textile& textile, YarnKind kind)
{
    return yarn_by_suction(textile.system(kind).types[0], textile, kind, water()).on_top.gate > 0;
}

/// Of the room beside yarns that liquid has pervaded where they wet.
Retention retention_of_room(const Textile& textile, const BetweenParameters& between)
{
    const int warp = 1, weft = 2; // see room_conditions
    return between.retention[(wets(textile, YarnKind::warp) ? warp : 0) + (wets(textile, YarnKind::weft) ? weft : 0)];
}

Pores pores_of(const Textile& textile, const RoomTables& tables, const Off& off)
{
    constexpr double bath_depth = 0.05; // m: what presses on a sample that lies in water
    Pores pores;
    double fibre = 0; // kg
    for (const YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        YarnType type = textile.system(kind).types[0];
        type.packing = std::min(0.95, type.packing + off.packing);
        const double length = type.length_per_pitch[0] / textile.system(kind).pitch;
        const double own = wets(textile, kind) ? length * type.area * (1 - type.packing) : 0.0;
        const int i = kind == YarnKind::warp ? 0 : 1;
        pores.of_yarn[i] = yarn_by_suction(type, textile, kind, water()).on_top.retention;
        pores.yarn_share[i] = own;
        pores.yarns += own;
        const double kg = length * textile.system(kind).types[0].area * textile.system(kind).types[0].packing * type.fibre.density_kg_m3;
        fibre += kg;
        if (own > 0) pores.bound += kg * std::max(0.0, type.fibre.saturation_regain - type.fibre.standard_regain) / density();
    }
    if (pores.yarns > 0)
        for (double& share : pores.yarn_share) share /= pores.yarns;
    const BetweenParameters between = room_of_crossing(textile, 0, 0, water(), tables);
    pores.room = between.volume / (textile.warp.pitch * textile.weft.pitch);
    pores.of_room = scaled_suctions(retention_of_room(textile, between), off.room_suctions);
    // Water of a bath stands on both faces and wets the yarns: it shuts no air in between them.
    pores.room_fills = pores.yarns > 0 || pores.of_room.front > -density() * gravity_acceleration * bath_depth;
    pores.solid_depth = textile.thickness / fibre;
    return pores;
}

/// Mean of what emptying pores hold from no suction up to one that grows in proportion to the place.
double mean_held(const Retention& pores, double most)
{
    constexpr int places = 100;
    double sum = 0;
    for (int i = 0; i < places; ++i) sum += held_emptying(pores, most * (i + 0.5) / places).saturation;
    return sum / places;
}

/// kg. Fibres that have taken water in leave less of the room.
double held(const Pores& pores, double most_suction)
{
    const double in_yarns =
        pores.yarn_share[0] * mean_held(pores.of_yarn[0], most_suction) + pores.yarn_share[1] * mean_held(pores.of_yarn[1], most_suction);
    const double room = pores.room_fills ? std::max(0.0, pores.room - pores.bound) * mean_held(pores.of_room, most_suction) : 0.0;
    return density() * (pores.yarns * in_yarns + std::min(pores.bound, pores.room) + room);
}

/// kg of a sample that has just left the bath.
double full(const Pores& pores) { return density() * (pores.yarns + (pores.room_fills ? pores.room : std::min(pores.bound, pores.room))); }

/// What flows along one system: integral of permeability over suction, and water behind the front; both of a square metre's width and
/// depth.
struct Wicking {
    double drives = 0, fills = 0;
};
Wicking wicking_of_yarns(const Textile& textile, YarnKind along)
{
    const YarnKind across = other_kind(along);
    const auto pores_in = [&](YarnKind kind) { // m of a square metre; those across the front drink, too
        const YarnType& of = textile.system(kind).types[0];
        return wets(textile, kind) ? of.area * (1 - of.packing) * of.length_per_pitch[0] / textile.system(kind).pitch : 0.0;
    };
    const YarnType& type = textile.system(along).types[0];
    const YarnBySuction yarn = yarn_by_suction(type, textile, along, water());
    const Retention& pores = yarn.on_top.retention;
    if (!(yarn.on_top.gate > 0)) return {};
    constexpr int places = 400;
    const double step = pores.front / places;
    double integral = 0;
    for (int i = 0; i < places; ++i)
        integral += step * share_of_permeability(held_filling(pores, step * (i + 0.5)).saturation, pores.threshold, 7);
    const double pitch = textile.system(along).pitch, longer = type.length_per_pitch[0];
    return {yarn.flow_along * integral / (pitch * longer), pores_in(along) + pores_in(across)};
}
Wicking wicking_of_room(const Textile& textile, const RoomTables& tables, YarnKind along, const Off& off)
{
    const BetweenParameters between = room_of_crossing(textile, 0, 0, water(), tables);
    const Retention pores = scaled_suctions(retention_of_room(textile, between), off.room_suctions);
    if (!(pores.front > 0)) return {};
    const bool warp = along == YarnKind::warp;
    constexpr int places = 200;
    const double step = pores.front / places;
    double integral = 0;
    for (int i = 0; i < places; ++i)
        integral += step * share_of_permeability_of_room(held_filling(pores, step * (i + 0.5)).saturation,
                                                         warp ? between.quarters_along_warp : between.quarters_along_weft);
    const double length = warp ? textile.weft.pitch : textile.warp.pitch, width = warp ? textile.warp.pitch : textile.weft.pitch;
    const double conducts = (warp ? between.along_warp : between.along_weft) * length / width; // of a metre's width
    return {conducts * integral, between.volume / (length * width) * held_filling(pores, 0.5 * pores.front).saturation};
}

double wicking(const Textile& textile, const RoomTables& tables, YarnKind along, const Off& off)
{
    const Wicking yarns = wicking_of_yarns(textile, along), room = wicking_of_room(textile, tables, along, off);
    const double fills = yarns.fills + room.fills;
    return fills > 0 ? std::sqrt(2 * off.permeability * (yarns.drives + room.drives) / fills) : 0.0;
}

/// Of a standard normal number, what so small a share exceeds.
double exceeded_by(double share)
{
    double low = 0, high = 10;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(middle / std::sqrt(2.0)) > share ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double breaks_through(const Textile& textile, double warp_cv, double weft_cv, double off)
{
    constexpr double sample = 0.01, third = 3; // m2; drops
    const double holes = sample / (textile.warp.pitch * textile.weft.pitch), sigmas = holes > 2 * third ? exceeded_by(third / holes) : 0;
    const YarnType &warp = textile.warp.types[0], &weft = textile.weft.types[0];
    // Widths go with the root of the linear density, and a gap with the mean of two.
    const auto half_gap = [&](const YarnType& type, double pitch, double cv) {
        const double spread = 0.5 * cv * type.section.width / std::sqrt(2.0); // of a gap
        // Both gaps of a hole are wide together less often than each: this far of each is as rare as so far of one.
        return 0.5 * std::max(0.0, pitch - type.section.width + sigmas / std::sqrt(2.0) * spread);
    };
    const auto angle = [&](const YarnType& type) { // as room_of_crossing() has it
        return std::clamp(textile.back_angle.value_or(type.contact_angle) + off, 0.0, pi);
    };
    return breakthrough_pressure(water().surface_tension, 0.5 * (angle(warp) + angle(weft)), 0.5 * warp.section.height,
                                 half_gap(warp, textile.warp.pitch, warp_cv), 0.5 * weft.section.height,
                                 half_gap(weft, textile.weft.pitch, weft_cv));
}

/// What the better finish of both faces holds off; 0: none does.
double passes_finishes(Textile textile, const RoomTables& tables, double off)
{
    for (std::optional<double>* angle : {&textile.face_angle, &textile.back_angle})
        if (*angle) **angle = std::clamp(**angle + off, 0.0, pi);
    const BetweenParameters between = room_of_crossing(textile, 0, 0, water(), tables);
    return std::max(between.passes_at[0], between.passes_at[1]);
}

} // namespace

WaterHeld water_held(const Textile& textile, const RoomTables& tables)
{
    const Pores given = pores_of(textile, tables, {}), loose = pores_of(textile, tables, {1, -0.05}),
                close = pores_of(textile, tables, {1, 0.05}), weak = pores_of(textile, tables, {0.8}),
                strong = pores_of(textile, tables, {1.2});
    const double hangs = density() * gravity_acceleration * hanging_height;
    const double spins = density() * gravity_acceleration * spin_acceleration * spin_load * given.solid_depth;
    const auto estimate = [&](const auto& of) { return estimate_of(of(given), {{of(loose), of(close)}, {of(weak), of(strong)}}); };
    return {estimate([](const Pores& pores) { return full(pores); }), estimate([&](const Pores& pores) { return held(pores, hangs); }),
            estimate([&](const Pores& pores) { return held(pores, spins); })};
}

Estimate wicking_speed(const Textile& textile, const RoomTables& tables, YarnKind along)
{
    const double given = wicking(textile, tables, along, {});
    if (!(given > 0)) return {};
    const auto with = [&](const Off& off) { return wicking(textile, tables, along, off); };
    return estimate_of(given, {{with({0.8}), with({1.2})}, {with({1, 0, 0.7}), with({1, 0, 1.3})}});
}

Estimate hydrostatic_pressure(const Textile& textile, const RoomTables& tables, double warp_cv, double weft_cv)
{
    const bool draws = wets(textile, YarnKind::warp) || wets(textile, YarnKind::weft); // yarns, through the cloth
    const auto holds = [&](double off) {
        return draws ? passes_finishes(textile, tables, off) : breaks_through(textile, warp_cv, weft_cv, off);
    };
    const double off = radian_from_degree(10);
    return {holds(0), holds(-off), holds(off)};
}

} // namespace hygroloom
