// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/suction.h"

#include "core/geometry/face_angles.h"
#include "core/physics/between_yarns.h"
#include "core/physics/scattered_gate.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// Curves need an angle at which the pores hold something; the gate keeps dry ones dry from less than this on.
double angle_of_curves(double angle) { return std::min(angle, radian_from_degree(85)); }

/// Of fibres that have as much skin for their section: what is not round counts as finer.
double fibre_radius(const YarnType& type) { return metre_from_um(type.fibre.fibre_radius_um) / type.perimeter_factor; }

double across_per_viscosity(const YarnType& type, const LiquidInPores& liquid)
{
    return permeability_across(fibre_radius(type), type.packing_round_core()) / liquid.viscosity;
}

/// Contact angles on one face, advancing and receding; a finish keeps the fibre's difference of both.
struct Angles {
    double advancing, receding;
};
Angles angles_on(const YarnType& type, const std::optional<double>& finish)
{
    if (!finish) return {type.contact_angle, std::min(type.receding_angle, type.contact_angle)};
    return {*finish, std::max(0.0, *finish - (type.contact_angle - type.receding_angle))};
}
Angles for_curves(const Angles& angles)
{
    const double advancing = angle_of_curves(angles.advancing);
    return {advancing, std::min(angles.receding, advancing)};
}

WettedPores wetted_pores(const YarnType& type, const Angles& angles, const LiquidInPores& liquid, double between_hairs)
{
    const Angles held = for_curves(angles);
    const double packing = type.packing_round_core(), radius = fibre_radius(type), through = permeability_across(radius, packing);
    const double along_over_across = through > 0 ? permeability_along_random(radius, packing) / through : 0.0;
    return {retention_of(pores_of_bundle(packing, radius, liquid.surface_tension, held.advancing, held.receding)),
            gate_of_dry_fibres(packing, angles.advancing),
            entry_across_fibres(packing, angles.advancing, along_over_across, type.area, type.mouths_apart), between_hairs};
}

/// Pa: see pressure_past_finish(), of the slots between ends of a type and between picks of another. 0: the finish wets.
double passes_finish_at(const Textile& textile, double angle, const YarnType& warp, const YarnType& weft, const LiquidInPores& liquid)
{
    if (std::max(gate_of_dry_fibres(warp.packing_round_core(), angle), gate_of_dry_fibres(weft.packing_round_core(), angle)) > 0) return 0;
    const auto slot = [&](const YarnType& type, double pitch) {
        return pressure_past_finish(liquid.surface_tension, angle, 0.5 * type.section.height,
                                    std::max(0.0, 0.5 * (pitch - type.section.width)), textile.quantities.finish_depth * textile.thickness);
    };
    return 0.5 * (slot(warp, textile.warp.pitch) + slot(weft, textile.weft.pitch));
}

/// Whether a finish leaves a core of a yarn that lies on its face.
bool leaves_core(const Textile& textile, const YarnType& type, const std::optional<double>& finish)
{
    return finish && !shares_in_finish(textile, type).goes_through();
}

/// Of a yarn that lies on a face. A finish that wets lets liquid through as readily as its own dry fibres do, and the yarn is whole.
WettedPores pores_on_face(const YarnType& type, const Textile& textile, YarnKind kind, bool on_top, const LiquidInPores& liquid)
{
    const std::optional<double>& finish = on_top ? textile.face_angle : textile.back_angle;
    const double between_hairs = share_between_hairs(textile.quantities.hair_surface);
    if (!leaves_core(textile, type, finish)) return wetted_pores(type, angles_on(type, finish), liquid, between_hairs);
    WettedPores pores = wetted_pores(type, angles_on(type, {}), liquid, between_hairs);
    FinishOverPores& over = pores.finish;
    if (const double gate = gate_of_dry_fibres(type.packing_round_core(), *finish); gate > 0) {
        over.dry_gate = pores.gate > gate ? gate / pores.gate : 1.0;
        return pores;
    }
    const FinishedShares dry = kept_dry(textile, type, on_top);
    const bool is_warp = kind == YarnKind::warp;
    const YarnType& other = textile.system(other_kind(kind)).types.front();
    over.conducts = 1.0 - dry.crown;
    over.holds = 1.0 - dry.section;
    over.open = std::max(over.conducts, textile.quantities.finish_holes);
    over.holes = textile.quantities.finish_holes;
    over.passes_at = passes_finish_at(textile, *finish, is_warp ? type : other, is_warp ? other : type, liquid);
    return pores;
}

