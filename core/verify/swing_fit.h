// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The damped oscillation that fits a series best.
#pragma once

#include <vector>

namespace hygroloom {

struct Swing {
    double frequency = 0; ///< Hz
    double damping = 0;   ///< s
};

/// Least squares of a damped oscillation about a constant, with a frequency from half to twice the expected one (Hz).
Swing fit_swing(const std::vector<double>& times, const std::vector<double>& values, double expected);

} // namespace hygroloom
