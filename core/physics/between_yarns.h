// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The room between the yarns of a woven layer: one cell for each crossing. Lengths in m, angles in radian.
#pragma once

#include "core/physics/retention.h"
#include "core/physics/wicking.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

constexpr double reference_cosine = 0.8;

/// A yarn where it crosses another. Its section is a racetrack.
struct CrossingYarn {
    double width = 0, height = 0; ///< of the section
    double area = 0;              ///< m2, of the section with its pores
    double length = 0;            ///< along its centreline, from one crossing to the next
    double pitch = 0;             ///< the same along the fabric
    double packing = 0.5;
    double advancing = 0, receding = 0; ///< contact angles

    double outline() const { return pi * std::min(width, height) + 2.0 * std::max(0.0, width - height); }
};

/// Liquid at rest in a room that holds so much: twice the curvature of its menisci, 1/m, where the cosine of both yarns' contact angles is
/// reference_cosine, and by how much that grows with either cosine, which is how its wetted skin grows with the volume that is held.
struct RestingState {
    double curvature = 0, warp = 0, weft = 0;

    double at(double warp_cosine, double weft_cosine) const
    {
        return curvature + warp * (warp_cosine - reference_cosine) + weft * (weft_cosine - reference_cosine);
    }
};
/// What is known of a room, see RoomSuctions.
struct RoomStates {
    RestingState almost, sunk, knee, low, fills, breaks;
};
/// Which yarns of a crossing liquid has pervaded: 1 the warp, 2 the weft, 3 both; 4 more where what the room
/// takes is joined from the first, as liquid stands on a face.
constexpr int room_conditions = 8, both_wet = 3, covered = 4;

/// What a crossing's room holds and lets through.
struct RoomBetweenYarns {
    double volume = 0;                     ///< m3
    double share = 0;                      ///< of the layer
    double pore_radius = 0;                ///< m, twice the volume over the yarns' skin about it
    double warp_skin = 0, weft_skin = 0;   ///< m2, of the yarns beside it
    double faces = 0;                      ///< m2, where it is open
    double along_warp = 0, along_weft = 0; ///< m2, permeabilities
};
constexpr double least_share_of_room = 0.05; ///< of the layer: corners that yarns cannot fill; an assumption

/// Cosine of the contact angle on a yarn whose own pores are full of the liquid (Bico, Thiele and Quere 2002): of the surface, packing is
/// fibre.
inline double cosine_on_wet_yarn(double packing, double angle) { return 1.0 - packing * (1.0 - std::cos(angle)); }

/// The same while its pores are full of air (Cassie and Baxter 1944).
inline double cosine_on_dry_yarn(double packing, double angle) { return packing * (1.0 + std::cos(angle)) - 1.0; }

/// Permeability along one system's direction, m2: narrow slices where a crossed yarn stands in the way, wide ones beside it, one after the
/// other, each by Kozeny and Carman with a constant of 5; derived here. Such slices conduct too little: Stokes flow in drawn plain, rib,
/// twill, basket and satin weaves of equal void came out 1.5 to 3.3 times as large, 1.7 in the middle.
inline double permeability_between(const CrossingYarn& along, const CrossingYarn& across, double thickness, double share,
                                   double pore_radius)
{
    constexpr double least_open = 0.02;
    const double in_the_way = std::min(0.5, across.width / (2.0 * along.pitch));
    const double narrow = std::max(least_open, 1.0 - across.height / thickness - along.area / (across.pitch * thickness));
    const double wide = std::max(least_open, (share - in_the_way * narrow) / (1.0 - in_the_way));
    const double slow = (1.0 - in_the_way) * std::pow(share / wide, 3) + in_the_way * std::pow(share / narrow, 3);
    constexpr double drawn_over_slices = 1.7;
    return drawn_over_slices * share * pore_radius * pore_radius / 20.0 / slow;
}

/// Of the skin of a yarn, advancing or receding.
inline double cosine_on_yarn(const CrossingYarn& yarn, bool is_wet, double CrossingYarn::*angle)
{
    return is_wet ? cosine_on_wet_yarn(yarn.packing, yarn.*angle) : cosine_on_dry_yarn(yarn.packing, yarn.*angle);
}

/// Of a room whose yarns have such angles.
inline RoomSuctions room_suctions(const CrossingYarn& warp, const CrossingYarn& weft, const RoomStates& states, double surface_tension,
                                  int condition, double CrossingYarn::*angle)
{
    const double on_warp = cosine_on_yarn(warp, (condition & 1) != 0, angle), on_weft = cosine_on_yarn(weft, (condition & 2) != 0, angle);
    const auto suction = [&](const RestingState& resting) { return surface_tension * resting.at(on_warp, on_weft); };
    return {suction(states.almost), suction(states.sunk),  suction(states.knee),
            suction(states.low),    suction(states.fills), suction(states.breaks)};
}
inline Retention retention_of_room(const CrossingYarn& warp, const CrossingYarn& weft, const RoomStates& states, double surface_tension,
                                   int condition)
{
    RoomSuctions advancing = room_suctions(warp, weft, states, surface_tension, condition, &CrossingYarn::advancing);
    if ((condition & covered) != 0) advancing.fills = advancing.breaks;
    return retention_of_room(advancing, room_suctions(warp, weft, states, surface_tension, condition, &CrossingYarn::receding));
}

/// Of a room that is not drawn: shares of the mean of its curvatures and of its skin, as in the middle of 25 fabrics that are. The mean is
/// the energy of its surfaces over its volume: what the skin of yarns with a cosine of 0.9 gains, less the two faces.
inline RoomStates states_by_formula(const RoomBetweenYarns& room)
{
    constexpr double cosine = 0.9;
    const double per_volume = 1.0 / room.volume, skin = room.warp_skin + room.weft_skin, mean = (cosine * skin - room.faces) * per_volume;
    const auto state = [&](double of_mean, double of_skin) {
        const double gain = of_skin * per_volume;
        return RestingState{of_mean * mean + gain * skin * (reference_cosine - cosine), gain * room.warp_skin, gain * room.weft_skin};
    };
    return {state(-0.06, 0.38), state(0.02, 0.40), state(0.25, 0.52), state(0.9, 0.7), state(1.5, 0.95), state(1.8, 0.9)};
}

/// Thickness of the layer in m. The room is what the yarns leave of it, at least the corners that they cannot fill. It knows no weave.
inline RoomBetweenYarns room_between(const CrossingYarn& warp, const CrossingYarn& weft, double thickness)
{
    const double layer = thickness * warp.pitch * weft.pitch;
    RoomBetweenYarns room;
    room.volume = std::max(layer - warp.area * warp.length - weft.area * weft.length, least_share_of_room * layer);
    room.share = room.volume / layer;
    const double overlap = warp.width * weft.width;
    const auto skin = [overlap](const CrossingYarn& yarn) { return std::max(0.5 * overlap, yarn.outline() * yarn.length - overlap); };
    room.warp_skin = skin(warp);
    room.weft_skin = skin(weft);
    room.faces = 2.0 * warp.pitch * weft.pitch;
    room.pore_radius = 2.0 * room.volume / (room.warp_skin + room.weft_skin);
    room.along_warp = permeability_between(warp, weft, thickness, room.share, room.pore_radius);
    room.along_weft = permeability_between(weft, warp, thickness, room.share, room.pore_radius);
    return room;
}

} // namespace hygroloom
