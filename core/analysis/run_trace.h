// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is kept of a replicate, of which there is no recording: its curves and maps at few times, the same for all replicates of an
// experiment. The ranges round curves and in maps come from them.
#pragma once

#include "core/analysis/cell_map.h"
#include "core/run/recording.h"

#include <map>

namespace hygroloom {

/// Both faces at one time.
struct TracedMap {
    double time = 0; ///< s
    CellMap top, bottom;
    const CellMap& of(MapSide side) const { return side == MapSide::bottom ? bottom : top; }
};

struct RunTrace {
    Series series;               ///< at trace_times(); empty: what no plot on screen shows, or the experiment has not
    double water_initial = 0;    ///< kg
    std::vector<TracedMap> maps; ///< one for each of traced_shares that the run came to
    /// Of a garment instead of these: its numbers over time by key, at the series' times.
    std::map<std::string, std::vector<double>> worn{};
};

constexpr int trace_points = 81;
/// From 0 to the duration (s), with equal steps of their square root: water comes as the root of time.
std::vector<double> trace_times(double duration);

/// When there are maps, as parts of the duration.
constexpr double traced_shares[] = {0.1, 0.25, 0.5, 1};
/// The largest number of a traced map's columns and rows; a larger cloth has coarser cells.
constexpr int most_traced_cells = 48;
/// Crossings along each side of a traced map's cell, 2 at least.
int traced_crossings(const Textile& textile);

/// Between the times linear; before the first and after the last as there. Precondition: as many values as times, one at least.
std::vector<double> values_at(const std::vector<double>& wanted, const std::vector<double>& time, const std::vector<double>& values);

/// The series that are kept.
std::vector<std::vector<double> Series::*> traced_series();
/// The curves alone.
RunTrace trace_of(const Metrics& metrics, double duration);

/// Takes the maps from a run's frames as they come.
class MapTracer {
public:
    void start(const RunRecord& run);
    void add(const Frame& frame);
    std::vector<TracedMap> take() { return std::move(maps_); }

private:
    RunRecord run_;
    double duration_ = 0;
    std::optional<Frame> start_;
    std::vector<TracedMap> maps_;
};

/// The maps of a run that was recorded, from the frames that a MapTracer would take.
std::vector<TracedMap> traced_maps(const Recording& recording);

} // namespace hygroloom
