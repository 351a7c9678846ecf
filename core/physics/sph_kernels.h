// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cubic spline kernel in three dimensions with support radius H (Monaghan 1992).
#pragma once

#include "core/base/lanes.h"
#include "core/base/units.h"
#include "core/base/vec3.h"

namespace hygroloom::inline HL_PRECISION {

/// W(r), 1/m3; of one distance (Real) or a pack of them.
template <typename T> HL_FN T spline_kernel(T r, Real support)
{
    const T q = r * (Real(1) / support);
    const T rest = positive(Real(1) - q), inner = positive(Real(0.5) - q);
    return (Real(2.546479089470325) / (support * support * support)) * // 8 / pi
           (Real(2) * rest * rest * rest - Real(8) * inner * inner * inner);
}

/// dW/dr, 1/m4.
template <typename T> HL_FN T spline_slope(T r, Real support)
{
    const T q = r * (Real(1) / support);
    const T rest = positive(Real(1) - q), inner = positive(Real(0.5) - q);
    return (Real(2.546479089470325) / (support * support * support * support)) * (Real(24) * inner * inner - Real(6) * rest * rest);
}

/// 1 / r; at no distance something large, which does not matter there.
template <typename T> HL_FN T inverse_distance(T r, Real support) { return inverse(r + Real(1e-6) * support); }

/// dW/dr / r, 1/m5, so that grad W = this x (r_i - r_j).
template <typename T> HL_FN T spline_gradient_factor(T r, Real support) { return spline_slope(r, support) * inverse_distance(r, support); }

/// d2W/dr2, 1/m5.
template <typename T> HL_FN T spline_curvature(T r, Real support)
{
    const T q = r * (Real(1) / support);
    return (Real(2.546479089470325) / (support * support * support * support * support)) *
           (Real(12) * positive(Real(1) - q) - Real(48) * positive(Real(0.5) - q));
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

/// Integral of -r dW/dr beyond a plane at that distance, by the divergence of r W.
HL_FN Real slope_virial_beyond_plane(Real distance, Real support)
{
    return Real(3) * kernel_beyond_plane(distance, support) + distance * kernel_in_plane(distance, support);
}

/// Integral of z d2W/dr2 beyond a plane at that distance, 1/m, z the way along the plane's normal; twice by parts.
HL_FN Real curvature_virial_beyond_plane(Real distance, Real support)
{
    return Real(3) * kernel_in_plane(distance, support) - distance * kernel_in_plane_slope(distance, support);
}

} // namespace hygroloom::inline HL_PRECISION
