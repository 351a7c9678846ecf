// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Heat or vapour through a drawn layer, at rest: Laplace's equation with one conductivity between the yarns and one in them.
#pragma once

#include "core/room/drawn_layer.h"

namespace hygroloom {

/// From face to face of a layer whose yarns have grown so much (m), in the unit of the two conductivities given, which must be above 0.
/// Each face has one temperature, or one concentration. A voxel that a skin cuts has the mean of both. Throws Error where its equations
/// cannot be solved.
double conductivity_through(const DrawnLayer& layer, double growth, double room, double yarns);

} // namespace hygroloom
