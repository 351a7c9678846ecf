// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/run_trace.h"

#include "core/analysis/plots.h"

#include <algorithm>

namespace hygroloom {
namespace {

double duration_of(const RunRecord& run)
{
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    return experiment ? experiment->duration_s : 0;
}

/// Whether it is time for map number `at`.
bool is_due(double time, double duration, std::size_t at)
{
    constexpr double rounding = 1e-9;
    return at < std::size(traced_shares) && time >= traced_shares[at] * duration * (1 - rounding);
}

TracedMap map_of(const RunRecord& run, const Frame& frame, const Frame& start)
{
    const int crossings = traced_crossings(run.textile);
    return {frame.time, cell_map(run.textile, frame, start, MapSide::top, crossings),
            cell_map(run.textile, frame, start, MapSide::bottom, crossings)};
}

} // namespace

std::vector<double> trace_times(double duration)
{
    std::vector<double> times;
    for (int i = 0; i < trace_points; ++i) {
        const double share = static_cast<double>(i) / (trace_points - 1);
        times.push_back(share * share * duration);
    }
    return times;
}

int traced_crossings(const Textile& textile)
{
    const int longest = std::max(textile.ends(), textile.picks());
    const int yarns = textile.yarns_per_cell(); // where the cloth is shown in cells, of which each is so many crossings wide
    return std::max(2, (longest + most_traced_cells - 1) / most_traced_cells * yarns);
}

std::vector<double> values_at(const std::vector<double>& wanted, const std::vector<double>& time, const std::vector<double>& values)
{
    std::vector<double> found;
    for (const double t : wanted) {
        const auto i = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
        if (i == 0 || i == time.size()) {
            found.push_back(values[i == 0 ? 0 : time.size() - 1]);
            continue;
        }
        const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
        found.push_back(values[i - 1] + share * (values[i] - values[i - 1]));
    }
    return found;
}

std::vector<std::vector<double> Series::*> traced_series()
{
    std::vector<std::vector<double> Series::*> all;
    for (const Plot& plot : all_plots())
        for (const Curve& curve : plot.curves)
            if (!curve.in_reports_only && std::find(all.begin(), all.end(), curve.values) == all.end()) all.push_back(curve.values);
    return all;
}

RunTrace trace_of(const Metrics& metrics, double duration)
{
    RunTrace trace;
    const std::vector<double>& time = metrics.series.time;
    if (time.empty()) return trace;
    trace.water_initial = metrics.ledger.water_initial;
    trace.series.time = trace_times(duration);
    for (const auto& of : traced_series())
        if (const auto& values = metrics.series.*of; values.size() == time.size())
            trace.series.*of = values_at(trace.series.time, time, values);
    return trace;
}

void MapTracer::start(const RunRecord& run)
{
    run_ = run;
    duration_ = duration_of(run);
    start_.reset();
    maps_.clear();
}

void MapTracer::add(const Frame& frame)
{
    if (!start_) start_ = start_of_maps(run_, frame);
    while (is_due(frame.time, duration_, maps_.size())) maps_.push_back(map_of(run_, frame, *start_));
}

std::vector<TracedMap> traced_maps(const Recording& recording)
{
    std::vector<TracedMap> maps;
    if (recording.frames() == 0) return maps;
    const RunRecord& run = recording.run();
    const double duration = duration_of(run);
    const Frame start = start_of_maps(run, recording.frame(0));
    const auto& ledgers = recording.ledgers();
    for (std::size_t i = 0; i < ledgers.size(); ++i)
        while (is_due(ledgers[i].time, duration, maps.size())) maps.push_back(map_of(run, recording.frame(static_cast<int>(i)), start));
    return maps;
}

} // namespace hygroloom
