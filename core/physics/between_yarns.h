// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The room between the yarns of a woven layer: one cell for each crossing. Lengths in m, angles in radian.
#pragma once

#include "core/physics/wicking.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

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

/// Suctions of a crossing's room, Pa. A full room has two free faces, one on either side of the cloth, and they cost what the wetted skin
/// of the yarns gains; where they cost more, only liquid that presses fills it.
struct RoomSuctions {
    double filling = 0;  ///< at which a dry room fills
    double emptying = 0; ///< at which a full one has emptied to a half
};
/// Which yarns of a crossing liquid has pervaded: 1 the warp, 2 the weft, 3 both.
constexpr int wet_states = 4, both_wet = 3;

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

/// Of a room, from the energy of its surfaces: what the skin of the yarns gains, less the two faces, over the volume is the mean of the
/// suctions at which it fills. It fills all at once at 1.18 times that: seen in diffuse-interface computations of two fabrics, and within
/// 15 % of it in five more. state: see wet_states.
inline RoomSuctions room_suctions(const CrossingYarn& warp, const CrossingYarn& weft, const RoomBetweenYarns& room, double surface_tension,
                                  int state)
{
    constexpr double fills_at = 1.18;                                                      // of the mean
    const auto gains = [](const CrossingYarn& yarn, double skin, double angle, bool wet) { // m2
        return skin * (wet ? cosine_on_wet_yarn(yarn.packing, angle) : cosine_on_dry_yarn(yarn.packing, angle));
    };
    const auto suction = [&](double CrossingYarn::*angle) {
        const double all = gains(warp, room.warp_skin, warp.*angle, (state & 1) != 0) +
                           gains(weft, room.weft_skin, weft.*angle, (state & 2) != 0) - room.faces;
        return fills_at * surface_tension * all / room.volume;
    };
    const double filling = suction(&CrossingYarn::advancing);
    return {filling, std::max(filling, suction(&CrossingYarn::receding))};
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
