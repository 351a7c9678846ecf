// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the replicates of a cloth lie: a band round a curve, the least and most of a map's cells, and which cells differ from a baseline's.
#pragma once

#include "core/analysis/comparison.h"
#include "core/analysis/plots.h"
#include "core/analysis/run_trace.h"

namespace hygroloom {

/// With fewer replicates a band goes from the least to the most: a percentile would hang on one of them.
constexpr int fewest_for_percentiles = 10;

struct CurveRange {
    std::vector<double> time;              ///< s, see trace_times()
    std::vector<double> low, middle, high; ///< in the plot's unit; the middle is the median
    int runs = 0;
};
/// Of the replicates that keep the curve; none: fewer than two do.
std::optional<CurveRange> curve_range(const Candidate& candidate, const Plot& plot, const Curve& curve);
/// The same of a garment's number by its key.
std::optional<CurveRange> curve_range(const Candidate& candidate, const std::string& key);
/// "least to most of 4 replicates", "5th to 95th percentile of 12 replicates"
std::string range_words(int runs);

/// A cell's least and most water in the replicates, as range_words() says.
struct MapRange {
    CellMap low, high;
    int runs = 0;
};
/// at: number of the traced share; none: fewer than two replicates keep that map.
std::optional<MapRange> map_range(const Candidate& candidate, MapSide side, std::size_t at);

/// The mean difference of two cloths over their pairs of replicates.
struct PairedMap {
    CellMap cells;          ///< of kg/m2; more than nothing: more water than the baseline
    std::vector<bool> real; ///< whether the interval of the cell's mean difference leaves out 0, see compare_pairs()
    int pairs = 0;
    double time = 0; ///< s
};
/// error: numerical, as a share of the wetter of both cells. none: fewer than two pairs keep maps whose cells lie at the same places.
std::optional<PairedMap> paired_map(const Candidate& candidate, const Candidate& baseline, MapSide side, std::size_t at, double error);

} // namespace hygroloom
