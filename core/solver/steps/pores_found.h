// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Pores of segments and of the room between yarns as a stage finds them: what they hold, and at what suction.
#pragma once

#include "core/physics/retention.h"
#include "core/solver/segments.h"

namespace hygroloom {

struct PoresFound {
    Retention retention;
    double capacity;    ///< kg
    double saturation;  ///< 0..1
    double suction;     ///< Pa
    HeldBefore settled; ///< when it last did
    double finer;       ///< than the type's dry pores

    HL_FN bool is_connected() const { return saturation > retention.threshold; }
};

struct FindPores {
    const Segments& s;
    double density; ///< kg/m3, of the liquid

    HL_FN double dry_pores(int i, const YarnParameters& yarn) const // m3
    {
        return s.dry_pores != nullptr ? s.dry_pores[i] : yarn.pore_area * s.length[i];
    }
    HL_FN double dry_fibres(int i, const YarnParameters& yarn) const // m3
    {
        return yarn.fibre_area * s.fibre_length(i, yarn);
    }
    /// Share of a segment's pores that no finish keeps dry.
    HL_FN double wettable(int i, const YarnParameters& yarn) const
    {
        return yarn.on_face[s.face_of(s.crossing_of(i), s.is_warp(i))].finish.holds;
    }
    /// Its pores are those that no finish keeps dry.
    HL_FN Swollen swollen(int i) const
    {
        const YarnParameters& yarn = s.yarn_of(i);
        double share_of_room = 0;
        if (s.room != nullptr) {
            const int crossing = s.crossing_of(i);
            share_of_room = each_takes_of_room * s.crossing_at(crossing / s.picks, crossing % s.picks).between.volume;
        }
        Swollen found = swollen_yarn(dry_pores(i, yarn), dry_fibres(i, yarn), s.swelling * s.bound[i], share_of_room);
        found.pores *= wettable(i, yarn);
        return found;
    }
    /// How much finer pores are whose fibres have swollen: the ratio of fibres to pores over that of dry ones.
    HL_FN double tightness(int i, const YarnParameters& yarn) const
    {
        const double fibres = dry_fibres(i, yarn) + (s.swelling > 0 ? s.swelling * s.bound[i] : 0.0);
        return fibres * yarn.pore_area * wettable(i, yarn) * plain_inverse(s.pores[i] * yarn.fibre_area);
    }
    /// How much narrower the room at a crossing is between yarns that have grown.
    HL_FN double narrowness(int crossing, const BetweenParameters& at) const
    {
        return s.swelling > 0 ? at.volume * plain_inverse(s.room[crossing]) : 1.0;
    }
    /// Permeability of that room over that between dry yarns: as the cube of its volume (Kozeny and Carman, skin unchanged).
    HL_FN double permeability_of_room(int crossing, const BetweenParameters& at) const
    {
        if (s.swelling <= 0) return 1.0;
        const double wide = plain_inverse(narrowness(crossing, at));
        return wide * wide * wide;
    }
    /// Permeability over that of dry pores: pores^3 / fibres^2 (Gebart 1992).
    HL_FN double permeability(int i, const YarnParameters& yarn) const
    {
        if (!s.varies()) return 1.0;
        const double wide = s.pores[i] * plain_inverse(yarn.pore_area * wettable(i, yarn) * s.length[i]);
        if (!s.narrows) return wide;
        const double finer = tightness(i, yarn);
        return wide * plain_inverse(finer * finer);
    }
    HL_FN PoresFound segment(int i, const YarnParameters& yarn, int face) const
    {
        const double finer = s.narrows ? tightness(i, yarn) : 1.0;
        return found(yarn.on_face[face].retention, finer, density * s.pores[i], s.liquid[i], {s.settled[i], s.suction[i]});
    }
    HL_FN PoresFound between(int crossing, const BetweenParameters& at, int condition) const
    {
        return found(at.retention[condition], narrowness(crossing, at), density * s.room[crossing], s.between[crossing],
                     {s.between_settled[crossing], s.between_suction[crossing]});
    }
    /// Whether liquid has pervaded a segment.
    HL_FN bool is_connected(int i, bool is_warp, int crossing) const
    {
        const YarnParameters& yarn = s.yarn_of(i);
        return s.liquid[i] > yarn.on_face[s.face_of(crossing, is_warp)].retention.threshold * density * s.pores[i];
    }
    /// Which of a crossing's yarns it has, see room_conditions.
    HL_FN int wet_yarns(int crossing) const
    {
        const int weft = s.weft_of(crossing / s.picks, crossing % s.picks);
        return (is_connected(crossing, true, crossing) ? 1 : 0) + (is_connected(weft, false, crossing) ? 2 : 0);
    }
    /// See room_conditions. What holds more than the rings about its crossings can, is joined, too.
    HL_FN int condition_of_room(int crossing, const BetweenParameters& at, bool liquid_stands) const
    {
        const int wet = wet_yarns(crossing);
        const bool joined = liquid_stands || s.between[crossing] > room_breaks_at(at.retention[wet]) * density * s.room[crossing];
        return wet + (joined ? covered : 0);
    }
    HL_FN static PoresFound found(const Retention& dry, double finer, double capacity, double liquid, const HeldBefore& then)
    {
        // What rounding leaves over the bounds, where a whole line is full or dry, asks for nothing.
        const double share = liquid * plain_inverse(capacity), saturation = share < 0 ? 0.0 : share > 1 ? 1.0 : share;
        const Retention retention = narrowed(dry, finer);
        return {retention, capacity, saturation, suction_after(retention, then, saturation), then, finer};
    }
};

} // namespace hygroloom