/// Its angles are the mean over its outline on both faces.
CrossingYarn crossing_yarn(const YarnType& type, const Textile& textile, double pitch, std::size_t crossed)
{
    const Angles own = for_curves(angles_on(type, {}));
    const double in_finish = textile.back_angle || textile.face_angle ? shares_in_finish(textile, type).outline : 0.0;
    Angles mean{};
    for (const std::optional<double>& finish : {textile.back_angle, textile.face_angle}) {
        const Angles there = for_curves(angles_on(type, finish));
        mean.advancing += 0.5 * ((1.0 - in_finish) * own.advancing + in_finish * there.advancing);
        mean.receding += 0.5 * ((1.0 - in_finish) * own.receding + in_finish * there.receding);
    }
    return {type.section.width,        type.section.height, type.area,    pitch * type.length_per_pitch[crossed], pitch,
            type.packing_round_core(), mean.advancing,      mean.receding};
}

/// How much of the room's liquid a yarn on a face attracts, beside others: its skin times the work by which that wets. Derived here.
double attraction(const YarnType& type, const Textile& textile, double skin, const std::optional<double>& finish)
{
    const auto wets = [](double angle) { return std::max(0.0, std::cos(angle)); };
    const double in_finish = finish ? shares_in_finish(textile, type).outline : 0.0;
    return skin * ((1.0 - in_finish) * wets(type.contact_angle) + (finish ? in_finish * wets(*finish) : 0.0));
}

} // namespace

FinishedShares kept_dry(const Textile& textile, const YarnType& type, bool on_top)
{
    const std::optional<double>& finish = on_top ? textile.face_angle : textile.back_angle;
    if (!leaves_core(textile, type, finish) || gate_of_dry_fibres(type.packing_round_core(), *finish) > 0) return {};
    return shares_in_finish(textile, type);
}

YarnBySuction yarn_by_suction(const YarnType& type, const Textile& textile, YarnKind kind, const LiquidInPores& liquid)
{
    const double across = across_per_viscosity(type, liquid),
                 along = permeability_along_random(fibre_radius(type), type.packing_round_core());
    const double pitch = textile.system(other_kind(kind)).pitch;
    return {pores_on_face(type, textile, kind, false, liquid), pores_on_face(type, textile, kind, true, liquid),
            along * (type.area - type.core_area()) / (liquid.viscosity * type.helix_tortuosity),
            type.section.width * pitch * across / (0.25 * type.section.height)};
}

std::vector<double> contacts_of(const Textile& textile, const LiquidInPores& liquid)
{
    std::vector<double> contacts(static_cast<std::size_t>(textile.segments()));
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft})
        for (int end = 0; end < textile.ends(); ++end)
            for (int pick = 0; pick < textile.picks(); ++pick) {
                if (!textile.touches_next(kind, end, pick)) continue;
                const int yarn = kind == YarnKind::warp ? end : pick;
                const YarnType &a = textile.type(kind, yarn), &b = textile.type(kind, yarn + 1);
                const double across_a = across_per_viscosity(a, liquid), across_b = across_per_viscosity(b, liquid);
                if (!(across_a > 0 && across_b > 0)) continue;
                // From axis to axis, over half of the lower one's height.
                const double per_length = 0.5 * std::min(a.section.height, b.section.height) /
                                          (0.5 * a.section.width / across_a + 0.5 * b.section.width / across_b);
                contacts[static_cast<std::size_t>(textile.segment(kind, end, pick))] = per_length * textile.segment_length(kind, end, pick);
            }
    const bool any = std::any_of(contacts.begin(), contacts.end(), [](double contact) { return contact > 0; });
    return any ? contacts : std::vector<double>();
}

