// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/experiment.h"

#include <cmath>

namespace hygroloom {

const char* name_of(ExperimentType type)
{
    constexpr const char* names[experiment_types] = {
        "droplet", "moisture_management", "vertical_wicking", "horizontal_wicking", "drying", "conditioning", "sweat"};
    return names[static_cast<int>(type)];
}

const char* name_of(Closure closure)
{
    constexpr const char* names[] = {"kissa", "li_zhu", "paper"};
    return names[static_cast<int>(closure)];
}

Experiment standard_experiment(ExperimentType type)
{
    Experiment e;
    e.type = type;
    if (type != ExperimentType::droplet) e.droplets.clear();
    switch (type) {
    case ExperimentType::droplet: break;
    case ExperimentType::moisture_management:
        e.climate = {21, 0.65, 0};
        e.liquid = "saline";
        e.sample_mm = {80, 80};
        e.duration_s = 120;
        break;
    case ExperimentType::vertical_wicking:
        e.climate = {21, 0.65, 0.1};
        e.sample_mm = {25, 150};
        e.duration_s = 600;
        break;
    case ExperimentType::horizontal_wicking:
        e.climate = {21, 0.65, 0.1};
        e.sample_mm = {100, 100};
        e.volume_ul = 1000;
        e.duration_s = 300;
        break;
    case ExperimentType::drying:
        e.climate = {21, 0.65, 1};
        e.sample_mm = {50, 50};
        e.duration_s = 3600;
        break;
    case ExperimentType::conditioning:
        e.climate = {20, 0.65, 0.1};
        e.sample_mm = {50, 50};
        e.duration_s = 3600;
        break;
    case ExperimentType::sweat:
        e.climate = {25, 0.5, 0.5};
        e.liquid = "sweat";
        e.sample_mm = {50, 50};
        e.duration_s = 600;
        break;
    }
    return e;
}

std::array<double, 2> sample_extent_mm(const Experiment& experiment)
{
    const auto [across, along] = experiment.sample_mm;
    if (experiment.type == ExperimentType::vertical_wicking && experiment.along_weft) return {along, across};
    return {across, along};
}

std::vector<Droplet> falling_drops(const Experiment& experiment)
{
    if (experiment.type == ExperimentType::droplet) return experiment.droplets;
    if (experiment.type != ExperimentType::moisture_management || !(experiment.drop_ul > 0)) return {};
    const double count = std::ceil(experiment.volume_ul / experiment.drop_ul * (1 - 1e-12)); // 0.3 / 0.1 is three
    std::vector<Droplet> drops(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < drops.size(); ++i)
        drops[i] = {experiment.volume_ul / count, static_cast<double>(i) * experiment.feed_s / count};
    return drops;
}

Climate climate_at(const Experiment& experiment, double time_s)
{
    ClimateMoment before{0, experiment.climate};
    for (const ClimateMoment& after : experiment.climates) {
        if (time_s < after.time_s) {
            const double share = (time_s - before.time_s) / (after.time_s - before.time_s);
            const auto between = [&](double Climate::*value) {
                return before.climate.*value + share * (after.climate.*value - before.climate.*value);
            };
            return {between(&Climate::temperature_c), between(&Climate::relative_humidity), between(&Climate::air_speed_m_s)};
        }
        before = after;
    }
    return before.climate;
}

} // namespace hygroloom
