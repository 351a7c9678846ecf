// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Stokes flow of the liquid that fills the room of a drawn layer: what the faster mobility of room_flow.h stands for.
#pragma once

#include "core/room/drawn_layer.h"

namespace hygroloom {

/// Permeability of the full room along one system of yarns, m2: flow per area of the layer's section, yarns included. No slip on yarns, at
/// their distance from velocities on voxels' sides; no shear on the faces. Errors in slots: 12 % over 4 voxels, 3 % over 8, less than 1 %
/// over 16.
double stokes_permeability(const DrawnLayer& layer, double growth, bool along_warp);

} // namespace hygroloom
