// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/laboratory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hygroloom {
namespace {

/// Slope of the line of least squares; none through fewer than two different places.
std::optional<double> slope(const std::vector<double>& x, const std::vector<double>& y)
{
    const double n = static_cast<double>(x.size());
    double sx = 0, sy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sx += x[i];
        sy += y[i];
    }
    double sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sxx += (x[i] - sx / n) * (x[i] - sx / n);
        sxy += (x[i] - sx / n) * (y[i] - sy / n);
    }
    if (x.size() < 2 || sxx <= 0) return std::nullopt;
    return sxy / sxx;
}

/// When a curve first falls to a level, interpolated between two times.
std::optional<double> falls_to(const std::vector<double>& time, const std::vector<double>& curve, double level)
{
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (curve[i] > level) continue;
        if (i == 0) return time[0];
        return time[i - 1] + (curve[i - 1] - level) / (curve[i - 1] - curve[i]) * (time[i] - time[i - 1]);
    }
    return std::nullopt;
}

/// Between two times that are known; none beyond the last.
std::optional<double> value_at(const std::vector<double>& time, const std::vector<double>& curve, double at)
{
    constexpr double rounding = 1e-9; // of the time
    const auto next = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), at * (1 - rounding)) - time.begin());
    if (next == time.size()) return std::nullopt;
    if (next == 0) return curve[0];
    const double share = std::min(1.0, (at - time[next - 1]) / (time[next] - time[next - 1]));
    return curve[next - 1] + share * (curve[next] - curve[next - 1]);
}

/// The last index up to which the rate stayed constant from a time (s) on: see steady_to. None while it is constant.
std::optional<std::size_t> rate_holds_to(const std::vector<double>& time, const std::vector<double>& left, double from, double left_then)
{
    constexpr double held = 0.98;
    std::size_t slower = 0; // intervals in a row
    for (std::size_t i = 1; i < time.size(); ++i) {
        const double interval = time[i] - time[i - 1], so_far = time[i - 1] - from;
        if (so_far < interval) continue; // too short for a mean
        const double mean = (left_then - left[i - 1]) / so_far;
        slower = (left[i - 1] - left[i]) / interval < held * mean ? slower + 1 : 0;
        if (slower == 2) return i - 2;
    }
    return std::nullopt;
}

} // namespace

WickingResult wicking_result(const std::vector<double>& time, const std::vector<double>& height, const std::vector<double>& water)
{
    WickingResult result;
    if (time.empty()) return result;
    result.height = height.back();
    std::vector<double> root, risen;
    const auto highest = std::max_element(height.begin(), height.end()) - height.begin(); // the first of them
    for (std::size_t i = 0; i <= static_cast<std::size_t>(highest); ++i)
        if (height[i] > 0) {
            root.push_back(std::sqrt(time[i]));
            risen.push_back(height[i]);
        }
    result.rate = slope(root, risen);
    for (std::size_t i = 0; i < rise_minutes.size(); ++i) {
        const double at = 60.0 * rise_minutes[i];
        if (const auto reached = value_at(time, height, at)) result.after[i] = Rise{*reached, *value_at(time, water, at)};
    }
    return result;
}

DryingResult drying_result(const std::vector<double>& time, const std::vector<double>& left, const std::vector<double>& temperature,
                           double area)
{
    DryingResult result;
    if (time.empty() || left.front() <= 0) return result;
    const double first = left.front();
    const std::optional<double> from = falls_to(time, left, steady_from * first);
    std::optional<double> to = falls_to(time, left, steady_to * first);
    result.time_to_dry = falls_to(time, left, 0.04 * first);
    if (!from) return result;
    double left_then = steady_to * first;
    if (const auto last = rate_holds_to(time, left, *from, steady_from * first); last && left[*last] > left_then) {
        to = time[*last];
        left_then = left[*last];
    }
    if (!to) return result;
    result.rate = (steady_from * first - left_then) / (*to - *from) / area;
    result.index = *result.rate * area / first;
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] >= *from && time[i] <= *to) {
            sum += temperature[i];
            ++count;
        }
    if (count > 0) result.steady_temperature = sum / count;
    return result;
}

ConditioningResult conditioning_result(const std::vector<double>& time, const std::vector<double>& regain,
                                       const std::vector<double>& temperature, const std::vector<double>& air_temperature)
{
    ConditioningResult result;
    if (time.empty()) return result;
    result.regain_start = regain.front();
    result.regain_end = regain.back();
    const double change = result.regain_end - result.regain_start;
    std::vector<double> to_go;
    to_go.reserve(regain.size());
    for (double r : regain) to_go.push_back(change == 0 ? 0 : (result.regain_end - r) / change);
    if (change != 0) result.half_time = falls_to(time, to_go, 0.5);
    for (std::size_t i = 0; i < time.size(); ++i) result.peak_rise = std::max(result.peak_rise, temperature[i] - air_temperature[i]);
    const double late = time.front() + 0.9 * (time.back() - time.front());
    result.settled = true;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] >= late && std::abs(to_go[i]) > 0.02) result.settled = false;
    return result;
}

} // namespace hygroloom
