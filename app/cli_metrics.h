// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Metrics on stdout and maps as pictures.
#pragma once

#include "core/analysis/intervals.h"
#include "core/analysis/map_image.h"

namespace hygroloom {

/// As JSON, or as a table for people. intervals: of replicates, by key; without them those of the run alone.
void print_metrics(const RunRecord& run, const Metrics& metrics, bool json, const std::map<std::string, Interval>& intervals = {});

/// The water map of one side at one time, with the captions of its picture.
struct MapPicture {
    CellMap map;
    MapImageOptions image;
    double width = 0, height = 0; ///< m, of the sample
};
/// start: see start_of_maps().
MapPicture map_picture(const RunRecord& run, const Frame& frame, const Frame& start, MapSide side, int crossings_per_cell);
/// As PNG. Throws FileError.
void write_picture(const MapPicture& picture, const std::filesystem::path& path);

} // namespace hygroloom
