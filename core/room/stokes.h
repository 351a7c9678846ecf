// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Stokes flow of the liquid that fills the room of a drawn layer: what the faster mobility of room_flow.h stands for.
#pragma once

#include "core/room/drawn_layer.h"

namespace hygroloom {

/// Permeability of the full room along one system of yarns, m2: flow per area of the layer's section, yarns included. No slip on yarns, at
/// their distance from velocities on voxels' sides; no shear on the faces. Errors in slots: 12 % over 4 voxels, 3 % over 8, less than 1 %
/// over 16. Throws Error where its equations cannot be solved.
double stokes_permeability(const DrawnLayer& layer, double growth, bool along_warp);

/// Air that crosses a layer: a pressure difference of viscosity x resistance x speed + density / 2 x loss x speed^2 drives a mean speed.
struct FlowThrough {
    double resistance = 0; ///< 1/m; 0: nothing passes
    double loss = 0;       ///< of the jets' energy, over that of the mean speed
};
/// Stokes flow through the room from face to face, of one of many layers with a third of a pitch of open space between each two. Borda and
/// Carnot's loss at the section where it is largest, of the profile that this flow has there: what leaves the holes mixes without giving
/// its pressure back, so that of momentum only the balance is left. drag: of fibres that stand in the room, 1/m2, beside the viscous shear
/// (Brinkman 1949). Throws Error where its equations cannot be solved.
FlowThrough flow_through(const DrawnLayer& layer, double growth, double drag = 0);

} // namespace hygroloom
