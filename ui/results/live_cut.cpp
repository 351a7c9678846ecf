// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/live_cut.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

/// s, from the first drop on, in the order of ExperimentType: until most cloths show what they are like.
constexpr double lengths[experiment_types] = {1, 2, 5, 2, 60, 60, 10};

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

LiveCut cutOf(const Fabric& fabric, const Experiment& experiment)
{
    constexpr double most_crossings = 5000;
    constexpr int most_halvings = 5;
    LiveCut cut{lengths[static_cast<std::size_t>(experiment.type)], 0};
    const auto sampleOf = [&](int halvings) {
        Experiment part = experiment;
        cutSample(part, fabric, halvings);
        return part;
    };
    const auto crossings = [&] {
        const auto [along_weft, along_warp] = sample_extent_mm(sampleOf(cut.halvings));
        return 0.01 * along_weft * fabric.ends_per_cm * along_warp * fabric.picks_per_cm;
    };
    while (cut.halvings < most_halvings && crossings() > most_crossings &&
           sampleOf(cut.halvings + 1).sample_mm != sampleOf(cut.halvings).sample_mm) {
        ++cut.halvings;
    }
    return cut;
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
