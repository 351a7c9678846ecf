// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/replicate_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace hygroloom {
namespace {

/// Of sorted values, between them linear.
double quantile(const std::vector<double>& sorted, double share)
{
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), sorted.size() - 1);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

struct Range {
    double low, middle, high;
};

Range range_of(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const bool percentiles = static_cast<int>(values.size()) >= fewest_for_percentiles;
    return {quantile(values, percentiles ? 0.05 : 0), quantile(values, 0.5), quantile(values, percentiles ? 0.95 : 1)};
}

/// nullptr: the replicate keeps none.
const TracedMap* map_at(const Candidate& candidate, std::size_t replicate, std::size_t at)
{
    if (replicate >= candidate.replicates.size() || !candidate.replicates[replicate]) return nullptr;
    const RunTrace* trace = candidate.replicates[replicate]->trace.get();
    return trace && at < trace->maps.size() ? &trace->maps[at] : nullptr;
}

bool same_length(double one, double other) { return std::abs(one - other) <= 1e-6 * std::max(one, other); }

bool same_cells(const CellMap& one, const CellMap& other)
{
    return one.columns == other.columns && one.rows == other.rows && same_length(one.cell_width, other.cell_width) &&
           same_length(one.cell_height, other.cell_height);
}

} // namespace

std::string range_words(int runs)
{
    return fmt::format("{} of {} replicates", runs >= fewest_for_percentiles ? "5th to 95th percentile" : "least to most", runs);
}

namespace {

/// values_of: a replicate's curve; empty: it keeps none.
std::optional<CurveRange> range_of_curves(const Candidate& candidate, const std::function<std::vector<double>(const RunTrace&)>& values_of)
{
    std::vector<std::vector<double>> curves;
    CurveRange range;
    for (const auto& replicate : candidate.replicates) {
        if (!replicate || !replicate->trace) continue;
        const RunTrace& trace = *replicate->trace;
        std::vector<double> values = values_of(trace);
        if (values.empty() || values.size() != trace.series.time.size()) continue;
        if (range.time.empty()) range.time = trace.series.time;
        if (range.time == trace.series.time) curves.push_back(std::move(values));
    }
    if (curves.size() < 2) return {};
    range.runs = static_cast<int>(curves.size());
    for (std::size_t i = 0; i < range.time.size(); ++i) {
        std::vector<double> values;
        values.reserve(curves.size());
        for (const auto& each : curves) values.push_back(each[i]);
        const Range found = range_of(std::move(values));
        range.low.push_back(found.low);
        range.middle.push_back(found.middle);
        range.high.push_back(found.high);
    }
    return range;
}

} // namespace

std::optional<CurveRange> curve_range(const Candidate& candidate, const Plot& plot, const Curve& curve)
{
    return range_of_curves(candidate, [&](const RunTrace& trace) { return plotted(plot, curve, trace.series, trace.water_initial); });
}

std::optional<CurveRange> curve_range(const Candidate& candidate, const std::string& key)
{
    return range_of_curves(candidate, [&](const RunTrace& trace) {
        const auto found = trace.worn.find(key);
        return found == trace.worn.end() ? std::vector<double>() : found->second;
    });
}

std::optional<MapRange> map_range(const Candidate& candidate, MapSide side, std::size_t at)
{
    std::vector<const CellMap*> maps;
    for (std::size_t i = 0; i < candidate.replicates.size(); ++i) {
        const TracedMap* map = map_at(candidate, i, at);
        if (map && (maps.empty() || same_cells(*maps.front(), map->of(side)))) maps.push_back(&map->of(side));
    }
    if (maps.size() < 2) return {};
    MapRange range{*maps.front(), *maps.front(), static_cast<int>(maps.size())};
    for (std::size_t i = 0; i < range.low.water.size(); ++i) {
        std::vector<double> values;
        values.reserve(maps.size());
        for (const CellMap* map : maps) values.push_back(map->water[i]);
        const Range found = range_of(std::move(values));
        range.low.water[i] = found.low;
        range.high.water[i] = found.high;
    }
    return range;
}

std::optional<PairedMap> paired_map(const Candidate& candidate, const Candidate& baseline, MapSide side, std::size_t at, double error)
{
    std::vector<std::pair<const CellMap*, const CellMap*>> maps;
    std::vector<std::vector<double>> places;
    PairedMap made;
    for (std::size_t i = 0; i < candidate.replicates.size(); ++i) {
        const TracedMap *one = map_at(candidate, i, at), *other = map_at(baseline, i, at);
        if (!one || !other || !same_cells(one->of(side), other->of(side))) continue;
        if (!maps.empty() && !same_cells(*maps.front().first, one->of(side))) continue;
        maps.emplace_back(&one->of(side), &other->of(side));
        places.push_back(places_of_pair(candidate, baseline, i));
        made.time = one->time;
    }
    if (maps.size() < 2) return {};
    made.pairs = static_cast<int>(maps.size());
    made.cells = *maps.front().first;
    made.real.resize(made.cells.water.size());
    double most = 0;
    std::vector<double> wetter(made.cells.water.size());
    for (std::size_t cell = 0; cell < wetter.size(); ++cell) {
        double one = 0, other = 0;
        for (const auto& [a, b] : maps) {
            one += a->water[cell] / made.pairs;
            other += b->water[cell] / made.pairs;
        }
        wetter[cell] = std::max(std::abs(one), std::abs(other));
        most = std::max(most, wetter[cell]);
    }
    for (std::size_t cell = 0; cell < wetter.size(); ++cell) {
        std::vector<double> values, base;
        for (const auto& [a, b] : maps) {
            values.push_back(a->water[cell]);
            base.push_back(b->water[cell]);
        }
        const Compared found = compare_pairs(values, base, places, error * wetter[cell], Better::more);
        made.cells.water[cell] = found.difference;
        made.real[cell] = wetter[cell] >= 0.01 * most && (found.low > 0 || found.high < 0); // else both are shown as dry
    }
    return made;
}

} // namespace hygroloom
