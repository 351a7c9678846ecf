// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/yarn_start.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {
namespace {

constexpr double least_change = 1e-3; // of regain: where nothing is to change, nothing is to be followed more closely

/// How far a yarn's regain is from what the air of any time asks for.
double largest_change(const Scene& scene, const YarnParameters& yarn)
{
    double change = std::abs(yarn.initial_regain - yarn.resting_regain);
    for (const AirMoment& moment : scene.climate.course)
        change = std::max(change, std::abs(yarn.initial_regain - equilibrium_regain(yarn.isotherm, moment.humidity,
                                                                                    scene.climate.temperature + moment.air_warmth)));
    return change;
}

/// Adds water that is still to come, or the first drops would have to be followed exactly. pores: m3, of all segments.
void add_water_to_come(double& water, const Scene& scene, double pores)
{
    constexpr double filled = 0.2; // of the pores, by a bath
    if (!scene.supply.fed.empty()) water += filled * scene.climate.density * pores;
    for (const ScenePool& pool : scene.supply.pools) water += pool.rate * (pool.end - pool.start) * scene.climate.density;
    constexpr double ahead = 60; // s, about the longest step; not the run's duration, which steps must not depend on
    water += sweat_rate(scene) * ahead;
}

/// Whether nothing happens in the cloth but where water falls on it.
bool is_at_rest(const Scene& scene)
{
    const ClothStart& start = scene.cloth.start;
    return scene.supply.fed.empty() && scene.supply.skin.rate.empty() && !(sweat_rate(scene) > 0) && start.warmth == 0 &&
           start.humidity < 0 && start.liquid.empty() && scene.climate.course.empty() &&
           std::all_of(scene.cloth.yarns.begin(), scene.cloth.yarns.end(),
                       [&](const YarnParameters& yarn) { return largest_change(scene, yarn) < least_change; });
}

/// kg/m3 in the pores.
double pore_vapour(const Scene& scene)
{
    const ClimateParameters& climate = scene.climate;
    const double humidity = scene.cloth.start.humidity < 0 ? climate.humidity : scene.cloth.start.humidity;
    const double begins =
        scene.rules.vapour ? humidity : std::min(1.0, humidity); // more than saturated air condenses in the first exchange
    return begins * saturation_concentration(climate.temperature + scene.cloth.start.warmth);
}

/// All but those that lie outside the panels of a garment.
std::vector<bool> segments_there(const Scene& scene)
{
    const ClothPanels& panels = scene.cloth.panels;
    std::vector<bool> there(static_cast<std::size_t>(scene.cloth.segments()), panels.count == 0);
    for (std::size_t piece = 0; piece < panels.first.size(); ++piece)
        std::fill(there.begin() + panels.first[piece], there.begin() + panels.last[piece], true);
    return there;
}

/// The segments with what their swelling depends on.
Segments swelling_segments(const Scene& scene, YarnStart& start, std::vector<double>& bound)
{
    Segments s;
    static_cast<Yarns&>(s) = yarns_of(scene);
    s.swelling = scene.cloth.swelling;
    s.length = scene.cloth.length.data();
    s.warp_up = scene.cloth.warp_up.data();
    s.dry_pores = scene.cloth.pores.empty() ? nullptr : scene.cloth.pores.data();
    s.room = start.room.empty() ? nullptr : start.room.data();
    for (std::size_t i = 0; i < bound.size(); ++i) {
        const YarnParameters& yarn = s.yarn_of(static_cast<int>(i));
        bound[i] = yarn.initial_regain * scene.cloth.fibre_length(i, yarn) * yarn.fibre_area * yarn.fibre_density;
    }
    s.bound = bound.data();
    return s;
}

/// As filled up to what they hold.
void settle(std::vector<double>& suctions, std::vector<double>& settled, const Retention& retention, double saturation)
{
    settled.push_back(saturation);
    suctions.push_back(saturation >= nearly_full ? 0.0 : suction_filling(retention, saturation));
}

const Retention& pores_at_start(const Segments& s, int i)
{
    return s.yarn_of(i).on_face[s.face_of(s.crossing_of(i), s.is_warp(i))].retention;
}

void add_suctions(YarnStart& start, const Scene& scene, const Segments& s)
{
    const double density = scene.climate.density;
    const ClothStart& at = scene.cloth.start;
    for (std::size_t i = 0; i < start.pores.size(); ++i)
        settle(start.suction, start.settled, pores_at_start(s, static_cast<int>(i)),
               at.liquid.empty() || start.pores[i] <= 0 ? 0.0 : at.liquid[i] / (density * start.pores[i]));
    const FindPores find{s, density};
    for (int crossing = 0; crossing < scene.cloth.crossings(); ++crossing) {
        const int end = crossing / scene.cloth.picks, pick = crossing % scene.cloth.picks;
        const BetweenParameters& between = s.crossing_at(end, pick).between;
        const double held = at.between.empty() ? 0.0 : at.between[static_cast<std::size_t>(crossing)] / density;
        double& room = start.room[static_cast<std::size_t>(crossing)];
        room = std::max(held, between.volume - find.swollen(crossing).grown - find.swollen(s.weft_of(end, pick)).grown);
        settle(start.between_suction, start.between_settled,
               narrowed(between.retention[both_wet + covered], find.narrowness(crossing, between)), held / room);
    }
}

} // namespace

bool particles_offer(const Scene& scene)
{
    return scene.cloth.by_suction && scene.rules.wicking && !scene.supply.droplets.empty() && scene.supply.pools.empty() && !scene.caps.on;
}

