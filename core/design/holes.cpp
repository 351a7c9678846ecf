// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/holes.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

/// ul, of the smallest drop that meets the cloth.
std::optional<double> smallest_drop(const Experiment& experiment)
{
    switch (info_of(experiment.type).source) {
    case WaterSource::drops: {
        std::optional<double> least;
        for (const Droplet& drop : falling_drops(experiment)) least = std::min(least.value_or(drop.volume_ul), drop.volume_ul);
        return least;
    }
    case WaterSource::pool: {
        const int drops = drops_of_feed(experiment);
        return std::min(experiment.volume_ul, drops > 0 ? experiment.volume_ul / drops : hanging_drop_ul);
    }
    default: return {};
    }
}

double widest(const std::vector<FittedYarn>& yarns)
{
    double width = 0;
    for (const FittedYarn& yarn : yarns) width = std::max(width, yarn.section.width);
    return width;
}

} // namespace

double hole_width_mm(const Fabric& fabric, const FittedFabric& fitted)
{
    const double between_ends = 10 / fabric.ends_per_cm - widest(fitted.yarns.warp);
    return std::max(0.0, std::min(between_ends, 10 / fabric.picks_per_cm - widest(fitted.yarns.weft)));
}

std::optional<Message> falls_through(const Fabric& fabric, const FittedFabric& fitted, const Experiment& experiment)
{
    const std::optional<double> volume = smallest_drop(experiment); // ul, which are mm3
    const double hole = hole_width_mm(fabric, fitted);
    if (!volume || std::cbrt(6 * *volume / pi) > hole) return {};
    return say("A drop of {:.3g} µl, {:.2g} wide, falls through \"{}\": its holes are {:.2g} wide.", *volume,
               Amount{std::cbrt(6 * *volume / pi), Stored::mm}, fabric.name, Amount{hole, Stored::mm});
}

} // namespace hygroloom
