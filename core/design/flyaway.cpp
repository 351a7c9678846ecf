// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/flyaway.h"

#include "core/base/units.h"

#include <cmath>

namespace hygroloom {

double loop_length(double height, double turns_per_length, double radius)
{
    constexpr int steps = 64;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double x = 2 * (i + 0.5) / steps - 1; // over half the base
        const double bump = std::pow(std::cos(0.5 * pi * x), 2);
        const double slope = -0.5 * pi / loop_width * std::sin(pi * x);
        const double round = 2 * pi * turns_per_length * (radius + height * bump);
        sum += std::sqrt(1 + slope * slope + round * round);
    }
    return sum * 2 * loop_width * height / steps;
}

double mean_loop_length(double greatest_height, double turns_per_length, double radius)
{
    constexpr int steps = 16;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        sum += loop_length(greatest_height * (lowest_loop + (1 - lowest_loop) * (i + 0.5) / steps), turns_per_length, radius);
    return sum / steps;
}

} // namespace hygroloom
