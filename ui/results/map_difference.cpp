// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/map_difference.h"

#include "core/analysis/outcomes.h"
#include "ui/basics/words.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

bool areEqualLengths(double one, double other) { return std::abs(one - other) <= 1e-6 * std::max(one, other); }

/// The largest of two errors that are known; none where one is not.
std::optional<double> larger(const std::optional<double>& one, const std::optional<double>& other)
{
    return one && other ? std::optional(std::max(*one, *other)) : std::nullopt;
}

std::optional<double> errorOf(const RunRecord& run, const std::string& key)
{
    const auto found = run.plan.expected_errors.find(key);
    return found == run.plan.expected_errors.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

MapError errorOfMaps(const RunRecord& run, const RunRecord& baseline, MapSide side)
{
    const bool top = side == MapSide::top;
    const char* key = top ? "maximum_wetted_radius_top_mm" : "maximum_wetted_radius_bottom_mm";
    if (const auto share = larger(errorOf(run, key), errorOf(baseline, key))) {
        return {share, top ? tr("the wetted radius, top") : tr("the wetted radius, bottom")};
    }
    return {larger(run.plan.expected_error, baseline.plan.expected_error), tr("the run’s numbers at most")};
}

QString whyNoDifference(const CellMap& map, const CellMap& baseline)
{
    if (map.crossings_per_cell != baseline.crossings_per_cell) {
        return tr("its cells have %1 crossings across and the baseline’s %2").arg(map.crossings_per_cell).arg(baseline.crossings_per_cell);
    }
    const QString place = tr("so no two cells lie at the same place");
    if (!areEqualLengths(map.cell_width, baseline.cell_width) || !areEqualLengths(map.cell_height, baseline.cell_height)) {
        return tr("its setts differ from the baseline’s, %1").arg(place);
    }
    if (map.columns != baseline.columns || map.rows != baseline.rows) {
        return tr("its sample is of another size than the baseline’s, %1").arg(place);
    }
    return {};
}

MapDifference differenceOf(const CellMap& map, const CellMap& baseline, const MapError& error)
{
    MapDifference made{map, std::vector<bool>(map.water.size())};
    const double most = std::max(map.maximum(), baseline.maximum());
    for (std::size_t i = 0; i < map.water.size(); ++i) {
        made.cells.water[i] = map.water[i] - baseline.water[i];
        // What both maps show as dry is.
        const bool dry = std::max(std::abs(map.water[i]), std::abs(baseline.water[i])) < 0.01 * most;
        const double within = error.share.value_or(0) * std::max(std::abs(map.water[i]), std::abs(baseline.water[i]));
        made.real[i] = !dry && std::abs(made.cells.water[i]) > within;
    }
    return made;
}

double largestOf(const MapDifference& difference)
{
    double most = 0;
    for (std::size_t i = 0; i < difference.real.size(); ++i) {
        if (difference.real[i]) { most = std::max(most, std::abs(difference.cells.water[i])); }
    }
    return most;
}

} // namespace hygroloom
