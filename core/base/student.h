// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Intervals of few numbers.
#pragma once

namespace hygroloom {

/// How much of a distribution a symmetric interval holds, and the normal law's half width of it.
struct Level {
    double held, normal;
};
constexpr Level of_intervals{0.90, 1.6448536};
constexpr Level of_verdicts{0.98, 2.3263479}; ///< that scatter alone made a mean difference

/// Half width by Student's law: 6.31 for 90 % at one degree of freedom, 1.645 at very many. Exact at 1 and 2, else the expansion of
/// Abramowitz and Stegun 26.7.5, within 0.5 %.
double student_factor(const Level& level, int degrees_of_freedom);

} // namespace hygroloom
