// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What read_pattern() chooses between, and what the readers share. Names stand for files in messages; all throw FileError.
#pragma once

#include "core/garment/pattern.h"

#include <string_view>

namespace hygroloom {

constexpr std::size_t largest_pattern_bytes = 64u << 20;
constexpr std::size_t largest_mesh_bytes = 512u << 20;
constexpr std::size_t most_panels = 500;
constexpr std::size_t most_corners = 10000; ///< of a panel

/// A sewing pattern in the JSON of GarmentCode, or of its forerunner. Without shape.
GarmentPattern pattern_from_json(std::string_view text, const std::string& name);

/// Gives a pattern the shape of its draped mesh (OBJ) by the text that names each vertex's panel.
void take_drape(GarmentPattern& pattern, std::string_view obj, std::string_view segmentation, const std::string& name);

/// A mesh with flat coordinates.
GarmentPattern pattern_from_mesh(const std::filesystem::path& path, UvUnit unit, const Asked& cancelled = {});
/// The same of the text of an OBJ file.
GarmentPattern pattern_from_obj(std::string_view text, const std::string& name, UvUnit unit);

GarmentPattern built_in_pattern(const BuiltInGarment& garment);

/// Finds the floor and the panels on arms, once the panels are placed and have a shape.
void find_body(GarmentPattern& pattern);

} // namespace hygroloom
