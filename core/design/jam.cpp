// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/jam.h"

#include "core/base/units.h"

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

SettSystem mean_of(double sett, const YarnOrder& order, const std::vector<FittedYarn>& types)
{
    SettSystem mean{0, sett, 0};
    double volume = 0; // tex over density
    for (std::size_t type = 0; type < types.size(); ++type) {
        const double tex = order.share[type] * types[type].free.linear_density_tex;
        mean.tex += tex;
        volume += tex / types[type].fibre.density_kg_m3;
    }
    mean.fibre_density_kg_m3 = mean.tex / volume;
    return mean;
}

/// The gains of the free fields of all ends; turned: of all picks.
double gains(const Weave& weave, bool turned)
{
    const int threads = turned ? weave.picks() : weave.ends(), crossed = turned ? weave.ends() : weave.picks();
    const auto up = [&](int thread, int at) { return turned ? weave.warp_up(at, thread) : weave.warp_up(thread, at); };
    double sum = 0;
    for (int thread = 0; thread < threads; ++thread) {
        const int before = (thread + threads - 1) % threads, after = (thread + 1) % threads;
        for (int at = 0; at < crossed; ++at) {
            const int next = (at + 1) % crossed;
            if (up(thread, at) != up(thread, next)) continue;
            const int changing = (up(before, at) != up(before, next)) + (up(after, at) != up(after, next));
            sum += (11 - changing) / 8.0;
        }
    }
    return sum;
}

/// 1 - cos of the angle at which a yarn leaves the middle plane where the crossed yarns leave it this pitch; sum: of both heights.
double room_for_rise(double pitch, double changes, const Section& crossed, double sum)
{
    if (changes <= 0) return 0;
    const double at_change = (pitch - (1 - changes) * crossed.width) / changes - (crossed.width - crossed.height);
    const double sine = std::clamp(at_change / sum, 0.0, 1.0);
    return 1 - std::sqrt(1 - sine * sine);
}

} // namespace

double weave_factor(const Weave& weave)
{
    const double fields = 3.0 * weave.ends() * weave.picks();
    return std::sqrt(fields / (fields - gains(weave, false) - gains(weave, true)));
}

double sett_share(const SettSystem& warp, const SettSystem& weft, double weave_factor)
{
    const double threads = warp.sett_per_cm + weft.sett_per_cm;
    const double mean = (warp.sett_per_cm * warp.tex / warp.fibre_density_kg_m3 + weft.sett_per_cm * weft.tex / weft.fibre_density_kg_m3) /
                        threads; // 1 tex over 1 kg/m3 is 1 mm2
    const double diameter_cm = 0.1 * std::sqrt(4 * mean / pi);
    const double u = 2.0 / 3 * std::sqrt(warp.tex / weft.tex);
    return std::sqrt(3.0) * diameter_cm * std::pow(weft.sett_per_cm, 1 / (1 + u)) * std::pow(warp.sett_per_cm, u / (1 + u)) / weave_factor;
}

double sett_share_of_limit(const Fabric& fabric, const FittedYarns& yarns)
{
    return sett_share(mean_of(fabric.ends_per_cm, yarns.warp_order, yarns.warp), mean_of(fabric.picks_per_cm, yarns.weft_order, yarns.weft),
                      weave_factor(fabric.weave));
}

bool racetracks_jam(const Fabric& fabric, const FittedYarns& yarns)
{
    const auto mean = [](const YarnOrder& order, const std::vector<FittedYarn>& types) {
        Section section{0, 0};
        for (std::size_t type = 0; type < types.size(); ++type) {
            const double squeezed = std::sqrt(std::min(1.0, types[type].area_share * types[type].packing_factor / densest_squeezed));
            section.width += order.share[type] * squeezed * types[type].section.width;
            section.height += order.share[type] * squeezed * types[type].section.height;
        }
        return section;
    };
    const Section warp = mean(yarns.warp_order, yarns.warp), weft = mean(yarns.weft_order, yarns.weft);
    const double along_warp = share_of_changes(fabric.weave, true), along_weft = share_of_changes(fabric.weave, false);
    if (along_warp <= 0 || along_weft <= 0) return false; // one system lies straight
    const double sum = warp.height + weft.height;
    const double room =
        room_for_rise(10 / fabric.picks_per_cm, along_warp, weft, sum) + room_for_rise(10 / fabric.ends_per_cm, along_weft, warp, sum);
    return room < 1 - 1e-9;
}

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
