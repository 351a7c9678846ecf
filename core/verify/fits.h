// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Straight lines, slopes and bands for comparing curves with measurements.
#pragma once

#include "core/verify/verify.h"

#include <cmath>

namespace hygroloom {

/// The line of least squares, and the share of the scatter it explains.
struct FittedLine {
    double slope = 0, at_zero = 0, r_squared = 0;
};

inline FittedLine fit_line(const std::vector<double>& x, const std::vector<double>& y)
{
    const double n = static_cast<double>(x.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sx += x[i];
        sy += y[i];
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = x[i] - sx / n, dy = y[i] - sy / n;
        sxx += dx * dx;
        sxy += dx * dy;
        syy += dy * dy;
    }
    const double slope = sxy / sxx;
    return {slope, (sy - slope * sx) / n, sxy * sxy / (sxx * syy)};
}

/// A curve's value between its points; times rise.
inline double value_at(const std::vector<double>& time, const std::vector<double>& value, double at)
{
    for (std::size_t i = 1; i < time.size(); ++i)
        if (time[i] >= at) return value[i - 1] + (value[i] - value[i - 1]) * (at - time[i - 1]) / (time[i] - time[i - 1]);
    return value.back();
}

inline VerifyResult between(const std::string& name, double computed, double low, double high)
{
    return {name, computed, 0.5 * (low + high), 0.5 * (high - low)};
}
inline VerifyResult at_most(const std::string& name, double computed, double limit) { return {name, computed, limit, 0, Rule::at_most}; }
inline VerifyResult at_least(const std::string& name, double computed, double limit) { return {name, computed, limit, 0, Rule::at_least}; }
/// A direction: what one input gives over what another gives, or the reverse, must lie over or under a limit. Blind where both are the same
/// within a thousandth.
inline VerifyResult direction(VerifyResult ratio)
{
    ratio.blind = std::abs(ratio.computed - 1) <= 1e-3;
    return ratio;
}
inline VerifyResult ratio_at_least(const std::string& name, double ratio, double limit) { return direction(at_least(name, ratio, limit)); }
inline VerifyResult ratio_at_most(const std::string& name, double ratio, double limit) { return direction(at_most(name, ratio, limit)); }
/// A result that is known to miss, and by how much at most, in its unit. One that holds is no miss.
inline VerifyResult known_miss(VerifyResult result, const std::string& reason, double bound)
{
    if (result.pass()) return result;
    result.known_miss = reason;
    result.miss_bound = bound;
    return result;
}

} // namespace hygroloom
