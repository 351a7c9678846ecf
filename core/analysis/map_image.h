// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A map as a picture for people without the window: water and humidity in blue, temperature in red; scale bar, colour bar, wetted circle.
#pragma once

#include "core/analysis/cell_map.h"
#include "core/analysis/image.h"
#include "core/analysis/reader_units.h"

#include <optional>

namespace hygroloom {

struct MapImageOptions {
    std::vector<std::string> captions; ///< lines over the map
    std::optional<Circle> circle;      ///< from the sample's middle, m
    double most = 0;                   ///< kg/m2 at the colour bar's end; 0: the map's own maximum
    ValueRange range;                  ///< of the colour bar, of another quantity than water
    ReaderUnits units{};               ///< of the scale bar and of temperatures
};

/// width and height: of the sample, m (cells at the far edges may reach over it). Cells with less than 1 % of the water at the bar's end
/// count as dry. Throws Error when there is no memory for it.
Image draw_map(const CellMap& map, double width, double height, const MapImageOptions& options);

/// Throws Error when there is no memory for it.
std::string png_bytes(const Image& image);

/// Throws FileError, and Error as png_bytes().
void write_png(const Image& image, const std::filesystem::path& path);

} // namespace hygroloom
