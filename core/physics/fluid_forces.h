// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Surface tension of a liquid of particles, and adhesion to a wall, from energies a microscope can see.
#pragma once

#include "core/base/units.h"
#include "core/physics/sph_kernels.h"

namespace hygroloom::inline HL_PRECISION {

/// The energy per volume of a liquid whose share of the space round a particle is phi (1 deep inside, 1/2 at the surface):
///     e = a ((1 - phi)^2 + sharpness H^2 |grad phi|^2),
/// a well that holds particles and a gradient that keeps them from being drawn together at the surface; of van der Waals's kind (Cahn
/// and Hilliard 1958), but nothing is left of it inside the liquid. The sharpness is chosen such that the layer under a flat surface is
/// pressed together a little everywhere and by a third of what the well alone would do: only then is the surface's energy the same
/// whatever the pressure loop makes of it. Source: derived here; figures in DECISIONS.md.
struct SurfaceEnergy {
    Real well;     ///< a, Pa
    Real gradient; ///< a x sharpness x H^2, N

    /// Twice the well's slope: minus de/dphi; nothing where the liquid is denser than at rest.
    HL_FN Real pull(Real phi) const { return phi < Real(1) ? Real(2) * well * (Real(1) - phi) : Real(0); }
    /// de/d(grad phi).
    HL_FN Vec3 tilt(const Vec3& grad_phi) const { return (Real(2) * gradient) * grad_phi; }
};

constexpr double surface_support_in_spacings = 3.0;
constexpr double surface_sharpness = 0.0545;
/// Surface tension over a x spacing. In the continuum, integrated over the layer under a flat surface, 0.1814; particles in shells,
/// at rest under their own pressure, make it less: a calibration on swings and Laplace pressures of 700 to 16 000 particles.
constexpr double surface_tension_of_well = 0.1468;

HL_FN SurfaceEnergy surface_energy(Real surface_tension, Real spacing)
{
    const Real support = Real(surface_support_in_spacings) * spacing;
    const Real well = surface_tension / (Real(surface_tension_of_well) * spacing);
    return {well, well * Real(surface_sharpness) * support * support};
}

/// Force on the first of two particles, by the way from the second to it and by the first's tilt less the second's.
template <typename T> struct SurfaceForce {
    T along;   ///< the way
    T against; ///< the tilt
};

/// Over the square of the particles' volume and SplineUnits::slope, N m-2: minus the slope of the energy. d is the way, inverse one over
/// its length; pull is the sum of both. Of one pair (Real) or a pack of them.
template <typename T, typename Kernel>
HL_FN SurfaceForce<T> surface_force(const T& pull, const Vec3T<T>& tilt, const Vec3T<T>& d, const T& inverse, const Kernel& kernel,
                                    Real per_metre)
{
    const T slope = kernel.slope() * inverse;
    const T towards = dot(tilt, d) * (inverse * inverse);
    return {pull * slope - (per_metre * kernel.curvature() - slope) * towards, slope};
}

/// A wall is wetted at an angle whose cosine is the energy that a covered area gains over the surface tension. It counts as liquid,
/// which gains nothing (90 degrees). Where the liquid wets it more it attracts by a potential besides; where it wets less it counts as
/// liquid only in part, s: what phi lacks then grows with 1 - s, and the energy with its square. In layers of particles both differ from
/// the continuum, so the potential's strength and the share are a calibration: on sessile drops of 5 ul and 1 000 to 16 000 particles
/// without gravity, which with 1 000, a strength of cos and a share of 1 + cos came to 39, 56, 68, 80, 93, 104, 121 and 142 degrees where
/// 30, 45, 60, 75, 90, 105, 120 and 135 were asked for.

/// Energy per area of the wall's potential over the surface tension.
HL_FN Real wall_attraction(Real cosine)
{
    constexpr Real at_all = Real(0.052);
    if (cosine <= 0) return at_all;
    const Real partly = at_all + cosine * (Real(1.346) - Real(0.342) * cosine), nearly = Real(1) - Real(0.56) * (Real(1) - cosine);
    return partly < nearly ? partly : nearly; // at 1 a drop spreads to one layer
}

/// How much the wall counts as liquid.
HL_FN Real wall_share(Real cosine)
{
    return cosine < 0 ? Real(1) - (std::sqrt(Real(0.5184) - Real(1.82) * cosine) - Real(0.72)) / Real(0.91) : Real(1);
}

/// The pressure that a wall carries as if the liquid went on behind it follows that of the particle before it in ten steps; so much of what
/// both differ by it takes over at once. What a particle pushes itself off with leads to no other density and is not taken back, so that
/// drops at rest rattle with all of it. From 60 degrees on a wall takes over nothing; below 53 all, for calm drops stick there (at 45 to 47
/// degrees where 30 were asked for).
HL_FN Real rattling_share(Real cosine)
{
    constexpr Real none = Real(0.5), all = Real(0.6);
    return cosine <= none ? Real(0) : cosine < all ? (cosine - none) / (all - none) : Real(1);
}

/// Force density on a particle by a flat wall that counts as liquid, N/m3; the normal points from the wall to the particle.
HL_FN Real surface_force_of_wall(Real pull, Real tilt_along_normal, Real distance, Real support)
{
    return tilt_along_normal * kernel_in_plane_slope(distance, support) - pull * kernel_in_plane(distance, support);
}

/// Force density towards a flat wall, N/m3, at a distance from it: minus the slope of a potential whose integral over all distances is
/// the energy per area. Positive pulls.
HL_FN Real wall_pull(Real energy_per_area, Real distance, Real support)
{
    // The potential is twice the integral of W over the plane at that distance, which falls by 2 pi d W(d).
    return energy_per_area * Real(4.0 * pi) * distance * spline_kernel(distance, support);
}

} // namespace hygroloom::inline HL_PRECISION
