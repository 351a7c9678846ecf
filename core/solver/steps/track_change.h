// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How much segments' saturation changes in a step, for the length of the next one.
#pragma once

#include "core/solver/steps/crossing_exchange.h"
#include "core/solver/steps/ordered_bits.h"

namespace hygroloom {

/// The largest change of saturation since before[], as ordered_bits(); before[] is brought up to date.
struct TrackChange {
    Segments s;
    double density;
    double* before;
    int* largest; ///< null: not wanted
    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        note(change_of(i, before[i]));
    }
    HL_FN void note(float change) const
    {
        if (largest != nullptr && change > 0) atomic_max_of_many(largest, ordered_bits(change));
    }
    HL_FN float change_of(int i, double was) const
    {
        const double change = s.liquid[i] - was;
        if (change == 0) return 0;
        before[i] = s.liquid[i];
        return static_cast<float>((change < 0 ? -change : change) * plain_inverse(density * s.pores[i]));
    }
};

/// What moves at a crossing, and how much its segments have changed then.
struct ExchangeAndTrack {
    ExchangeAtCrossing exchange;
    TrackChange track;

    HL_FN void operator()(int index) const
    {
        const Segments& s = track.s;
        const auto [end, pick] = s.visited_place(index);
        const int a = s.warp_of(end, pick), b = s.weft_of(end, pick);
        const double was_a = track.before[a], was_b = track.before[b]; // under way while liquid and heat are exchanged
        exchange(index);
        const float warp = track.change_of(a, was_a), weft = track.change_of(b, was_b);
        track.note(warp > weft ? warp : weft);
    }
};

} // namespace hygroloom
