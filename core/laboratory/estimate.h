// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A number and its range.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace hygroloom {

/// For what is not known of the cloth (input) and of the computation (numerical); what the physics leaves out (model) is not in it.
struct Estimate {
    double value = 0, low = 0, high = 0;
};

/// Several unknowns, each of which alone takes a value to one of two others: what all of them do, as the root of the squares of their
/// logarithms. All numbers above 0.
inline Estimate estimate_of(double value, const std::vector<std::pair<double, double>>& others)
{
    double down = 0, up = 0;
    if (!(value > 0)) {
        for (const auto& [a, b] : others) up = std::max({up, a, b});
        return {value, value, up};
    }
    for (const auto& [a, b] : others) {
        const double least = std::log(std::min({a, b, value}) / value), most = std::log(std::max({a, b, value}) / value);
        down += least * least;
        up += most * most;
    }
    return {value, value * std::exp(-std::sqrt(down)), value * std::exp(std::sqrt(up))};
}

inline Estimate scaled(const Estimate& estimate, double by) { return {by * estimate.value, by * estimate.low, by * estimate.high}; }

} // namespace hygroloom
