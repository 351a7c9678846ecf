// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a weave is like: floats, balance, repeat, and whether it holds together.
#pragma once

#include "core/design/weave.h"

namespace hygroloom {

constexpr double longest_float_mm = 10; ///< longer ones snag; validate() warns

/// Floats of one system on one face, counted round one repeat. A thread that never changes sides has none; see unbound_ends.
struct Floats {
    int longest = 0;         ///< crossings
    std::vector<long> count; ///< count[n]: how many pass over n crossings; count[0] is 0
};

struct WeaveAnalysis {
    Floats warp_face, warp_back; ///< ends over picks, ends under picks
    Floats weft_face, weft_back; ///< picks over ends, picks under ends
    double warp_up_share = 0;    ///< balance: 0.5 when both systems show alike
    long warp_interlacings = 0;  ///< changes of side of all ends in one repeat
    long weft_interlacings = 0;
    int repeat_ends = 0; ///< of the smallest repeat
    int repeat_picks = 0;
    std::vector<int> unbound_ends; ///< never change sides
    std::vector<int> unbound_picks;
    int cloths = 1;   ///< parts of ends and picks that lie on one another without being joined; 1 for a sound cloth
    int top_ends = 0; ///< of the uppermost cloth when there are several
    int top_picks = 0;
};

/// Of any weave; 2000 x 2000 in some tens of milliseconds.
WeaveAnalysis analyse(const Weave& weave);

/// The smallest repeat of the same weave, beginning at the same crossing. The same weave, name and draft included, when it is one already.
Weave reduced(const Weave& weave);

/// The least period p of 0 .. size-1 for which same(i, i + p) holds throughout; it need not divide the size. At least 1, at most size.
template <typename Same> int least_period(int size, Same same)
{
    // Knuth, Morris, Pratt 1977: the period is the size less the longest proper border.
    std::vector<int> border(static_cast<std::size_t>(size) + 1, 0);
    border[0] = -1;
    for (int i = 0, k = -1; i < size;) {
        while (k >= 0 && !same(i, k)) k = border[static_cast<std::size_t>(k)];
        border[static_cast<std::size_t>(++i)] = ++k;
    }
    return size - border[static_cast<std::size_t>(size)];
}

/// The same, but the period divides the size, so that the sequence may be repeated without end.
template <typename Same> int dividing_period(int size, Same same)
{
    const int period = least_period(size, same);
    return size % period == 0 ? period : size;
}

} // namespace hygroloom
