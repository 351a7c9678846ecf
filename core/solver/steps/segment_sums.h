// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Small stages of a segment of its own: it takes what was absorbed, and sums up what it stores.
#pragma once

#include "core/scene/frame.h"
#include "core/solver/steps/yarn_lines.h"

namespace hygroloom {

/// Liquid that particles gave since the last step joins the yarn, at the climate's temperature.
struct TakeAbsorbed {
    Segments s;

    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        if (s.between != nullptr && s.is_warp(i)) take(i, 2 * s.crossings() + i, s.between[i]);
        take(i, i, s.liquid[i]);
    }
    /// What a taker absorbed, with the temperature of segment i.
    HL_FN void take(int i, int taker, double& liquid) const
    {
        if (s.absorbed[taker] == 0) return;
        const YarnParameters& yarn = s.yarn_of(i);
        const double added = static_cast<double>(s.absorbed[taker]) * water_quantum;
        const double capacity = heat_capacity(yarn, s.fibre_length(i, yarn), s.warm_water(i));
        s.warmth[i] *= capacity / (capacity + water_specific_heat * added);
        liquid += added;
        s.absorbed[taker] = 0;
    }
};

/// What heat each segment stores, for those who sum up.
struct TakeStock {
    Segments s;
    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        s.stored[i] = heat_capacity(s.yarn_of(i), s.fibre_length(i, s.yarn_of(i)), s.warm_water(i)) * s.warmth[i];
    }
};

/// Sums up what each cell of a garment's frames holds, in the order of its crossings.
struct SeeCells {
    Segments s;
    CellSums* cells;

    HL_FN void operator()(int cell) const
    {
        const int first = cell > 0 ? s.panels.shown_ends[cell - 1] : 0, last = s.panels.shown_ends[cell];
        CellSums sums;
        for (int k = first; k < last; ++k) add_crossing(s.panels.shown[k], sums);
        sums.warmth /= 2 * (last - first);
        cells[cell] = sums;
    }
    HL_FN void add_crossing(int warp, CellSums& sums) const
    {
        const int end = warp / s.picks, pick = warp % s.picks, weft = s.weft_of(end, pick);
        const double between = s.between[warp], clings = s.crossing_at(end, pick).between.on_warp[s.warp_up[warp] != 0];
        const double on_top =
            s.warp_up_share != nullptr ? static_cast<double>(s.warp_up_share[warp]) : static_cast<double>(s.warp_up[warp]);
        const double of_warp = gained(warp) + clings * between, of_weft = gained(weft) + (1 - clings) * between;
        sums.top += on_top * of_warp + (1 - on_top) * of_weft;
        sums.bottom += (1 - on_top) * of_warp + on_top * of_weft;
        sums.liquid += between;
        if (s.on_skin != nullptr) sums.on_skin += static_cast<double>(s.on_skin[warp]) * water_quantum;
        for (const int i : {warp, weft}) {
            sums.liquid += s.liquid[i];
            sums.bound += s.bound[i];
            sums.vapour += s.vapour[i];
            sums.evaporated += s.evaporated[i];
            sums.warmth += s.warmth[i];
            sums.stored += heat_capacity(s.yarn_of(i), s.fibre_length(i, s.yarn_of(i)), s.warm_water(i)) * s.warmth[i];
            sums.released += s.released[i];
            sums.lost += s.lost[i];
        }
    }
    /// kg of liquid and bound water over the start.
    HL_FN double gained(int i) const
    {
        const YarnParameters& yarn = s.yarn_of(i);
        return s.liquid[i] + (s.bound[i] - yarn.initial_regain * s.fibre_length(i, yarn) * yarn.fibre_area * yarn.fibre_density);
    }
};

/// Sums up what the shells of each segment's fibres hold.
struct SumShells {
    Segments s;
    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        s.bound[i] = bound_water(s, s.yarn_of(i), i);
    }
};

} // namespace hygroloom
