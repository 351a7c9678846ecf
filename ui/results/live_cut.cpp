// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/live_cut.h"

#include "core/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double moment = 0.2;         // s, that an answer may take
constexpr double room_for_more = 0.08; // s; the next longer one takes at most 2.5 times as long
constexpr double room_for_all = 0.04;  // s; twice the sides are four times the cloth
constexpr double shortest = 0.1;       // s, of an experiment

/// 1, 2, 5, 10, …, s: from half a decade below to a decade above.
std::array<double, 5> roundLengths(double length)
{
    const double decade = std::pow(10.0, std::floor(std::log10(length) + 1e-9));
    return {0.5 * decade, decade, 2 * decade, 5 * decade, 10 * decade};
}

/// The next round one.
double longer(double length)
{
    for (const double round : roundLengths(length)) {
        if (round > length * 1.001) { return round; }
    }
    return length;
}

/// The round one before, but not below the shortest.
double shorter(double length)
{
    double next = length;
    for (const double round : roundLengths(length)) {
        if (round < length * 0.999) { next = round; }
    }
    return std::max(std::min(shortest, length), next);
}

/// mm, of a side of what is left, at the least.
double leastSide(const Fabric& fabric, const Experiment& experiment)
{
    constexpr double least = 5, radii = 3; // a drop spreads that far at the most before the cloth takes it in
    const auto radius = [](double volume_ul) { return std::cbrt(0.75 / pi * volume_ul); };
    double side = std::max({least, 10.0 * fabric.weave.ends() / fabric.ends_per_cm, 10.0 * fabric.weave.picks() / fabric.picks_per_cm});
    if (uses_field(experiment.type, "volume_ul")) { side = std::max(side, 2 * radii * radius(experiment.volume_ul)); }
    for (const Droplet& drop : falling_drops(experiment)) {
        const double from_middle = std::max(std::abs(drop.at_mm[0]), std::abs(drop.at_mm[1]));
        side = std::max(side, 2 * (from_middle + radii * radius(drop.volume_ul)));
    }
    return side;
}

/// The air's layer on a sample grows along it (core/physics/air.h): on a shorter one slower air has a layer as thick.
void keepAirLayer(Experiment& experiment, double share)
{
    experiment.climate.air_speed_m_s *= share;
    experiment.initial.air_speed_m_s *= share;
    for (ClimateMoment& later : experiment.climates) { later.climate.air_speed_m_s *= share; }
}

/// Of a strip the length.
void cutSample(Experiment& experiment, const Fabric& fabric, int halvings)
{
    constexpr double dry_end_mm = 20;
    const double share = std::pow(0.5, halvings);
    const bool strip = is_strip(experiment.type);
    const double least = strip ? experiment.immersion_mm + dry_end_mm : leastSide(fabric, experiment);
    const auto longest = [&experiment] { return *std::max_element(experiment.sample_mm.begin(), experiment.sample_mm.end()); };
    const double before = longest();
    for (std::size_t side = strip ? 1 : 0; side < 2; ++side) {
        double& length = experiment.sample_mm[side];
        length = std::min(length, std::max(least, share * length));
    }
    keepAirLayer(experiment, longest() / before);
}

} // namespace

LiveCut firstCut(const Fabric& fabric, const Experiment& experiment)
{
    constexpr double most_crossings = 5000; // take about 0.2 s
    LiveCut cut;
    const auto sampleOf = [&](int halvings) {
        Experiment part = experiment;
        cutSample(part, fabric, halvings);
        return part;
    };
    const auto crossings = [&] {
        const auto [along_weft, along_warp] = sample_extent_mm(sampleOf(cut.halvings));
        return 0.01 * along_weft * fabric.ends_per_cm * along_warp * fabric.picks_per_cm;
    };
    while (cut.most_halvings > 0 && sampleOf(cut.most_halvings).sample_mm == sampleOf(cut.most_halvings - 1).sample_mm) {
        --cut.most_halvings;
    }
    while (cut.halvings < cut.most_halvings && crossings() > most_crossings) { ++cut.halvings; }
    return cut;
}

LiveCut nextCut(LiveCut last, double duration, double wall)
{
    LiveCut next = last;
    next.wall = wall;
    const double computed = std::max(std::min(last.length, duration), std::min(last.length, shortest));
    if (wall > moment && last.halvings < last.most_halvings) {
        ++next.halvings;
        next.too_long = std::numeric_limits<double>::infinity();
    } else if (wall > moment) {
        next.length = shorter(computed);
        next.too_long = computed;
        next.wall_before = last.wall;
    } else if (wall < room_for_more && computed < duration) {
        const double length = longer(computed);
        if (length < last.too_long || wall < 0.5 * last.wall_before) { next.length = length; }
    } else if (wall < room_for_all && last.halvings > 0) {
        --next.halvings;
    }
    return next;
}

LiveCut withMoreOfTheSample(LiveCut last)
{
    last.most_halvings = --last.halvings;
    return last;
}

Design cutDesign(const Design& design, int fabric, int experiment, const LiveCut& cut)
{
    Design one = design;
    one.fabrics = {design.fabrics.at(static_cast<std::size_t>(fabric))};
    one.experiments = {design.experiments.at(static_cast<std::size_t>(experiment))};
    one.garments.clear();
    one.wears.clear();
    Experiment& asked = one.experiments[0];
    if (const double end = beginOf(asked) + cut.length; end < asked.duration_s) {
        asked.duration_s = end;
        std::erase_if(asked.droplets, [end](const Droplet& drop) { return drop.time_s >= end; });
    }
    cutSample(asked, one.fabrics[0], cut.halvings);
    return one;
}

double beginOf(const Experiment& experiment)
{
    if (const int drops = drops_of_feed(experiment); drops > 0) { return std::min(experiment.duration_s, experiment.feed_s / drops); }
    if (!uses_field(experiment.type, "droplets") || experiment.droplets.empty()) { return 0; }
    const auto sooner = [](const Droplet& a, const Droplet& b) { return a.time_s < b.time_s; };
    return std::min_element(experiment.droplets.begin(), experiment.droplets.end(), sooner)->time_s;
}

} // namespace hygroloom
