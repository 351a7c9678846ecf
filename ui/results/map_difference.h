// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One map less another, cell by cell at the same place.
#pragma once

#include "core/analysis/cell_map.h"

#include <QString>

#include <optional>

namespace hygroloom {

/// What of a cell's water is numerical error at most, and whose error that is.
struct MapError {
    std::optional<double> share; ///< of the cell's water; none: not known
    QString of;                  ///< "wetted radius, top"
};

struct MapDifference {
    CellMap cells;          ///< of kg/m2; more than nothing: the map has more water than the baseline
    std::vector<bool> real; ///< whether a cell's difference is larger than the error of the wetter one
};

/// The error of the runs' numbers that is nearest to a map's: of the stain on that face, else the largest of all; the larger of both runs.
MapError errorOfMaps(const RunRecord& run, const RunRecord& baseline, MapSide side);

/// Why there is none, in a sentence without a full stop; empty where there is: the cells are the same on both.
QString whyNoDifference(const CellMap& map, const CellMap& baseline);
/// Precondition: there is one. Without a known error every difference counts.
MapDifference differenceOf(const CellMap& map, const CellMap& baseline, const MapError& error);
/// The largest of the cells that are real, whatever its sign.
double largestOf(const MapDifference& difference);

} // namespace hygroloom
