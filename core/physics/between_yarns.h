// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The room between the yarns of a woven layer: one cell for each crossing. Lengths in m, angles in radian.
#pragma once

#include "core/physics/pores.h"

#include <algorithm>

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

/// What a crossing's room holds and lets through.
struct RoomBetweenYarns {
    double volume = 0;      ///< m3
    double share = 0;       ///< of the layer
    double pore_radius = 0; ///< m, twice the volume over the yarns' skin about it
    PoreClosure closure;
    double along_warp = 0, along_weft = 0; ///< m2, permeabilities
};

/// Cosine of the contact angle on a yarn whose own pores are full of the liquid (Bico, Thiele and Quere 2002): of the surface, packing is
/// fibre.
inline double cosine_on_wet_yarn(double packing, double angle) { return 1.0 - packing * (1.0 - std::cos(angle)); }

/// Permeability along one system's direction, m2: narrow slices where a crossed yarn stands in the way, wide ones beside it, one after the
/// other, each by Kozeny and Carman with a constant of 5; derived here. The weakest number of the closure.
inline double permeability_between(const CrossingYarn& along, const CrossingYarn& across, double thickness, double share,
                                   double pore_radius)
{
    constexpr double least_open = 0.02;
    const double in_the_way = std::min(0.5, across.width / (2.0 * along.pitch));
    const double narrow = std::max(least_open, 1.0 - across.height / thickness - along.area / (across.pitch * thickness));
    const double wide = std::max(least_open, (share - in_the_way * narrow) / (1.0 - in_the_way));
    const double slow = (1.0 - in_the_way) * std::pow(share / wide, 3) + in_the_way * std::pow(share / narrow, 3);
    return share * pore_radius * pore_radius / 20.0 / slow;
}

/// Thickness of the layer in m. The room is what the yarns leave of it, at least the corners that they cannot fill.
inline RoomBetweenYarns room_between(const CrossingYarn& warp, const CrossingYarn& weft, double thickness, double surface_tension)
{
    constexpr double corners = 0.05; // of the layer; an assumption
    const double layer = thickness * warp.pitch * weft.pitch;
    RoomBetweenYarns room;
    room.volume = std::max(layer - warp.area * warp.length - weft.area * weft.length, corners * layer);
    room.share = room.volume / layer;
    const double overlap = warp.width * weft.width;
    const double skin = std::max(overlap, warp.outline() * warp.length + weft.outline() * weft.length - 2.0 * overlap);
    room.pore_radius = 2.0 * room.volume / skin;
    const auto on_both = [&](double CrossingYarn::*angle) {
        return 0.5 * (cosine_on_wet_yarn(warp.packing, warp.*angle) + cosine_on_wet_yarn(weft.packing, weft.*angle));
    };
    const double advancing = std::max(0.05, on_both(&CrossingYarn::advancing)), receding = on_both(&CrossingYarn::receding);
    PoreClosure& pores = room.closure;
    pores.shape = 2.0; // round crossing cylinders: the liquid held goes with suction^-2
    pores.entry_suction = surface_tension * advancing / room.pore_radius;
    constexpr double cluster = 1.0 - 0.3701; // sites that percolate on stacked honeycombs leave these
    pores.hysteresis = std::max(1.1, std::pow(cluster, -1.0 / (pores.shape - 1.0)) * receding / advancing);
    const double half_yarn = 0.5 * std::pow(warp.width * warp.height * weft.width * weft.height, 0.25);
    const double meet = warp.pitch * weft.pitch / (16.0 * half_yarn * advancing) / (2.0 * room.pore_radius);
    pores.threshold = std::clamp(meet * meet, 0.1, 0.6); // corners of neighbouring crossings meet
    pores.front_suction = pores.entry_suction * std::pow(pores.threshold, -1.0 / pores.shape);
    room.along_warp = permeability_between(warp, weft, thickness, room.share, room.pore_radius);
    room.along_weft = permeability_between(weft, warp, thickness, room.share, room.pore_radius);
    return room;
}

} // namespace hygroloom
