// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cubic spline kernel in three dimensions with support radius H (Monaghan 1992).
#pragma once

#include "core/base/lanes.h"

namespace hygroloom {

/// W(r), 1/m3; of one distance (Real) or a pack of them.
template <typename T> HL_FN T spline_kernel(T r, Real support)
{
    const T q = r * (Real(1) / support);
    const T rest = positive(Real(1) - q), inner = positive(Real(0.5) - q);
    return (Real(2.546479089470325) / (support * support * support)) * // 8 / pi
           (Real(2) * rest * rest * rest - Real(8) * inner * inner * inner);
}

/// dW/dr / r, 1/m5, so that grad W = this x (r_i - r_j).
template <typename T> HL_FN T spline_gradient_factor(T r, Real support)
{
    const Real no_distance = Real(1e-6); // keeps 0/0 away; there the factor does not matter
    const T q = r * (Real(1) / support);
    const T rest = positive(Real(1) - q), inner = positive(Real(0.5) - q);
    return (Real(2.546479089470325) / (support * support * support * support * support)) *
           (Real(24) * inner * inner - Real(6) * rest * rest) / (q + no_distance);
}

} // namespace hygroloom
