// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/intervals.h"

#include "core/analysis/tradeoff.h"
#include "core/base/units.h"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hygroloom {
namespace {

double mean_of(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Standard deviation of values about their mean.
double deviation(const std::vector<double>& values)
{
    const double mean = mean_of(values);
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

/// Standard deviation that a linear fit in the places leaves.
double left_by_fit(const std::vector<double>& values, const std::vector<std::vector<double>>& places)
{
    const auto n = static_cast<Eigen::Index>(values.size());
    const auto inputs = static_cast<Eigen::Index>(places.front().size());
    Eigen::MatrixXd a(n, inputs + 1);
    for (Eigen::Index i = 0; i < n; ++i) {
        a(i, 0) = 1;
        for (Eigen::Index k = 0; k < inputs; ++k) a(i, k + 1) = places[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    }
    const Eigen::Map<const Eigen::VectorXd> y(values.data(), n);
    const auto solver = a.colPivHouseholderQr();
    const Eigen::VectorXd left = y - a * solver.solve(y);
    return std::sqrt(left.squaredNorm() / static_cast<double>(n - solver.rank()));
}

/// Standard deviations.
struct Spread {
    double all = 0;
    bool parted = false; ///< into scatter and input: there are enough runs for a fit
    double scatter = 0, input = 0;
    int free = 0; ///< degrees of freedom of scatter: runs less what was fitted
};

Spread spread_of(const std::vector<double>& values, const std::vector<std::vector<double>>& places)
{
    Spread spread;
    if (values.size() < 2) return spread;
    spread.all = deviation(values);
    const std::size_t inputs = places.empty() ? 0 : places.front().size();
    spread.parted = values.size() >= inputs + 3;
    spread.free = static_cast<int>(values.size()) - 1;
    if (!spread.parted) return spread;
    spread.free -= static_cast<int>(inputs);
    spread.scatter = inputs == 0 ? spread.all : std::min(spread.all, left_by_fit(values, places));
    spread.input = std::sqrt(std::max(0.0, spread.all * spread.all - spread.scatter * spread.scatter));
    return spread;
}

/// The larger pitch, mm.
double crossing_of(const RunRecord& run)
{
    const Fabric* fabric = find_fabric(run.design, run.fabric);
    return fabric ? 10 / std::min(fabric->ends_per_cm, fabric->picks_per_cm) * run.plan.crossings_per_cell : 0;
}

/// Half a crossing, mm, of numbers that say how far water has come. Radii stand at one crossing or the next; a height is read between them,
/// but a front waits and leaps, so that heights of like strips scatter by 0.3 crossings (standard deviation).
double by_crossings(const RunRecord& run, const std::string& metric)
{
    return step_of(run, metric) > 0 || metric.starts_with("wick_height_") ? 0.5 * crossing_of(run) : 0;
}

/// The measured metric that a number is read from in the same way.
std::string measured_like(const std::string& metric)
{
    if (metric.ends_with("_min_mm") || metric.ends_with("_min_mg_mm")) return "wick_rate_mm_s05"; // water follows the front
    return metric == "drying_index_pct_min" ? "drying_rate_g_m2_h" : metric;
}

/// That of a stain's area, which no scene was measured for, is that of the ellipse of equal moments, of the axis that has more.
std::optional<double> expected_error(const std::map<std::string, double>& errors, const std::string& metric)
{
    const auto found = errors.find(measured_like(metric));
    if (found != errors.end()) return found->second;
    const auto warp = errors.find("wetted_area_ellipse_warp_mm"), weft = errors.find("wetted_area_ellipse_weft_mm");
    if (!metric.starts_with("equal_area_radius") || warp == errors.end() || weft == errors.end()) return {};
    return std::max(warp->second, weft->second);
}

} // namespace

double half_width_in_deviations(int replicates) { return student_factor(of_intervals, replicates - 1) * std::sqrt(1 + 1.0 / replicates); }

std::string few_replicates_text(int replicates)
{
    if (replicates < 2 || replicates >= fewest_useful_replicates) return {};
    return fmt::format(
        "{} replicates are few: an interval from them reaches {:.1f} standard deviations to either side ({:.1f} with {}, {:.1f} "
        "with 8), so that hardly anything differs by it. Run {} or more.",
        replicates, half_width_in_deviations(replicates), half_width_in_deviations(fewest_useful_replicates), fewest_useful_replicates,
        half_width_in_deviations(8), fewest_useful_replicates);
}

Interval interval_of(const std::vector<double>& values, const std::vector<std::vector<double>>& places, std::optional<double> numerical,
                     double least)
{
    Interval interval;
    interval.centre = mean_of(values);
    interval.numerical = numerical.value_or(0);
    interval.numerical_known = numerical.has_value();
    interval.runs = static_cast<int>(values.size());
    const Spread spread = spread_of(values, places);
    const double factor = interval.runs > 1 ? half_width_in_deviations(interval.runs) : 0;
    if (interval.runs > 1 && spread.parted) {
        interval.scatter = factor * spread.scatter;
        interval.input = factor * spread.input;
    } else if (interval.runs > 1) {
        interval.spread = factor * spread.all;
    }
    const double half = std::hypot(interval.numerical, factor * spread.all);
    interval.low = std::max(interval.centre - half, std::min(least, interval.centre));
    interval.high = interval.centre + half;
    return interval;
}

double least_of(const std::string& metric) { return may_be_negative(metric) ? -std::numeric_limits<double>::infinity() : 0; }

double step_of(const RunRecord& run, const std::string& metric)
{
    return metric.starts_with("maximum_wetted_radius") ? crossing_of(run) : 0;
}

std::optional<double> numerical_error(const RunRecord& run, const std::string& metric, double value)
{
    const std::optional<double> expected = expected_error(run.plan.expected_errors, metric);
    if (!expected) return {};
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    const double scale = error_scale(metric, value, experiment ? climate_at(*experiment, experiment->duration_s).temperature_c : 0);
    return std::hypot(*expected * scale, by_crossings(run, metric));
}

std::map<std::string, Interval> numerical_intervals(const RunRecord& run, const Metrics& metrics)
{
    std::map<std::string, Interval> intervals;
    for (const Outcome& outcome : outcomes_of(run, metrics))
        if (outcome.value)
            intervals[outcome.key] =
                interval_of({*outcome.value}, {}, numerical_error(run, outcome.key, *outcome.value), least_of(outcome.key));
    return intervals;
}

ShownInterval shown(const OutcomeInfo& info, const Interval& interval)
{
    const ShownValue value = shown(info, interval.centre);
    ShownInterval seen;
    seen.value = value.value;
    seen.unit = value.unit;
    seen.low = shown(info, interval.low).value;
    seen.high = shown(info, interval.high).value;
    seen.half = seen.high - value.value;
    constexpr double rounding = 1e-6; // of the value: nobody tells such numbers apart
    if (seen.half <= rounding * std::abs(value.value)) {
        seen.half = 0;
        seen.low = seen.high = seen.value;
    }
    seen.cut = seen.half > 0 && interval.centre - interval.low < 0.999 * (interval.high - interval.centre);
    const double finest = seen.half > 0 ? seen.half / 10 : std::abs(value.value) / 1000;
    seen.decimals = finest > 0 ? std::clamp(-static_cast<int>(std::floor(std::log10(finest) + 1e-9)), 0, 9) : 0;
    // "0.40 ± 0.40" would hide whether the interval holds 0.
    const auto rounded = [&seen](double number) { return std::round(std::abs(number) * std::pow(10.0, seen.decimals)); };
    if (seen.half > 0 && std::abs(seen.value) != seen.half && rounded(seen.value) == rounded(seen.half) && seen.decimals < 9)
        ++seen.decimals;
    return seen;
}

ShownInterval in_unit(ShownInterval interval, const ReaderUnit& unit)
{
    for (double* number : {&interval.value, &interval.low, &interval.high}) *number = unit.of(*number);
    interval.half *= unit.per_one;
    interval.decimals = std::max(0, interval.decimals - static_cast<int>(std::lround(std::log10(unit.per_one))));
    interval.unit = unit.unit;
    return interval;
}

const char* name_of(Verdict verdict)
{
    constexpr const char* names[] = {"better", "probably better", "no difference shown", "probably worse", "worse"};
    return names[static_cast<int>(verdict)];
}

Compared compare_pairs(const std::vector<double>& values, const std::vector<double>& baseline,
                       const std::vector<std::vector<double>>& places, double numerical, Better better)
{
    std::vector<double> differences;
    for (std::size_t i = 0; i < values.size(); ++i) differences.push_back(values[i] - baseline[i]);
    Compared compared;
    compared.pairs = static_cast<int>(differences.size());
    compared.difference = mean_of(differences);
    const Spread spread = spread_of(differences, places);
    double input = 0, by_scatter = 0;
    if (compared.pairs > 1) {
        input = student_factor(of_intervals, compared.pairs - 1) * (spread.parted ? spread.input : spread.all);
        by_scatter = student_factor(of_verdicts, spread.free) * (spread.parted ? spread.scatter : spread.all) / std::sqrt(compared.pairs);
    }
    const double half = std::hypot(numerical, input, by_scatter);
    compared.low = compared.difference - half;
    compared.high = compared.difference + half;
    const double side = compared.difference < 0 ? -1 : 1;
    const auto favours = [&](double difference) { return side * difference > numerical; };
    compared.share_of_pairs = static_cast<double>(std::count_if(differences.begin(), differences.end(), favours)) / compared.pairs;
    const double off = std::abs(compared.difference);
    const bool good = (side > 0) == (better == Better::more);
    if (off > half)
        compared.verdict = good ? Verdict::better : Verdict::worse;
    else if (compared.share_of_pairs >= 0.8 && off > std::hypot(numerical, by_scatter))
        compared.verdict = good ? Verdict::probably_better : Verdict::probably_worse;
    return compared;
}

} // namespace hygroloom
