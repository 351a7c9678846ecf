// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Panels laid out in cells of their fabrics, turned by their grain.
#pragma once

#include "core/garment/pattern.h"

#include <cstdint>
#include <functional>

namespace hygroloom {

/// How a panel lies in the cloth of cells. Cell (end, pick) of it has its middle at origin + end x across + pick x along.
struct PanelGrid {
    int ends = 0, picks = 0;
    int first_pick = 0;              ///< of it in the cloth of all panels
    FlatPlace origin{};              ///< m, flat
    FlatPlace across{}, along{};     ///< m, from end to end, and from pick to pick
    std::vector<std::uint8_t> there; ///< whether its middle lies in the panel; end x picks + pick

    FlatPlace middle(int end, int pick) const
    {
        return {origin[0] + end * across[0] + pick * along[0], origin[1] + end * across[1] + pick * along[1]};
    }
    std::size_t cell(int end, int pick) const
    {
        return static_cast<std::size_t>(end) * static_cast<std::size_t>(picks) + static_cast<std::size_t>(pick);
    }
    bool has(int end, int pick) const { return end >= 0 && pick >= 0 && end < ends && pick < picks && there[cell(end, pick)] != 0; }
    /// End and pick of the cell that a flat place lies in, whether it is there or not.
    std::array<int, 2> cell_at(const FlatPlace& place) const;
};

/// Cells of the given size (m, across the ends and across the picks), the warp turned from the pattern's +y by the grain (radian,
/// counter-clockwise).
PanelGrid panel_grid(const PatternPanel& panel, double grain, double end_pitch, double pick_pitch);

/// The same cells with ends and picks exchanged.
PanelGrid turned(const PanelGrid& grid);

/// A cell whose middle lies in a triangle of the garment's shape, and the shares of the triangle's corners there.
struct CellInTriangle {
    std::size_t triangle = 0;
    int end = 0, pick = 0;
    std::array<double, 3> shares{};
};
using VisitCell = std::function<void(const CellInTriangle&)>;
/// Of one panel. A cell on a side that triangles share is told more than once.
void for_cells_in_triangles(const PanelGrid& grid, const GarmentShape& shape, int panel, const VisitCell& visit);

/// Where in space the middle of each cell lies, m; end x picks + pick. Cells beyond the mesh's edge lie with their neighbours.
std::vector<Vec3d> places_of(const PanelGrid& grid, const GarmentShape& shape, int panel);

} // namespace hygroloom
