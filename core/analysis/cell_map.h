// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Water on a grid of n x n crossings, as a garment designer looks at it.
#pragma once

#include "core/analysis/metrics.h"
#include "core/scene/shown_quantity.h"

#include <filesystem>

namespace hygroloom {

enum class MapSide { top, bottom, total };

/// Throws Error naming the words.
MapSide map_side_from_name(const std::string& name);

struct CellMap {
    ShownQuantity quantity = ShownQuantity::water;
    int columns = 0;            ///< along the weft
    int rows = 0;               ///< along the warp, first row at the bottom (smallest y)
    int crossings_per_cell = 2; ///< n
    double cell_width = 0;      ///< m
    double cell_height = 0;     ///< m
    std::vector<double> water;  ///< kg/m2 over the start, row by row; of another quantity what segment_values() gives
    double at(int column, int row) const { return water[static_cast<std::size_t>(row) * columns + column]; }
    double maximum() const;
};

/// What a map counts water from: a run's first frame, without the test's own water, liquid and bound, where the sample is wet from the
/// start.
Frame start_of_maps(const RunRecord& run, Frame first);

/// Cells at the far edges may hold fewer crossings; their water is per their own area.
CellMap cell_map(const Textile& textile, const Frame& frame, const Frame& start, MapSide side, int crossings_per_cell);

/// The mean of the yarns of a cell, by their length, on that side. Of water, cell_map().
CellMap quantity_map(const Textile& textile, const Frame& frame, ShownQuantity quantity, MapSide side, int crossings_per_cell);

/// UTF-8, comma, dot decimals; first lines "# key=value", then a header with units.
void write_cell_map_csv(const CellMap& map, const RunRecord& run, double time, MapSide side, const std::filesystem::path& path);

} // namespace hygroloom
