// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fibres that bind water swell: yarns grow into the room beside them, then their pores become narrower.
#pragma once

#include "core/solver/steps/pores_found.h"

namespace hygroloom {

/// Never narrows pores below the liquid in them, of which GiveBack takes what is too much. Counts where that is the least given back or
/// more.
struct Swell {
    Segments s;
    double density;
    double least_surplus; ///< kg
    std::int64_t* total;  ///< of segments with so much

    HL_FN std::int64_t operator()(int index) const
    {
        const int i = s.visited_segment(index);
        double pores = FindPores{s, density}.swollen(i).pores;
        s.work0[i] = s.liquid[i] - density * pores;
        if (pores < s.liquid[i] / density) pores = s.liquid[i] / density;
        s.pores[i] = pores;
        return s.work0[i] >= least_surplus;
    }
};

/// What the yarns of a crossing leave of the room between them; never less than the liquid in it, which then lies where the yarns have
/// grown: its volume counts twice until it leaves.
struct NarrowRoom {
    Segments s;
    double density;

    HL_FN void operator()(int index) const
    {
        const int crossing = s.visited_crossing(index), end = crossing / s.picks, pick = crossing % s.picks;
        const FindPores find{s, density};
        const double grown = find.swollen(crossing).grown + find.swollen(s.weft_of(end, pick)).grown;
        const double left = s.crossing_at(end, pick).between.volume - grown, liquid = s.between[crossing] / density;
        s.room[crossing] = left > liquid ? left : liquid;
    }
};

} // namespace hygroloom
