// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/room/yarn_stations.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

namespace {

bool alike(double a, double b, double of)
{
    constexpr double rounding = 1e-9;
    return std::abs(a - b) <= rounding * of;
}
/// Half-way between both; the first where they have the same section.
YarnStation between(const YarnStation& a, const YarnStation& b)
{
    const double height = a.half_height;
    if (alike(a.across, b.across, height) && alike(b.half_height, height, height) && alike(a.flat, b.flat, height)) return a;
    const auto mean = [&](double YarnStation::*of) { return 0.5 * (a.*of + b.*of); };
    return {mean(&YarnStation::along),       mean(&YarnStation::across), mean(&YarnStation::up),
            mean(&YarnStation::half_height), mean(&YarnStation::flat),   mean(&YarnStation::rise)};
}

} // namespace

NearStation YarnStations::nearest(double along, double up, double reach) const
{
    const YarnStation *best = nullptr, *as_near = nullptr;
    double least = reach * reach;
    auto s =
        std::lower_bound(stations_.begin(), stations_.end(), along - reach, [](const YarnStation& a, double b) { return a.along < b; });
    for (; s != stations_.end() && s->along < along + reach; ++s) {
        const double off = (s->along - along) * (s->along - along) + (s->up - up) * (s->up - up);
        if (best && alike(off, least, least))
            as_near = off < least ? std::exchange(best, &*s) : &*s;
        else if (off < least)
            best = &*s, as_near = nullptr;
        least = std::min(least, off);
    }
    if (!best) return {{}, reach};
    return {as_near ? between(*best, *as_near) : *best, std::sqrt(least)};
}

} // namespace hygroloom
