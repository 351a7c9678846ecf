// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cubic spline kernel in three dimensions with support radius H (Monaghan 1992).
#pragma once

#include "core/base/vec3.h"

namespace hygroloom {

/// W(r), 1/m3.
HL_FN Real spline_kernel(Real r, Real support)
{
    const Real q = r / support;
    const Real scale = Real(2.546479089470325) / (support * support * support); // 8 / pi
    if (q <= Real(0.5)) return scale * (Real(1) + Real(6) * q * q * (q - Real(1)));
    if (q < Real(1)) {
        const Real rest = Real(1) - q;
        return scale * Real(2) * rest * rest * rest;
    }
    return 0;
}

/// dW/dr / r, 1/m5, so that grad W = this x (r_i - r_j); 0 at r = 0.
HL_FN Real spline_gradient_factor(Real r, Real support)
{
    const Real q = r / support;
    const Real scale = Real(2.546479089470325) / (support * support * support * support * support);
    if (q <= Real(1e-6)) return 0;
    if (q <= Real(0.5)) return scale * (Real(18) * q - Real(12));
    if (q < Real(1)) {
        const Real rest = Real(1) - q;
        return -scale * Real(6) * rest * rest / q;
    }
    return 0;
}

} // namespace hygroloom
