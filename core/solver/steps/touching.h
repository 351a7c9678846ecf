// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid between parallel yarns that touch, and through seams.
#pragma once

#include "core/solver/steps/pair_flow.h"

namespace hygroloom {

/// Between neighbours that touch, each pair for itself: pairs after even yarns and after odd ones go one after the other, the other way
/// round in the next step.
struct FlowBetweenTouching : PairFlow {
    bool of_odd;                         ///< pairs whose first yarn is odd
    double warp_lift = 0, weft_lift = 0; ///< Pa, by which suction rises from an end, or pick, to the next; in panels Pa/m of rise

    HL_FN void operator()(int index) const
    {
        const int i = s.visited_segment(index);
        if (!(s.touching[i] > 0)) return;
        const bool is_warp = s.is_warp(i);
        const int line = is_warp ? s.line_of(i) : s.line_of(i) - s.ends;
        const int visited = is_warp ? s.ends - s.unvisited.ends_after : s.picks - s.unvisited.picks_after;
        if ((line % 2 != 0) != of_odd || line + 1 >= visited) return;
        const int j = i + (is_warp ? s.picks : s.ends);
        if (s.liquid[i] <= 0 && s.liquid[j] <= 0) return;
        double lift = is_warp ? warp_lift : weft_lift;
        if (!s.whole()) { // from crossing to crossing along the other system
            const int crossing = s.crossing_of(i);
            lift *= static_cast<double>(s.panels.rise[is_warp ? s.weft_of(crossing / s.picks, crossing % s.picks) : crossing]);
        }
        flow(side(i), side(j), {s.touching[i], 7, lift});
    }
};

/// Through a seam: as along a yarn, and as along the room beside it.
struct FlowThroughSeam : PairFlow {
    const SeamJoint* joints;

    HL_FN void operator()(int index) const
    {
        const SeamJoint& joint = joints[index];
        const int a = s.crossing_of(joint.a), b = s.crossing_of(joint.b);
        if (s.liquid[joint.a] > 0 || s.liquid[joint.b] > 0) flow(side(joint.a), side(joint.b), {joint.yarns, 7, 0, false});
        if (s.between[a] > 0 || s.between[b] > 0) {
            const BetweenParameters& room = s.crossing_at(a / s.picks, a % s.picks).between;
            flow(room_side(a), room_side(b), {joint.rooms, s.is_warp(joint.a) ? room.quarters_along_warp : room.quarters_along_weft, 0});
        }
    }
};

} // namespace hygroloom
