// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Ends of scales.
#pragma once

#include <cmath>
#include <initializer_list>

namespace hygroloom {

/// A number to put at the end of a scale: short, and not below value. 1 where value is what rounding leaves of 0.
inline double rounded_up(double value)
{
    constexpr double rounding = 1e-9, nothing = 1e-9; // less is what rounding leaves of sums
    if (!(value > nothing)) return 1;
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double factor : {1.0, 1.2, 1.6, 2.0, 2.4, 3.0, 4.0, 5.0, 6.0, 8.0})
        if (factor * power >= value * (1 - rounding)) return factor * power;
    return 10 * power;
}

} // namespace hygroloom
