// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a cloth holds, lets through and draws in of water of 20 degrees Celsius, from its pores and its drawn room. SI.
#pragma once

#include "core/geometry/textile.h"
#include "core/laboratory/estimate.h"
#include "core/room/room_tables.h"

namespace hygroloom {

/// kg/m2 of water, beyond what fibres hold at 65 % relative humidity.
struct WaterHeld {
    Estimate full;    ///< in all pores and rooms
    Estimate drained; ///< what a sample keeps that hangs so high
    Estimate spun;    ///< what a pack keeps in a spinner
};
constexpr double hanging_height = 0.10; ///< m, DIN 53923
constexpr double spin_acceleration = 350,
                 spin_load = 8.2; ///< in units of gravity; dry kg/m2 of wall, as 10 CFR 430 J3 loads its test cloth
/// Retention curves of yarns and of the room as they empty. Yarns that do not wet take none; the room fills where any yarn wets, else
/// where 5 cm of water press into it. The interval: suctions of the room 20 % either way, packing of yarns 0.05.
WaterHeld water_held(const Textile& textile, const RoomTables& tables);

/// m/sqrt(s), by which a level strip's front goes with the root of time: permeability over suction of yarns and rooms together, integrated
/// up to the suction at which each fills, over the water behind it: in the rooms and in the yarns of both systems. The interval: suctions
/// of the room 20 %, permeabilities 30 % either way.
Estimate wicking_speed(const Textile& textile, const RoomTables& tables, YarnKind along);

/// Pa of water that breaks through. Of repellent yarns: the least of the holes in 100 cm2, by the third (ISO 811): gaps scatter by how
/// uneven the yarns are (`cv`, of the linear density, of both systems). Of yarns that wet under a finished face: what the finish holds off
/// between yarns at their mean distance; 0 without one. The interval: contact angles 10 degrees either way.
Estimate hydrostatic_pressure(const Textile& textile, const RoomTables& tables, double warp_cv, double weft_cv);

} // namespace hygroloom
