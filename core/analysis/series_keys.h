// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The time series of the metrics file by their keys, which end in the unit.
#pragma once

#include "core/analysis/run_metrics.h"

#include <string>
#include <vector>

namespace hygroloom {

/// Factor times a series' values plus offset.
struct SeriesKey {
    const char* key;
    std::vector<double> Series::*values;
    double factor = 1, offset = 0;
    bool of_all = true; ///< of every run; others are empty where the type of experiment has none
};

/// In the order of the file, the time first.
const std::vector<SeriesKey>& series_keys();

/// "Wetted radius, top" for wetted_radius_top_mm; the key itself where no plot has the series.
std::string title_of_series(const std::string& key);

/// In the key's unit.
std::vector<double> values_of(const SeriesKey& of, const Series& series);

} // namespace hygroloom
