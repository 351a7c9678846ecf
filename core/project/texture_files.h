// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A fabric's repeat as pictures that tile without a seam, with materials in the terms of glTF, for programs that render or drape.
#pragma once

#include "core/geometry/textile.h"
#include "core/project/export_options.h"

#include <filesystem>

namespace hygroloom {

constexpr int largest_texture = 8192; ///< pixels, a side

struct TextureRequest {
    double dpi = 600;
    int across = 1, along = 1; ///< repeats, along the weft and along the warp
    double wet_share = 1;      ///< of the wet pictures: share of the surface that a film of water covers
};

struct TextureSize {
    int columns = 0, rows = 0;          ///< pixels
    double width_mm = 0, height_mm = 0; ///< what they show: whole repeats, so pixels are not quite square
};
/// Throws Error with a sentence where the pictures would be too large.
TextureSize texture_size(const Textile& textile, double dpi);

/// A picture's values, rows from the top.
struct TexturePixels {
    int columns = 0, rows = 0;
    double open_share = 0;                 ///< of the area
    std::vector<std::uint8_t> colour, wet; ///< red, green, blue, opacity
    std::vector<std::uint8_t> normal;      ///< x, y, z, of -1 .. 1 in 0 .. 255; y upwards in the picture
    std::vector<std::uint8_t> opacity;     ///< one a pixel
    std::vector<std::uint8_t> roughness, wet_roughness;
};
/// textile: of whole repeats of the fabric, seen from its top face. Throws Cancelled.
TexturePixels texture_pixels(const Textile& textile, const Fabric& fabric, const TextureSize& size, double wet_share,
                             const ExportProgress& progress = {});

/// Writes colour.png, normal.png, roughness.png, opacity.png, colour_wet.png, roughness_wet.png, material.json, material.mtl, plane.gltf
/// with plane.bin, and README.txt to a folder that is there. Returns their names. Throws Error, FileError, Cancelled.
std::vector<std::string> write_textures(const Textile& textile, const Fabric& fabric, const TextureRequest& request,
                                        const std::filesystem::path& folder, const ExportProgress& progress = {});

} // namespace hygroloom
