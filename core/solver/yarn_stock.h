// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the yarns add to a frame: numbers of one time, and their arrays as they were then (see Executor::Snapshot).
#pragma once

#include "core/scene/frame.h"
#include "core/solver/segments.h"
#include "core/solver/steps/shown_cells.h"

#include <vector>

namespace hygroloom {

/// Quanta of water that may add up to more than 64 bits hold, which is half a kilogram.
struct ManyQuanta {
    static constexpr std::int64_t quarter = std::int64_t(1) << 62; ///< of a kilogram
    std::int64_t quarters = 0, rest = 0;

    void add(std::int64_t more) ///< up to a quarter at once
    {
        rest += more;
        if (rest < quarter) return;
        rest -= quarter;
        ++quarters;
    }
    double mass() const { return 0.25 * static_cast<double>(quarters) + static_cast<double>(rest) * water_quantum; } ///< kg
};

struct YarnStock {
    double time = 0;           ///< s
    double initial = 0;        ///< kg, in fibres and pores before the first drop
    double initial_energy = 0; ///< J
    double delivered = 0;      ///< kg, but for what is supplied
    std::int64_t standing = 0; ///< quanta, in pools, caps and films
    std::vector<FrameCap> caps;
    double evaporated = 0;     ///< kg, from what stood on the cloth
    double dripped = 0;        ///< kg, fallen or run off
    double free_until = 0;     ///< s, when liquid last stood on the cloth
    double unsolved_lines = 0; ///< see Frame
    Unvisited unvisited;
    SegmentFields<Shown> segments; ///< empty where cells alone are shown
    Shown<CellSums> cells;         ///< of a garment
    Shown<float> shown_fields;     ///< of a cloth that is shown in cells: see ShownField; its segments are empty
    Shown<ShownSums> shown_lines;  ///< of each of its lines of cells
    Shown<WetEnd> wet;
};

} // namespace hygroloom
