// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Quantiles of the distributions that factors may have.
#pragma once

#include "core/study/study.h"

namespace hygroloom {

/// The value below which a share (0 to 1) of the distribution lies, of what is between its bounds.
double quantile(const FactorDistribution& distribution, double probability);

/// With 10 digits: two machines' mathematical libraries may differ in the last of 16.
double rounded_for_all(double number);

} // namespace hygroloom
