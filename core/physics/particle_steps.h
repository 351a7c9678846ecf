// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What follows from the spacing of a liquid's particles (m): their kernel's support, viscosity, longest steps and neighbours.
#pragma once

#include "core/physics/sph_kernels.h"

#include <cmath>
#include <limits>

namespace hygroloom::inline HL_PRECISION {

constexpr double support_in_spacings = 2.0; ///< of the kernel of density and pressure

/// Kinematic viscosity of particles, m2/s: the liquid's own, and what calms motion from particle to particle. capillarity: surface tension
/// over density, m3/s2.
inline double viscosity_of_particles(double own, double capillarity, double spacing)
{
    constexpr double grain = 0.015; // numerical
    return own + grain * std::sqrt(capillarity * spacing);
}

/// Longest stable steps of particles, s.
struct LiquidSteps {
    double capillary, viscous;
};
/// The capillary one: a quarter of the time that a wave as long as the support needs (Morris 2000).
inline LiquidSteps longest_steps(double capillarity, double viscosity, double spacing)
{
    const double support = support_in_spacings * spacing;
    // Neighbours that all move against a particle take its speed from it at a rate of twice 10 nu / 3 times the integral of the kernel's
    // slope over the distance, which is 12 over the square of the support; it must not turn round.
    constexpr double viscous = 2.0 / (2.0 * 10.0 / 3.0 * 12.0);
    return {0.25 * std::sqrt(support * support * support / (2.0 * pi * capillarity)), viscous * support * support / viscosity};
}

/// Longest step with which liquid that stands deep (m) does not bounce, s. Rounds of pressure press it together by depth x gravity over the
/// square of spacing / step: a column bounces at 0.2 of that by 5 % of its pressure, at 0.25 by 10 %.
inline double longest_weight_step(double spacing, double gravity, double depth)
{
    const double fall = std::sqrt(gravity * depth);
    return fall > 0 ? 0.09 * spacing / fall : std::numeric_limits<double>::infinity();
}

/// delta x dt^2 of the pressure loop (Solenthaler and Pajarola 2009) for a particle in a full cubic lattice of this spacing, Pa s2 per
/// kg/m3.
inline double pressure_stiffness(double spacing, double support)
{
    Vec3d sum;
    double squares = 0;
    const int reach = static_cast<int>(std::ceil(support / spacing));
    for (int k = -reach; k <= reach; ++k)
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i) {
                const Vec3d d = spacing * Vec3d{double(i), double(j), double(k)};
                const Vec3d gradient = double(spline_gradient_factor(Real(length(d)), Real(support))) * d;
                sum += gradient;
                squares += dot(gradient, gradient);
            }
    // delta = 1 / (beta (sum . sum + squares)), beta = 2 (m dt / rho0)^2 with m = rho0 spacing^3.
    const double volume = spacing * spacing * spacing;
    return 1.0 / (2.0 * volume * volume * (dot(sum, sum) + squares));
}

/// Slots of a list of at least this many neighbours, in whole packs, with room for one pack that may be empty.
constexpr int slots_for(int neighbours) { return (neighbours / lanes + 1) * lanes; }
/// Of the list within the support and of the list beyond it; at rest 33 and 80 are listed without a skin, 64 and 112 with one.
constexpr int most_near = slots_for(120), most_distant = slots_for(152);

} // namespace hygroloom::inline HL_PRECISION
