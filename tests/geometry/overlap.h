// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How far the yarns of a textile are drawn into each other.
#pragma once

#include "core/base/units.h"
#include "core/geometry/mesh.h"
#include "core/geometry/textile.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

/// Depth of a point inside the picks, 0 outside: against the pick's section at every place whose cross-plane holds the point.
inline double depth_in_weft(const Textile& t, const Vec3d& p)
{
    constexpr int samples = 100;
    double deepest = 0;
    const int end = std::clamp(static_cast<int>(std::lround(p.x / t.warp.pitch + 0.5 * (t.ends() - 1))), 1, t.ends() - 2);
    for (int pick = 0; pick < t.picks(); ++pick) {
        if (std::abs(p.y - t.y_of_pick(pick)) > t.weft.pitch) continue;
        double before = 0;
        for (int i = -samples; i <= samples; ++i) {
            const int at = i < -samples / 2 ? end - 1 : i > samples / 2 ? end + 1 : end;
            const YarnPoint q = yarn_point(t, YarnKind::weft, pick, at, static_cast<double>(i) / samples - (at - end));
            const Vec3d from = p - q.centre;
            const double along = dot(from, q.tangent);
            const bool passed = i > -samples && (along > 0) != (before > 0); // the point's cross-plane lies between two samples
            before = along;
            if (!passed) continue;
            const double up = from.z * q.tangent.x - from.x * q.tangent.z;
            const double flat = std::max(0.0, q.half_width - q.half_height);
            deepest = std::max(deepest, q.half_height - std::hypot(std::max(std::abs(from.y) - flat, 0.0), up));
        }
    }
    return deepest;
}

/// The deepest that any point of an end's skin lies inside a pick, over the thinner yarn's height.
inline double worst_overlap(const Textile& t)
{
    double worst = 0;
    for (int end = 1; end < t.ends() - 1; ++end)
        for (int pick = 1; pick < t.picks() - 1; ++pick)
            for (int step = -5; step <= 5; ++step) {
                const YarnPoint p = yarn_point(t, YarnKind::warp, end, pick, step / 10.0);
                for (int side = 0; side < 16; ++side) {
                    const SectionPoint s = section_point(p.half_width, p.half_height, 2 * pi * side / 16);
                    const Vec3d skin{p.centre.x + s.across, p.centre.y - p.tangent.z * s.up, p.centre.z + p.tangent.y * s.up};
                    worst = std::max(worst, depth_in_weft(t, skin));
                }
            }
    return worst / std::min(t.warp.types[0].section.height, t.weft.types[0].section.height);
}

} // namespace hygroloom
