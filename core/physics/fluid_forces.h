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
/// whatever the pressure loop makes of it. Source: derived here; figures in core/verify/README.md.
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
/// at rest under their own pressure, make it less: a calibration on swings and Laplace pressures of 1 000 to 64 000 particles.
constexpr double surface_tension_of_well = 0.1425;

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
/// the continuum, so the potential's strength and the share are a calibration: on sessile drops of 5 ul without gravity, a vessel's on
/// 1 000 and 4 000 particles with walls as wall_recess says, where strengths of 0.05, 0.38, 0.64, 0.75, 0.83 and 0.88 came to 88, 71, 57,
/// 52, 47 and 43 degrees and shares of 0.59, 0.41, 0.27 and 0.17 to 107, 122, 138 and 152.

/// Energy per area of a vessel's potential over the surface tension.
HL_FN Real wall_attraction(Real cosine)
{
    constexpr Real at_all = Real(0.01);
    if (cosine <= 0) return at_all;
    const Real partly = at_all + cosine * (Real(1.112) + Real(0.175) * cosine), nearly = Real(1.03) - Real(0.39) * (Real(1) - cosine);
    return partly < nearly ? partly : nearly; // at 1 a drop spreads to one layer
}

/// How much a vessel's wall counts as liquid.
HL_FN Real wall_share(Real cosine)
{
    if (cosine >= 0) return Real(1);
    const Real repelled = Real(-1.4493) * cosine, half = Real(1.2754);
    return Real(1) - std::sqrt(repelled / (half + std::sqrt(half * half - repelled)));
}

/// Of a spacing: so far behind a vessel's face begins the liquid that it counts as in the density. Without it the first layer keeps off
/// the face, liquid inside is pressed together by what it lacks at its sides, and particles at rest rattle. A calibration on pressures
/// in boxes of 2 000 and 8 000 particles, 10 to 40 mm deep, and on the speeds of drops at rest; see core/physics/DECISIONS.md.
constexpr Real wall_recess = Real(0.1);

/// Attraction and share of yarns' beads, which touch otherwise: a calibration on plates without recess and 1 000 to 16 000 particles,
/// the attraction since scaled with the surface's energy. `verify drop_on_yarns` measures angles on yarns.
HL_FN Real bead_attraction(Real cosine)
{
    constexpr Real at_all = Real(0.0536);
    if (cosine <= 0) return at_all;
    const Real partly = at_all + cosine * (Real(1.386) - Real(0.352) * cosine), nearly = Real(1.03) - Real(0.577) * (Real(1) - cosine);
    return partly < nearly ? partly : nearly;
}
HL_FN Real bead_share(Real cosine)
{
    return cosine < 0 ? Real(1) - (std::sqrt(Real(0.5184) - Real(1.82) * cosine) - Real(0.72)) / Real(0.91) : Real(1);
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
