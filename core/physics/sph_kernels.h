// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cubic spline kernel in three dimensions with support radius H (Monaghan 1992), and what half-spaces cut from it.
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

/// Area integral of W over the plane at a distance d, 1/m: the gradient of the share of the kernel that lies beyond the plane.
HL_FN Real spline_plane_integral(Real distance, Real support)
{
    const Real q = (distance < 0 ? -distance : distance) / support;
    if (q >= Real(1)) return 0;
    // 2 pi x integral of W r dr from d to H, with W in powers of q.
    const Real rest = Real(1) - q;
    const Real outer = Real(32) * rest * rest * rest * rest * (Real(0.25) - Real(0.2) * rest); // 16 x 2 x int (1-q)^3 q dq
    if (q > Real(0.5)) return outer / support;
    const Real h = Real(0.5);
    const Real inner_at_half = h * h / 2 + Real(6) * (h * h * h * h * h / 5 - h * h * h * h / 4);
    const Real inner_at_q = q * q / 2 + Real(6) * (q * q * q * q * q / 5 - q * q * q * q / 4);
    const Real outer_at_half = Real(32) * Real(0.0625) * (Real(0.25) - Real(0.1));
    return (Real(16) * (inner_at_half - inner_at_q) + outer_at_half) / support;
}

} // namespace hygroloom
