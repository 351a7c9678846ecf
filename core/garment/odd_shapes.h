// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Shapes that no garment has, and cloth that counts twice: told, and left as they are.
#pragma once

#include "core/garment/pattern.h"

namespace hygroloom {

/// Adds to issues and doubts: a size that no garment has; of a draped pattern panels whose flat area is not that in space, and panels that
/// lie on each other all over, as the two faces of cloth that was exported thick.
void tell_odd_shapes(GarmentPattern& pattern);

/// Adds an issue where flat coordinates of panels lie on each other. outlines: of each panel as the file has it. Compares a bounded number
/// of places.
void tell_overlaps(GarmentPattern& pattern, const std::vector<std::vector<FlatPlace>>& outlines);

/// The last of these. in_space: m2 of each panel.
void tell_thick_cloth(GarmentPattern& pattern, const std::vector<double>& in_space);
/// A sentence that check tells, too.
void doubt(GarmentPattern& pattern, std::string sentence);
/// m2 in space.
double area_of_triangle(const GarmentShape& shape, std::size_t triangle);

} // namespace hygroloom
