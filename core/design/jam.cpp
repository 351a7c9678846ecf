// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/jam.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

/// One system, own; changes is the share of steps from one of its yarns to the next at which the crossed yarn changes sides, and
/// other_changes the same along the other direction.
JamOfSystem of_system(double sett, double other_sett, double own, double other, double changes, double other_changes)
{
    JamOfSystem jam;
    jam.sett_per_cm = sett;
    jam.ashenhurst_per_cm = 10 / (own + changes * other);
    jam.ashenhurst_percent = 100 * sett / jam.ashenhurst_per_cm;

    // Where an own yarn changes sides, the other system's yarns on both sides of the change are this far apart; the rest lie side by side.
    const double sum = own + other;
    const double other_pitch = other_changes > 0 ? (10 / other_sett - (1 - other_changes) * other) / other_changes : sum;
    const double other_sine = std::clamp(other_pitch / sum, 0.0, 1.0);
    const double own_cosine = 1 - std::sqrt(1 - other_sine * other_sine); // cos a = 1 - cos b
    const double pitch = std::max(own, sum * std::sqrt(1 - own_cosine * own_cosine));
    jam.peirce_per_cm = 10 / (changes * pitch + (1 - changes) * own);
    jam.peirce_percent = 100 * sett / jam.peirce_per_cm;
    return jam;
}

} // namespace

JamGauge jam_gauge(const Weave& weave, double ends_per_cm, double picks_per_cm, double warp_diameter_mm, double weft_diameter_mm)
{
    const double along_weft = share_of_changes(weave, false), along_warp = share_of_changes(weave, true);
    return {of_system(ends_per_cm, picks_per_cm, warp_diameter_mm, weft_diameter_mm, along_weft, along_warp),
            of_system(picks_per_cm, ends_per_cm, weft_diameter_mm, warp_diameter_mm, along_warp, along_weft)};
}

JamGauge jam_gauge(const Fabric& fabric, const FittedYarns& yarns)
{
    const auto mean = [](const YarnOrder& order, const std::vector<FittedYarn>& types) {
        double diameter = 0;
        for (std::size_t type = 0; type < types.size(); ++type) diameter += order.share[type] * types[type].free.diameter;
        return diameter;
    };
    return jam_gauge(fabric.weave, fabric.ends_per_cm, fabric.picks_per_cm, mean(yarns.warp_order, yarns.warp),
                     mean(yarns.weft_order, yarns.weft));
}

} // namespace hygroloom
