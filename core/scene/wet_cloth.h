// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloth that is wet all over from the start.
#pragma once

#include "core/scene/scene.h"

namespace hygroloom {

constexpr double most_film = 1e-4; ///< m on each face, before it drips; an assumption

/// Water (kg/m2) of a drying test goes where it is held hardest: fibres bind first, then the pores of all yarns fill alike, then the rooms
/// between them at one suction, and what is left stands as a film on both faces. Throws Error where the cloth does not hold so much.
void wet_evenly(Scene& scene, double water_per_area);

} // namespace hygroloom
