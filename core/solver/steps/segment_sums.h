// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Small stages of a segment of its own: it takes what was absorbed, and sums up what it stores.
#pragma once

#include "core/solver/steps/yarn_lines.h"

namespace hygroloom::inline HL_PRECISION {

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
        const double capacity = heat_capacity(yarn, s.length[i], s.warm_water(i));
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
        s.stored[i] = heat_capacity(s.yarn_of(i), s.length[i], s.warm_water(i)) * s.warmth[i];
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

} // namespace hygroloom::inline HL_PRECISION
