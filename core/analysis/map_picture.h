// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The map of one side of a run at one time, with its captions, as a picture.
#pragma once

#include "core/analysis/map_image.h"
#include "core/analysis/page.h"
#include "core/run/run_record.h"

namespace hygroloom {

struct MapPicture {
    CellMap map;
    MapImageOptions image;
    double width = 0, height = 0; ///< m, of the sample
};
/// start: see start_of_maps(). units: of the captions and the scale bar.
MapPicture map_picture(const RunRecord& run, const Frame& frame, const Frame& start, MapSide side, int crossings_per_cell,
                       const ReaderUnits& units = {});

/// Of another quantity. Throws Error where the run does not model it.
MapPicture quantity_picture(const RunRecord& run, const Frame& frame, ShownQuantity quantity, MapSide side, int crossings_per_cell);

/// As PNG. Throws FileError.
void write_picture(const MapPicture& picture, const std::filesystem::path& path);

/// Gives the pictures one colour scale, on which they can be compared.
void share_scale(const std::vector<MapPicture*>& pictures);

/// With their captions on one colour scale, for a report.
std::vector<ReportPicture> pictures_on_one_scale(std::vector<std::pair<std::string, MapPicture>> maps);

/// Of both faces.
std::vector<ReportPicture> pictures_of_faces(const RunRecord& run, const Frame& frame, const Frame& start, int crossings_per_cell,
                                             const ReaderUnits& units = {});

} // namespace hygroloom
