// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/yarn_stations.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

YarnStations::YarnStations(const Textile& textile, YarnKind kind, int yarn, double spacing, int beyond)
{
    const bool is_warp = kind == YarnKind::warp;
    const int each = std::max(8, static_cast<int>(std::ceil(textile.system(other_kind(kind)).pitch / spacing)));
    for (int at = -beyond; at < textile.crossings_along(kind) + beyond; ++at)
        for (int i = 0; i < each; ++i) {
            const YarnPoint p = yarn_point(textile, kind, yarn, at, (i + 0.5) / each - 0.5);
            stations_.push_back({is_warp ? p.centre.y : p.centre.x, is_warp ? p.centre.x : p.centre.y, p.centre.z, p.half_height,
                                 std::max(0.0, p.half_width - p.half_height),
                                 p.tangent.z / std::max(1e-3, std::hypot(p.tangent.x, p.tangent.y))});
        }
}

NearStation YarnStations::nearest(double along, double up, double reach) const
{
    NearStation best{nullptr, reach * reach};
    auto s =
        std::lower_bound(stations_.begin(), stations_.end(), along - reach, [](const YarnStation& a, double b) { return a.along < b; });
    for (; s != stations_.end() && s->along < along + reach; ++s) {
        const double off = (s->along - along) * (s->along - along) + (s->up - up) * (s->up - up);
        if (off < best.off) best = {&*s, off};
    }
    best.off = std::sqrt(best.off);
    return best;
}

} // namespace hygroloom