BetweenParameters room_of_crossing(const Textile& textile, std::size_t warp_number, std::size_t weft_number, const LiquidInPores& liquid,
                                   const RoomTables& drawn)
{
    const YarnType &warp_type = textile.warp.types[warp_number], &weft_type = textile.weft.types[weft_number];
    const double thickness = textile.thickness;
    const CrossingYarn warp = crossing_yarn(warp_type, textile, textile.weft.pitch, weft_number),
                       weft = crossing_yarn(weft_type, textile, textile.warp.pitch, warp_number);
    RoomBetweenYarns room = room_between(warp, weft, thickness);
    RoomStates states = states_by_formula(room);
    BetweenParameters between;
    if (!drawn.types.empty()) {
        const DrawnRoom& found = drawn.types[warp_number * textile.weft.types.size() + weft_number];
        room.warp_skin = found.warp_skin;
        room.weft_skin = found.weft_skin;
        room.faces = found.faces;
        room.along_warp = found.along_warp;
        room.along_weft = found.along_weft;
        states = found.states;
        between.quarters_along_warp = static_cast<int>(std::lround(4 * drawn.falls_along_warp));
        between.quarters_along_weft = static_cast<int>(std::lround(4 * drawn.falls_along_weft));
    }
    const double overlap = warp.width * weft.width;
    const double across_warp = across_per_viscosity(warp_type, liquid), across_weft = across_per_viscosity(weft_type, liquid);
    const auto into = [](const CrossingYarn& yarn, double skin, double across) { return skin * across / (0.25 * yarn.height); };
    between.volume = room.volume;
    for (int condition = 0; condition < room_conditions; ++condition)
        between.retention[condition] = retention_of_room(warp, weft, states, liquid.surface_tension, condition);
    between.along_warp = room.along_warp * thickness * weft.pitch / (liquid.viscosity * warp.pitch);
    between.along_weft = room.along_weft * thickness * warp.pitch / (liquid.viscosity * weft.pitch);
    between.to_warp = into(warp, room.warp_skin, across_warp);
    between.to_weft = into(weft, room.weft_skin, across_weft);
    if (across_warp > 0 && across_weft > 0) between.yarns = overlap / (0.5 * warp.height / across_warp + 0.5 * weft.height / across_weft);
    const double open = std::max(0.0, weft.pitch - warp.width) * std::max(0.0, warp.pitch - weft.width);
    const double seen = open + 0.1 * warp.pitch * weft.pitch; // of the room from a face; the tenth is an assumption
    between.face = seen * std::min(room.along_warp, room.along_weft) / (liquid.viscosity * 0.5 * thickness);
    if (open > 0) {
        const auto angle = [&](const YarnType& type) { return angles_on(type, textile.back_angle).advancing; };
        between.through = open * std::min(room.along_warp, room.along_weft) / (liquid.viscosity * 0.5 * thickness);
        between.holds_back = breakthrough_pressure(liquid.surface_tension, 0.5 * (angle(warp_type) + angle(weft_type)), 0.5 * warp.height,
                                                   0.5 * (weft.pitch - warp.width), 0.5 * weft.height, 0.5 * (warp.pitch - weft.width));
    }
    if (textile.back_angle) between.passes_at[0] = passes_finish_at(textile, *textile.back_angle, warp_type, weft_type, liquid);
    if (textile.face_angle) between.passes_at[1] = passes_finish_at(textile, *textile.face_angle, warp_type, weft_type, liquid);
    for (bool warp_up : {false, true}) {
        const std::optional<double>&of_warp = warp_up ? textile.face_angle : textile.back_angle,
              &of_weft = warp_up ? textile.back_angle : textile.face_angle;
        const double by_warp = std::max(0.0, attraction(warp_type, textile, room.warp_skin, of_warp)),
                     by_weft = std::max(0.0, attraction(weft_type, textile, room.weft_skin, of_weft));
        if (by_warp + by_weft > 0) between.on_warp[warp_up] = by_warp / (by_warp + by_weft);
    }
    return between;
}

std::vector<float> room_along_of(const Textile& textile, const RoomTables& drawn)
{
    std::vector<float> along;
    if (drawn.warp_places.empty()) return along;
    along.resize(static_cast<std::size_t>(textile.segments()));
    for (int end = 0; end < textile.ends(); ++end)
        for (int pick = 0; pick < textile.picks(); ++pick) {
            const auto place =
                static_cast<std::size_t>((textile.first_end + end) % drawn.ends * drawn.picks + (textile.first_pick + pick) % drawn.picks);
            along[static_cast<std::size_t>(textile.segment(YarnKind::warp, end, pick))] = drawn.warp_places[place];
            along[static_cast<std::size_t>(textile.segment(YarnKind::weft, end, pick))] = drawn.weft_places[place];
        }
    return along;
}

} // namespace hygroloom
