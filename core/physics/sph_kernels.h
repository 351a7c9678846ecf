// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cubic spline kernel in three dimensions with support radius H (Monaghan 1992).
#pragma once

#include "core/base/lanes.h"
#include "core/base/units.h"
#include "core/base/vec3.h"

namespace hygroloom::inline HL_PRECISION {

/// The kernel of support 1 at a distance q, in the parts it is made of; of one distance (Real) or a pack of them.
template <typename T> struct Spline {
    T outer, inner; ///< 1 - q and 1/2 - q, 0 if less

    HL_FN explicit Spline(const T& q) : outer(positive(Real(1) - q)), inner(positive(Real(0.5) - q)) {}
    HL_FN T kernel() const { return outer * outer * outer - Real(4) * (inner * inner * inner); } ///< W, over 16 / pi
    HL_FN T slope() const { return Real(4) * (inner * inner) - outer * outer; }                  ///< dW/dq, over 48 / pi
    HL_FN T curvature() const { return Real(2) * outer - Real(8) * inner; }                      ///< d2W/dq2, over 48 / pi
};

/// The same for those who are farther than half the support.
template <typename T> struct OuterSpline {
    T outer;

    HL_FN explicit OuterSpline(const T& q) : outer(positive(Real(1) - q)) {}
    HL_FN T kernel() const { return outer * outer * outer; }
    HL_FN T slope() const { return -(outer * outer); }
    HL_FN T curvature() const { return Real(2) * outer; }
};

/// What kernels of a support H are of Spline's.
struct SplineUnits {
    Real per_metre;       ///< 1 / H
    Real kernel;          ///< 16 / (pi H3)
    Real slope;           ///< 48 / (pi H4)
    Real gradient_factor; ///< 48 / (pi H5), of slope() / q, and of curvature()
    Real nothing;         ///< m2, square of a distance that makes no difference

    HL_FN explicit SplineUnits(Real support)
        : per_metre(Real(1) / support), kernel(Real(5.09295817894065) * per_metre * per_metre * per_metre),
          slope(Real(3) * kernel * per_metre), gradient_factor(slope * per_metre), nothing(Real(1e-12) * support * support)
    {
    }
};

/// W(r), 1/m3.
template <typename T> HL_FN T spline_kernel(T r, Real support)
{
    const SplineUnits units(support);
    return units.kernel * Spline<T>(r * units.per_metre).kernel();
}

/// dW/dr / r, 1/m5, so that grad W = this x (r_i - r_j).
template <typename T> HL_FN T spline_gradient_factor(T r, Real support)
{
    const SplineUnits units(support);
    const T q = r * units.per_metre;
    return units.gradient_factor * Spline<T>(q).slope() * inverse(q + Real(1e-6)); // at no distance it does not matter
}

/// d2W/dr2, 1/m5.
template <typename T> HL_FN T spline_curvature(T r, Real support)
{
    const SplineUnits units(support);
    return units.gradient_factor * Spline<T>(r * units.per_metre).curvature();
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
