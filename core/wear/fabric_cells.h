// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A fabric as a garment is cut from it: cells of k x k crossings, which repeat.
#pragma once

#include "core/plan/model_plan.h"
#include "core/scene/scene.h"

namespace hygroloom {

struct WearExperiment;

/// One repeat of a fabric's cells. Cell (end, pick) of a cloth is cell (end % ends, pick % picks) of it.
struct FabricCells {
    Scene tile; ///< of more than one repeat: neighbours are there
    int ends = 0, picks = 0;
    int crossings_per_cell = 1;
    double end_pitch = 0, pick_pitch = 0; ///< m, of cells, across the ends and across the picks
    bool turned = false;                  ///< ends are the fabric's picks, and picks its ends

    double cell_area() const { return end_pitch * pick_pitch; }
    std::size_t crossing(int end, int pick) const
    {
        return static_cast<std::size_t>(end % ends) * static_cast<std::size_t>(tile.cloth.picks) + static_cast<std::size_t>(pick % picks);
    }
    std::size_t warp(int end, int pick) const { return crossing(end, pick); }
    std::size_t weft(int end, int pick) const
    {
        return static_cast<std::size_t>(tile.cloth.crossings()) +
               static_cast<std::size_t>(pick % picks) * static_cast<std::size_t>(tile.cloth.ends) + static_cast<std::size_t>(end % ends);
    }
};

/// Cells whose sides are near a length (m), at least one crossing each. Yarns are even: unevenness acts in samples only.
/// Precondition: validate() found no error.
FabricCells fabric_cells(const Design& design, const Fabric& fabric, const WearExperiment& wear, const Knobs& knobs, double side);

/// The same cells with ends and picks exchanged.
FabricCells turned(const FabricCells& cells);

} // namespace hygroloom
