// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/effect_curve.h"

#include "core/base/student.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace hygroloom {

namespace {

constexpr int places = 60;                            // of a curve
constexpr std::size_t most_single = 2000, bins = 500; // rows that count one by one; else those of a bin count together

/// x from 0 to 1 over the factor's axis; how many rows each stands for.
struct Rows {
    std::vector<double> x, y, count;
};

Rows binned(const Rows& rows)
{
    if (rows.x.size() <= most_single) { return rows; }
    Rows sums{std::vector<double>(bins), std::vector<double>(bins), std::vector<double>(bins)}, made;
    for (std::size_t row = 0; row < rows.x.size(); ++row) {
        const auto bin = static_cast<std::size_t>(std::clamp(rows.x[row] * bins, 0.0, bins - 1.0));
        sums.x[bin] += rows.x[row];
        sums.y[bin] += rows.y[row];
        ++sums.count[bin];
    }
    for (std::size_t bin = 0; bin < bins; ++bin) {
        if (sums.count[bin] == 0) { continue; }
        made.x.push_back(sums.x[bin] / sums.count[bin]);
        made.y.push_back(sums.y[bin] / sums.count[bin]);
        made.count.push_back(sums.count[bin]);
    }
    return made;
}

Rows finiteRows(const StudyAxis& factor, const StudyAxis& metric)
{
    Rows rows;
    for (std::size_t row = 0; row < metric.numbers.size(); ++row) {
        if (!std::isfinite(metric.numbers[row]) || !std::isfinite(factor.numbers[row])) { continue; }
        rows.x.push_back(factor.placeOf(factor.numbers[row]));
        rows.y.push_back(metric.numbers[row]);
        rows.count.push_back(1);
    }
    return rows;
}

EffectPoint meanOf(double at, const std::vector<double>& values)
{
    const double count = static_cast<double>(values.size());
    EffectPoint point{at, 0, std::numeric_limits<double>::quiet_NaN(), values.size()};
    for (const double value : values) { point.mean += value / count; }
    if (values.size() < 2) { return point; }
    double squares = 0;
    for (const double value : values) { squares += (value - point.mean) * (value - point.mean); }
    point.off = student_factor(of_intervals, static_cast<int>(values.size()) - 1) * std::sqrt(squares / (count - 1) / count);
    return point;
}

/// The line through the rows near a place, weighted by how near they are.
struct LocalLine {
    double mean = 0;
    double squares = 0; ///< of the shares with which rows count
    double own = 0;     ///< the share of a row that lies just there
};

LocalLine lineAt(const Rows& rows, double place, double width)
{
    double s0 = 0, s1 = 0, s2 = 0;
    std::vector<double> weights(rows.x.size());
    for (std::size_t row = 0; row < rows.x.size(); ++row) {
        const double off = rows.x[row] - place, w = std::exp(-0.5 * off * off / (width * width));
        weights[row] = w;
        s0 += rows.count[row] * w;
        s1 += rows.count[row] * w * off;
        s2 += rows.count[row] * w * off * off;
    }
    const double whole = s0 * s2 - s1 * s1;
    LocalLine line;
    const bool flat = !(whole > 1e-12 * s0 * s0); // all rows at one place
    for (std::size_t row = 0; row < rows.x.size(); ++row) {
        const double share = flat ? weights[row] / s0 : weights[row] * (s2 - s1 * (rows.x[row] - place)) / whole;
        line.mean += rows.count[row] * share * rows.y[row];
        line.squares += rows.count[row] * share * share;
    }
    line.own = flat ? 1 / s0 : s2 / whole;
    return line;
}

double widthOf(const Rows& rows)
{
    const double count = static_cast<double>(rows.x.size());
    double mean = 0, squares = 0;
    for (const double x : rows.x) { mean += x / count; }
    for (const double x : rows.x) { squares += (x - mean) * (x - mean); }
    return std::max(0.02, 1.06 * std::sqrt(squares / count) * std::pow(count, -0.2));
}

EffectCurve curveOf(const StudyAxis& factor, const Rows& rows)
{
    const double width = widthOf(rows);
    std::vector<LocalLine> lines;
    const Rows together = binned(rows);
    for (int k = 0; k < places; ++k) { lines.push_back(lineAt(together, k / (places - 1.0), width)); }
    const auto between = [&lines](double x, double LocalLine::*member) {
        const double at = std::clamp(x, 0.0, 1.0) * (places - 1);
        const auto left = std::min(static_cast<std::size_t>(at), lines.size() - 2);
        const double share = at - static_cast<double>(left);
        return (1 - share) * (lines[left].*member) + share * (lines[left + 1].*member);
    };
    double squares = 0, taken = 0; // by the curve, of the rows' freedom
    for (std::size_t row = 0; row < rows.x.size(); ++row) {
        const double off = rows.y[row] - between(rows.x[row], &LocalLine::mean);
        squares += off * off;
        taken += between(rows.x[row], &LocalLine::own);
    }
    const double freedom = std::max(1.0, static_cast<double>(rows.x.size()) - taken);
    const double scatter = std::sqrt(squares / freedom), factor_of_interval = student_factor(of_intervals, static_cast<int>(freedom));
    EffectCurve curve{true, {}};
    for (int k = 0; k < places; ++k) {
        const LocalLine& line = lines[static_cast<std::size_t>(k)];
        curve.points.push_back(
            {factor.numberAt(k / (places - 1.0)), line.mean, factor_of_interval * scatter * std::sqrt(line.squares), rows.x.size()});
    }
    return curve;
}

} // namespace

EffectCurve effectCurve(const StudyAxis& factor, const StudyAxis& metric)
{
    std::map<double, std::vector<double>> levels;
    for (std::size_t row = 0; row < metric.numbers.size(); ++row) {
        if (std::isfinite(metric.numbers[row]) && std::isfinite(factor.numbers[row])) {
            levels[factor.numbers[row]].push_back(metric.numbers[row]);
        }
    }
    const Rows rows = finiteRows(factor, metric);
    const bool few = levels.size() <= most_effect_levels && rows.x.size() >= 2 * levels.size(); // repeated: levels that were chosen
    EffectCurve curve;
    if (!factor.words.empty() || few) {
        for (const auto& [at, values] : levels) { curve.points.push_back(meanOf(at, values)); }
        return curve;
    }
    return rows.x.size() < fewest_effect_rows ? curve : curveOf(factor, rows);
}

} // namespace hygroloom