std::size_t count_of(SegmentCount count, const Scene& scene)
{
    const auto segments = static_cast<std::size_t>(scene.cloth.segments());
    const bool sucks = scene.cloth.by_suction;
    switch (count) {
    case SegmentCount::shells: return segments * static_cast<std::size_t>(scene.rules.fibre_shells);
    case SegmentCount::crossings: return segments / 2;
    case SegmentCount::bundle_crossings: return scene.cloth.warp_up_share.size();
    case SegmentCount::fed_segments: return scene.supply.fed.size();
    case SegmentCount::watched_segments: return scene.rules.step_error > 0 ? segments : 0;
    case SegmentCount::takers: return sucks ? 3 * segments / 2 : segments;
    case SegmentCount::offered_takers:
        return (sucks && (!scene.supply.pools.empty() || scene.caps.on)) || particles_offer(scene) ? 3 * segments / 2 : 0;
    case SegmentCount::promised_takers: return particles_offer(scene) ? 3 * segments / 2 : 0;
    case SegmentCount::cap_crossings:
        return scene.caps.on || !scene.supply.droplets.empty() || !scene.supply.pools.empty() ? segments / 2 : 0;
    case SegmentCount::uneven_segments: return scene.cloth.pores.size();
    case SegmentCount::touching_segments: return sucks ? scene.cloth.touching.size() : 0;
    case SegmentCount::woven_segments: return sucks ? scene.cloth.room_along.size() : 0;
    case SegmentCount::sucking_segments: return sucks ? segments : 0;
    case SegmentCount::sucking_crossings: return sucks ? segments / 2 : 0;
    case SegmentCount::layered_segments: return scene.cloth.layers.joints.empty() ? 0 : segments;
    case SegmentCount::skin_crossings: return scene.supply.skin.rate.size();
    case SegmentCount::segments: break;
    }
    return segments;
}

YarnStart yarn_start(const Scene& scene)
{
    const auto n = static_cast<std::size_t>(scene.cloth.segments()), shells = static_cast<std::size_t>(scene.rules.fibre_shells);
    YarnStart start{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n * shells), {}};
    const double density = scene.climate.density, vapour = pore_vapour(scene);
    if (scene.cloth.by_suction) start.room.resize(n / 2);
    std::vector<double> bound(n);
    const Segments s = swelling_segments(scene, start, bound);
    const std::vector<bool> there = segments_there(scene);
    constexpr double temperature_change = 50.0; // K: temperatures settle at once, so errors of steps do not add up
    for (std::size_t i = 0; i < n; ++i) {
        if (!there[i]) continue;
        const YarnParameters& yarn = s.yarn_of(static_cast<int>(i));
        const double liquid = scene.cloth.start.liquid.empty() ? 0.0 : scene.cloth.start.liquid[i];
        const double fibres = scene.cloth.fibre_length(i, yarn) * yarn.fibre_area * yarn.fibre_density;
        start.pores[i] = std::max(liquid / density, FindPores{s, density}.swollen(static_cast<int>(i)).pores);
        start.vapour[i] = vapour * pore_air(start.pores[i], liquid, density);
        std::fill_n(start.regain.begin() + static_cast<std::ptrdiff_t>(i * shells), shells, yarn.initial_regain);
        if (scene.rules.sorption) start.at_stake.water += fibres * std::max(least_change, largest_change(scene, yarn));
        start.at_stake.heat += temperature_change * heat_capacity(yarn, scene.cloth.fibre_length(i, yarn), liquid);
    }
    const double pores = std::accumulate(start.pores.begin(), start.pores.end(), 0.0);
    if (is_at_rest(scene)) start.at_stake.fills = density * pores;
    add_water_to_come(start.at_stake.to_come, scene, pores);
    if (scene.cloth.by_suction) add_suctions(start, scene, s);
    return start;
}

FibreStart fibre_start(const Scene& scene, std::vector<double>& regain, const std::vector<double>& liquid)
{
    Segments s; // of the segments' arrays only these are there
    static_cast<Yarns&>(s) = yarns_of(scene);
    s.shells = scene.rules.fibre_shells;
    s.length = scene.cloth.length.data();
    s.dry_pores = scene.cloth.pores.empty() ? nullptr : scene.cloth.pores.data();
    s.regain = regain.data();
    FibreStart start{std::vector<double>(liquid.size()), std::vector<double>(liquid.size())};
    for (std::size_t i = 0; i < liquid.size(); ++i) {
        const YarnParameters& yarn = s.yarn_of(static_cast<int>(i));
        start.bound[i] = bound_water(s, yarn, static_cast<int>(i));
        start.heat[i] = heat_capacity(yarn, scene.cloth.fibre_length(i, yarn), liquid[i] + start.bound[i]) * scene.cloth.start.warmth;
    }
    return start;
}

ClimateParameters climate_at(const Scene& scene, double time)
{
    ClimateParameters climate = scene.climate;
    if (scene.climate.course.empty()) return climate;
    const AirMoment now = air_at(scene.climate, time);
    climate.air_warmth = now.air_warmth;
    climate.humidity = now.humidity;
    climate.vapour = now.humidity * saturation_concentration(climate.temperature + now.air_warmth);
    climate.heat_transfer = now.heat_transfer;
    climate.mass_transfer = now.mass_transfer;
    climate.air_speed = now.air_speed;
    return climate;
}

std::vector<YarnParameters> yarns_in(const Scene& scene, const ClimateParameters& climate)
{
    std::vector<YarnParameters> yarns = scene.cloth.yarns;
    for (YarnParameters& yarn : yarns)
        yarn.resting_regain = equilibrium_regain(yarn.isotherm, climate.humidity, climate.temperature + climate.air_warmth);
    return yarns;
}

} // namespace hygroloom
