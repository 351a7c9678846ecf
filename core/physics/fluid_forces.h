// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Surface tension and adhesion between particles of one liquid, and to a wall, from energies a microscope can see.
#pragma once

#include "core/base/units.h"
#include "core/physics/sph_kernels.h"

namespace hygroloom {

/// Pair force between particles at a distance r, over its strength: pushes within a third of the support, pulls beyond
/// (Tartakovsky and Meakin 2005). 1 at r = 0, 0 at r = H.
HL_FN Real pair_force_shape(Real r, Real support)
{
    const Real q = r / support;
    return q < Real(1) ? std::cos(Real(1.5 * pi) * q) : Real(0);
}

/// Strength of the pair force, N, that gives a liquid of that spacing a surface tension in N/m: gamma = pi/8 n^2 x integral of r^4
/// times the attraction (Rayleigh; Tartakovsky and Panchenko 2016), n = 1 / spacing^3, in the continuum limit.
HL_FN Real pair_cohesion(Real surface_tension, Real spacing, Real support)
{
    const Real fourth_moment = Real(0.1078622); // of -cos(3 pi q / 2) over 0..1
    const Real n = Real(1) / (spacing * spacing * spacing);
    const Real h5 = support * support * support * support * support;
    return surface_tension * Real(8) / (Real(pi) * n * n * h5 * fourth_moment);
}

/// Force density towards a flat wall, N/m3, at a distance from it: minus the slope of a potential whose integral over all distances is
/// the work of adhesion, so that Young and Dupre's law holds. Positive pulls.
HL_FN Real wall_pull(Real work_of_adhesion, Real distance, Real support)
{
    // The potential is twice the integral of W over the plane at that distance, which falls by 2 pi d W(d).
    return work_of_adhesion * Real(4.0 * pi) * distance * spline_kernel(distance, support);
}

} // namespace hygroloom
