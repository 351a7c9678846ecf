// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A drop as particles, and the constants of the pressure loop that follow from their spacing.
#pragma once

#include "core/base/vec3.h"

#include <span>
#include <vector>

namespace hygroloom::inline HL_PRECISION {

/// The count places of a cubic lattice nearest to a point between them, about their own middle; a ball. Same count, same places.
std::vector<Vec3d> droplet_lattice(int count, double spacing);

/// Height for a drop's centre at which its lowest point stays a spacing over all particles within its radius and a spacing, seen from
/// above; its own height where there are none so high.
double height_clear_of(std::span<const Vec3> particles, const Vec3d& centre, double radius, double spacing);

constexpr double support_in_spacings = 2.0; ///< of the kernel of density and pressure

/// Kinematic viscosity of particles, m2/s: the liquid's own, and what calms motion from particle to particle. capillarity: surface tension
/// over density, m3/s2.
double viscosity_of_particles(double own, double capillarity, double spacing);

/// Longest stable steps of particles, s.
struct LiquidSteps {
    double capillary, viscous;
};
LiquidSteps longest_steps(double capillarity, double viscosity, double spacing);

/// delta x dt^2 of the pressure loop for a particle in a full cubic lattice of this spacing, Pa s2 per kg/m3.
double pressure_stiffness(double spacing, double support);

} // namespace hygroloom::inline HL_PRECISION
