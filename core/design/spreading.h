// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How wide yarns lie between two crossings: where the crossed yarns leave them less height they spread as far as the holes have room,
// to keep their area.
#pragma once

#include "core/design/interlacing.h"

#include <algorithm>
#include <vector>

namespace hygroloom {

constexpr int span_samples = 65; ///< of a yarn from crossing to crossing, evenly, both ends among them

/// One yarn over a span, as it crosses another.
struct Spanning {
    Interlacing path; ///< where it changes sides
    Section own;
    double rise = 0;
    double widest = 0;   ///< that its neighbours leave it
    bool changes = true; ///< whether it changes sides at all; else it stays at its rise
};

/// A yarn's section over a span on which it changes sides, half of it: a racetrack of half_height + half_flat by half_height.
struct SpanSections {
    std::vector<double> half_height;
    std::vector<double> half_flat;
    double area_share = 1; ///< mean of the area over that at a crossing

    double half_width(std::size_t sample) const { return half_height[sample] + half_flat[sample]; }
    double mean_width() const;
};
struct SpanPair {
    SpanSections warp, weft;
};

/// How much of the height between two yarns that a set crimp holds apart each leaves to the other.
inline double left_between(const Section& own, double rise, const Section& other, double other_rise)
{
    return std::max(0.0, 0.5 * (rise + other_rise - 0.5 * (own.height + other.height)));
}

/// Of a warp yarn over a weft yarn, each in turn a step further, until it has its area, meets its neighbour or would meet the other's
/// flank where both bend round the hole. A yarn that does not change sides keeps its section.
SpanPair span_sections(const Spanning& warp, const Spanning& weft);

} // namespace hygroloom
