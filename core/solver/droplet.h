// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A drop as particles: their places, and where the drop starts.
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

} // namespace hygroloom::inline HL_PRECISION
