// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A cloth is squeezed: liquid that has no place in pressed pores leaves it.
#pragma once

#include "core/solver/segments.h"

namespace hygroloom {

/// Pores keep a share of their volume for a moment, then are as they were. What has no place then leaves with its heat; adds it up, quanta.
struct PressOut {
    Segments s;
    double density;
    double share;
    std::int64_t* total;

    HL_FN std::int64_t operator()(int index) const
    {
        const int i = s.visited_segment(index);
        std::int64_t pressed = press(i, s.pores[i], s.liquid[i]);
        if (s.between == nullptr || s.is_warp(i) != s.room_with_warp) return pressed;
        const int crossing = s.crossing_of(i);
        return pressed + press(i, s.room[crossing], s.between[crossing]);
    }
    /// Of liquid that is as warm as segment i.
    HL_FN std::int64_t press(int i, double pores, double& liquid) const
    {
        const double surplus = liquid - density * share * pores;
        if (surplus < water_quantum) return 0;
        const auto quanta = static_cast<std::int64_t>(surplus / water_quantum);
        const double mass = static_cast<double>(quanta) * water_quantum;
        liquid -= mass;
        s.lost[i] += water_specific_heat * mass * s.warmth[i];
        return quanta;
    }
};

} // namespace hygroloom
