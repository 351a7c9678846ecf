// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What no run needs of the room between drawn yarns, and who judges a cloth by it does.
#pragma once

#include "core/room/room_tables.h"

#include <optional>

namespace hygroloom {

/// Half of a full layer, from its middle to a face: its part in the flow of the whole.
struct RoomHalf {
    double open = 0;                       ///< share of it outside the yarns
    double along_warp = 0, along_weft = 0; ///< m2, permeabilities
};

struct RoomDetails {
    double through = 0;    ///< m2, permeability from face to face; Stokes flow over mobility is taken as along the cloth
    RoomHalf lower, upper; ///< towards the bottom, towards the top
    /// Least saturation at which liquid still runs on through the cloth, air coming in as balls do. It takes many voxels: at 16 in the mean
    /// pitch up to four times what it is at 48.
    double connected_along_warp = 1, connected_along_weft = 1;
};

/// Of a cloth with these tables, drawn in so many voxels. None where its types are drawn alone: see drawn_cell().
std::optional<RoomDetails> room_details(const Textile& textile, const RoomTables& tables, int voxels);

} // namespace hygroloom
