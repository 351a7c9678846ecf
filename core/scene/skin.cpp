// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How a skin sweats, and how warm it is, over time.
#include "core/scene/scene.h"

#include <algorithm>
#include <limits>

namespace hygroloom {

double SkinSupply::factor_at(double time) const
{
    double factor = 0;
    for (const SweatMoment& moment : course)
        if (moment.time <= time) factor = moment.factor;
    return factor;
}

namespace {

/// The first moment after a time.
auto moment_after(const std::vector<SkinMoment>& moments, double time)
{
    return std::upper_bound(moments.begin(), moments.end(), time, [](double at, const SkinMoment& moment) { return at < moment.time; });
}

} // namespace

SkinMoment SkinSupply::zone_at(std::size_t of, double time) const
{
    const std::vector<SkinMoment>& moments = zones[of];
    const auto after = moment_after(moments, time);
    if (after == moments.begin()) return moments.front();
    if (after == moments.end()) return moments.back();
    const SkinMoment& before = *(after - 1);
    const double share = (time - before.time) / (after->time - before.time);
    return {time, before.rate + share * (after->rate - before.rate), before.warmth + share * (after->warmth - before.warmth)};
}

std::vector<double> SkinSupply::rates_at(double time) const
{
    std::vector<double> now;
    for (std::size_t k = 0; k < zones.size(); ++k) now.push_back(zone_at(k, time).rate);
    std::vector<double> rates(rate.size(), 0);
    for (std::size_t i = 0; i < rates.size(); ++i)
        if (zone[i] < now.size()) rates[i] = now[zone[i]];
    return rates;
}

std::vector<FaceAir> SkinSupply::airs_at(std::vector<FaceAir> now, double time) const
{
    for (std::size_t k = 0; k < airs.size(); ++k) now[k].air_warmth = airs[k].warmth(zone_at(airs[k].zone, time).warmth);
    return now;
}

std::vector<double> SkinSupply::most_rates() const
{
    double factor = 0;
    for (const SweatMoment& moment : course) factor = std::max(factor, moment.factor);
    std::vector<double> most(zones.size(), 0), rates = rate;
    for (std::size_t k = 0; k < zones.size(); ++k)
        for (const SkinMoment& moment : zones[k]) most[k] = std::max(most[k], moment.rate);
    for (std::size_t i = 0; i < rates.size(); ++i) {
        if (has_zones()) rates[i] = zone[i] < most.size() ? most[zone[i]] : 0.0;
        rates[i] *= factor;
    }
    return rates;
}

double SkinSupply::next_change(double time) const
{
    double next = std::numeric_limits<double>::infinity();
    for (const SweatMoment& moment : course)
        if (moment.time > time) {
            next = moment.time;
            break;
        }
    for (const std::vector<SkinMoment>& moments : zones)
        if (const auto after = moment_after(moments, time); moments.size() > 1 && after != moments.end())
            next = std::min(next, after->time);
    return next;
}

bool SkinSupply::jumps_at(double time) const
{
    const auto is_then = [time](const auto& moment) { return moment.time == time; };
    return std::any_of(course.begin(), course.end(), is_then) ||
           std::any_of(zones.begin(), zones.end(),
                       [&](const std::vector<SkinMoment>& moments) { return std::count_if(moments.begin(), moments.end(), is_then) > 1; });
}

} // namespace hygroloom
