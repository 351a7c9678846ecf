// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Pores of segments and of the room between yarns as a stage finds them: what they hold, and at what suction.
#pragma once

#include "core/physics/retention.h"
#include "core/solver/segments.h"

namespace hygroloom::inline HL_PRECISION {

struct PoresFound {
    Retention retention;
    double capacity;   ///< kg
    double saturation; ///< 0..1
    double suction;    ///< Pa

    HL_FN bool is_connected() const { return saturation > retention.threshold; }
};

struct FindPores {
    const Segments& s;
    double density; ///< kg/m3, of the liquid

    /// How much finer pores are that swell, or have more fibres than their type, in a yarn that keeps its outline: the ratio of fibres to
    /// pores over that of dry ones.
    HL_FN double tightness(int i, const YarnParameters& yarn) const
    {
        const double all = (yarn.pore_area + yarn.fibre_area) * s.length[i], pores = s.pores[i];
        return (all - pores) * yarn.pore_area * plain_inverse(pores * yarn.fibre_area);
    }
    /// Permeability over that of dry pores: pores^3 / fibres^2 (Gebart 1992).
    HL_FN double permeability(int i, const YarnParameters& yarn) const
    {
        if (!s.narrows) return 1.0;
        const double finer = tightness(i, yarn);
        return s.pores[i] * plain_inverse(yarn.pore_area * s.length[i]) * plain_inverse(finer * finer);
    }
    HL_FN Retention retention(int i, const YarnParameters& yarn, int face) const
    {
        const Retention& dry = yarn.on_face[face].retention;
        return s.narrows ? narrowed(dry, tightness(i, yarn)) : dry;
    }
    HL_FN PoresFound segment(int i, const YarnParameters& yarn, int face) const
    {
        return found(retention(i, yarn, face), density * s.pores[i], s.liquid[i], s.suction[i], s.settled[i]);
    }
    HL_FN PoresFound between(int crossing, const BetweenParameters& at) const
    {
        return found(at.retention, density * s.room[crossing], s.between[crossing], s.between_suction[crossing],
                     s.between_settled[crossing]);
    }
    HL_FN static PoresFound found(const Retention& retention, double capacity, double liquid, double suction, double settled)
    {
        // What rounding leaves over the bounds, where a whole line is full or dry, asks for nothing.
        const double share = liquid * plain_inverse(capacity), saturation = share < 0 ? 0.0 : share > 1 ? 1.0 : share;
        return {retention, capacity, saturation, suction_after(retention, {settled, suction}, saturation)};
    }
};

} // namespace hygroloom::inline HL_PRECISION
