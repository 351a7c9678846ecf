// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/observed.h"

#include "core/base/error.h"
#include "core/study/quantiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

std::vector<double> means_by_point(const StudyTable& table, std::size_t points, const std::string& metric, const std::string& fabric,
                                   const std::string& experiment)
{
    const StudyColumn &point = *table.find(StudyColumnRole::point), &values = *table.find(metric);
    const StudyColumn& status = *table.find(StudyColumnRole::status);
    const StudyColumn *fabrics = table.find(StudyColumnRole::fabric), *experiments = table.find(StudyColumnRole::experiment);
    std::vector<double> sums(points), counts(points);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (fabrics && fabrics->word(row) != fabric) continue;
        if (experiments && experiments->word(row) != experiment) continue;
        if (status.word(row) != row_done || std::isnan(values.numbers[row])) continue;
        const double number = point.numbers[row];
        if (!(number >= 0 && number < static_cast<double>(points))) throw Error("The table has points that the study does not have.");
        const auto at = static_cast<std::size_t>(number);
        sums[at] += values.numbers[row];
        ++counts[at];
    }
    for (std::size_t i = 0; i < points; ++i) sums[i] = counts[i] > 0 ? sums[i] / counts[i] : std::numeric_limits<double>::quiet_NaN();
    return sums;
}

FactorCube::FactorCube(const std::vector<Factor>& factors) : factors_(factors)
{
    for (const Factor& factor : factors) {
        Axis axis;
        const FactorDistribution& d = factor.distribution;
        if (factor.is_list()) {
            const bool numbers = std::all_of(factor.values.begin(), factor.values.end(), [](const FactorValue& v) { return v.is_number; });
            axis.low = axis.high = factor.values.front().number;
            for (const FactorValue& value : factor.values) {
                if (!numbers) axis.words.push_back(value.text);
                axis.low = std::min(axis.low, value.number);
                axis.high = std::max(axis.high, value.number);
            }
            axis.lowest = axis.low;
            axis.highest = axis.high;
        } else {
            constexpr double tail = 1e-3, far_tail = 1e-7; // of what has no bounds
            axis.low = d.low ? *d.low : quantile(d, tail);
            axis.high = d.high ? *d.high : quantile(d, 1 - tail);
            axis.lowest = d.low ? *d.low : quantile(d, far_tail);
            axis.highest = d.high ? *d.high : quantile(d, 1 - far_tail);
            axis.logarithmic = d.type == FactorDistribution::Type::log_uniform;
        }
        axes_.push_back(std::move(axis));
    }
}

void FactorCube::require_inside(std::size_t k, const FactorValue& value) const
{
    const Axis& axis = axes_[k];
    if (!axis.words.empty()) {
        if (std::find(axis.words.begin(), axis.words.end(), value.text) == axis.words.end())
            throw Error(fmt::format("{}: The study has no value \"{}\"; take one that is in its list.", factors_[k].path, value.text));
        return;
    }
    const double rounding = 1e-9 * (axis.highest - axis.lowest);
    if (!value.is_number || !(value.number >= axis.lowest - rounding && value.number <= axis.highest + rounding))
        throw Error(fmt::format("{}: This must be from {:.6g} to {:.6g}, as in the study; given is {}.", factors_[k].path, axis.lowest,
                                axis.highest, value.text));
}

void FactorCube::add(std::vector<double>& place, std::size_t k, const FactorValue& value) const
{
    const Axis& axis = axes_[k];
    if (!axis.words.empty()) {
        const std::size_t coordinates = axis.words.size() == 2 ? 1 : axis.words.size();
        for (std::size_t i = 0; i < coordinates; ++i) place.push_back(axis.words[i] == value.text ? 1 : 0);
        return;
    }
    const auto at = [&](double number) { return axis.logarithmic ? std::log(number) : number; };
    const double width = at(axis.high) - at(axis.low);
    place.push_back(width > 0 ? (at(value.number) - at(axis.low)) / width : 0);
}

std::vector<double> FactorCube::place(const std::vector<FactorValue>& values) const
{
    if (values.size() != axes_.size())
        throw Error(fmt::format("A point has {} values; the study has {} factors.", values.size(), axes_.size()));
    std::vector<double> place;
    for (std::size_t k = 0; k < values.size(); ++k) {
        require_inside(k, values[k]);
        add(place, k, values[k]);
    }
    return place;
}

std::vector<double> FactorCube::place(const StudyPoints& points, std::size_t point) const
{
    std::vector<double> place;
    for (std::size_t k = 0; k < axes_.size(); ++k) add(place, k, points.value(point, k));
    return place;
}

} // namespace hygroloom
