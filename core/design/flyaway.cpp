// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/flyaway.h"

#include "core/base/units.h"

#include <array>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int loop_steps = 64;

/// A loop's form at the middle of each step.
struct LoopForm {
    std::array<double, loop_steps> bump; ///< height over the greatest
    std::array<double, loop_steps> rise; ///< 1 + the slope squared
};

LoopForm form_of_loops()
{
    LoopForm form;
    for (std::size_t i = 0; i < loop_steps; ++i) {
        const double x = 2 * (static_cast<double>(i) + 0.5) / loop_steps - 1; // over half the base
        const double slope = -0.5 * pi / loop_width * std::sin(pi * x);
        form.bump[i] = std::pow(std::cos(0.5 * pi * x), 2);
        form.rise[i] = 1 + slope * slope;
    }
    return form;
}

} // namespace

double loop_length(double height, double turns_per_length, double radius)
{
    static const LoopForm form = form_of_loops();
    double sum = 0;
    for (std::size_t i = 0; i < loop_steps; ++i) {
        const double round = 2 * pi * turns_per_length * (radius + height * form.bump[i]);
        sum += std::sqrt(form.rise[i] + round * round);
    }
    return sum * 2 * loop_width * height / loop_steps;
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
