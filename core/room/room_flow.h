// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Slow flow of the liquid between the yarns of a drawn layer, along the cloth and through it.
#pragma once

#include "core/room/drawn_layer.h"

namespace hygroloom {

/// What a layer lets through along one system of yarns, m2.
struct AlongRoom {
    double mean = 0;             ///< of the whole cell: flow per area of the layer's section, yarns included
    double lower = 0, upper = 0; ///< the same through its lower half and through its upper one, in the flow of the whole
    std::vector<double> places;  ///< of each crossing, end x picks + pick: joined in series and side by side they come to the mean
};
struct RoomPermeability {
    AlongRoom warp, weft;
};

/// Of a layer whose yarns have grown so much (m). air: of each voxel, whether the room holds air there, which lets the liquid slip; empty:
/// it is full. A local mobility takes the place of Stokes flow: it obeys laplace(mobility) = -1, is nothing on yarns, and liquid flows by
/// mobility times pressure gradient. Exact in slots and ducts; in drawn weaves 7 to 41 % above Stokes flow when full; half full, a
/// prototype had it within 5 % of that.
RoomPermeability room_permeability(const DrawnLayer& layer, double growth, const std::vector<std::uint8_t>& air = {});

/// The same of the full room from one face through the layer to the other, m2.
double permeability_through(const DrawnLayer& layer, double growth);

} // namespace hygroloom
