// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a scene needs to know of yarns and of the room between them where liquid flows by suctions: the closure `pores`. SI.
#pragma once

#include "core/geometry/textile.h"
#include "core/physics/between_yarns.h"
#include "core/physics/retention.h"
#include "core/room/room_tables.h"

namespace hygroloom {

/// What the finish of a face leaves of a yarn that lies there, and how it holds off liquid that stands on it. Without one it does nothing.
struct FinishOverPores {
    double conducts = 1;  ///< share of the section that lies under it: no liquid goes along in it
    double holds = 1;     ///< share of the pores that lies under it
    double dry_gate = 1;  ///< over the gate of the pores, of dry ones for what stands on it
    double open = 1;      ///< share of the face's conductance that is open to what has passed it
    double holes = 1;     ///< the same before that
    double passes_at = 0; ///< Pa over the air's, see pressure_past_finish()

    /// Share of the face's conductance that is open to liquid of this pressure over the air's, Pa.
    HL_FN double lets_through(double pressure) const { return pressure >= passes_at ? open : holes; }
};

/// Pores between fibres that have a contact angle.
struct WettedPores {
    Retention retention;
    double gate = 0;          ///< of dry ones, see gate_of_dry_fibres()
    double across = 1;        ///< over that, for what comes across the fibres: see entry_across_fibres()
    double between_hairs = 1; ///< share of dry ones that a drop on the face touches, see share_between_hairs()
    FinishOverPores finish{};

    /// Share of the face's conductance for liquid that stands on it, of this pressure over the air's, Pa.
    HL_FN double lets_in_from_face(bool connected, bool drop, double pressure) const
    {
        const double dry = gate * across * finish.dry_gate * (drop ? between_hairs : 1.0);
        return (connected ? 1.0 : dry) * finish.lets_through(pressure);
    }
};

/// The room between the yarns at a crossing, m3/(Pa s) unless said.
struct BetweenParameters {
    double volume = 0; ///< m3
    Retention retention[room_conditions];
    double along_warp = 0, along_weft = 0;                                                          ///< from one crossing's to the next
    int quarters_along_warp = usual_quarters_of_room, quarters_along_weft = usual_quarters_of_room; ///< power of its saturation in them
    double to_warp = 0, to_weft = 0;                                                                ///< into each yarn beside it
    double yarns = 0;               ///< from the one into the other, where they touch
    double face = 0;                ///< from liquid on one face
    double through = 0;             ///< out of the hole on the other face; 0: there is none
    double holds_back = 0;          ///< Pa over the air's that liquid must exceed to pass there, see breakthrough_pressure()
    double passes_at[2] = {0, 0};   ///< Pa over the air's, of liquid on either face that comes past its finish, at the bottom, on top
    double on_warp[2] = {0.5, 0.5}; ///< share of its liquid that clings to the warp yarn: where that lies below, on top

    /// Of what it lets in, or a yarn below it, the share that liquid of this pressure over the air's, Pa, finds on a face.
    HL_FN double lets_in_from_face(double lets_in, int at_face, double pressure) const
    {
        return pressure >= passes_at[at_face] ? lets_in : 0.0;
    }
};

/// A yarn's pores and what flows in them.
struct YarnBySuction {
    WettedPores at_bottom, on_top; ///< of what lies on either face
    double flow_along = 0;         ///< see YarnParameters
    double face_conductance = 0;
};

/// The liquid's numbers, N/m and Pa s.
struct LiquidInPores {
    double surface_tension, viscosity;
};

/// What the finish of a face keeps dry of a type's yarns where they lie there: nothing where there is none, where its own dry fibres take
/// liquid in, or where it goes through the yarns, whose pores are its own then.
FinishedShares kept_dry(const Textile& textile, const YarnType& type, bool on_top);

/// One type of a textile's warp or weft.
YarnBySuction yarn_by_suction(const YarnType& type, const Textile& textile, YarnKind kind, const LiquidInPores& liquid);

/// Between neighbours that touch, m3/(Pa s): see Cloth::touching.
std::vector<double> contacts_of(const Textile& textile, const LiquidInPores& liquid);

/// Where two types of its yarns cross, by their numbers. drawn: of its weave, if not empty.
BetweenParameters room_of_crossing(const Textile& textile, std::size_t warp, std::size_t weft, const LiquidInPores& liquid,
                                   const RoomTables& drawn);
/// See Cloth::room_along.
std::vector<float> room_along_of(const Textile& textile, const RoomTables& drawn);

} // namespace hygroloom
