// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cubic spline kernel in three dimensions with support radius H (Monaghan 1992).
#pragma once

#include "core/base/units.h"
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

/// d2W/dr2, 1/m5.
HL_FN Real spline_curvature(Real r, Real support)
{
    const Real q = r / support;
    const Real scale = Real(2.546479089470325) / (support * support * support * support * support);
    if (q <= Real(0.5)) return scale * (Real(36) * q - Real(12));
    if (q < Real(1)) return scale * Real(12) * (Real(1) - q);
    return 0;
}

/// Fifth powers of what is left of the support and of its inner half, which the integrals of the spline over planes are made of.
struct PlaneParts {
    Real outer, inner; ///< 1 - q and 1/2 - q, 0 if less
    HL_FN PlaneParts(Real distance, Real support)
    {
        const Real q = distance > 0 ? distance / support : Real(0);
        outer = q < Real(1) ? Real(1) - q : Real(0);
        inner = q < Real(0.5) ? Real(0.5) - q : Real(0);
    }
};

/// The part of the kernel that lies beyond a plane at that distance: 1/2 at the plane, 0 from the support on.
HL_FN Real kernel_beyond_plane(Real distance, Real support)
{
    const PlaneParts p(distance, support);
    const Real o5 = p.outer * p.outer * p.outer * p.outer * p.outer, i5 = p.inner * p.inner * p.inner * p.inner * p.inner;
    return o5 * (Real(1.6) - Real(6.4 / 6.0) * p.outer) - i5 * (Real(3.2) - Real(25.6 / 6.0) * p.inner);
}

/// The kernel's integral over the plane, 1/m: by how much kernel_beyond_plane() falls per distance.
HL_FN Real kernel_in_plane(Real distance, Real support)
{
    const PlaneParts p(distance, support);
    const Real o4 = p.outer * p.outer * p.outer * p.outer, i4 = p.inner * p.inner * p.inner * p.inner;
    return (o4 * (Real(8) - Real(6.4) * p.outer) - i4 * (Real(16) - Real(25.6) * p.inner)) / support;
}

/// Slope of kernel_in_plane() with distance, 1/m2.
HL_FN Real kernel_in_plane_slope(Real distance, Real support) { return -Real(2.0 * pi) * distance * spline_kernel(distance, support); }

} // namespace hygroloom
