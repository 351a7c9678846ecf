// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// An experiment on a whole garment: it is worn, and the skin in it sweats.
#pragma once

#include "core/design/experiment.h"

namespace hygroloom {

/// From a time on the wearer sweats this many times as much as the table of zones says.
struct Activity {
    double time_s = 0;
    double factor = 1;
    bool operator==(const Activity&) const = default;
};

struct WearExperiment {
    std::string name;
    std::string garment;
    Climate climate{25, 0.5, 1};
    std::string liquid = "sweat";
    double duration_s = 1800;
    std::vector<Activity> activity{Activity{}}; ///< in order of time, the first at 0
    std::string activity_file;     ///< a CSV of rates over time by zone, relative to the project, in place of activity; empty: none
    double initial_water_g_m2 = 0; ///< that the garment is wet with at the start
    bool operator==(const WearExperiment&) const = default;
};

constexpr std::size_t most_activities = 1000;
constexpr double largest_activity = 10;

} // namespace hygroloom
