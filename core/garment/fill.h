// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Flat panels as triangles: their outline's places and a grid of others, joined by Delaunay's rule.
#pragma once

#include "core/garment/pattern.h"

#include <functional>

namespace hygroloom {

struct FilledPanel {
    std::vector<FlatPlace> flat;
    std::vector<std::array<int, 3>> triangles; ///< counter-clockwise
    bool whole = true;                         ///< false: the outline crosses itself, or is too large to be filled
};

/// spacing: m between places. work: comparisons that are left; a panel that would take more is not filled.
FilledPanel filled(const PatternPanel& panel, double spacing, std::size_t& work);

/// 10 mm, or more where all panels would have too many places.
double fill_spacing(const GarmentPattern& pattern);

/// Fills all panels and puts each place into space. Adds issues where a panel cannot be filled.
void make_shape(GarmentPattern& pattern, const std::function<Vec3d(int panel, const FlatPlace&)>& to_space);

/// Where each panel was placed.
void make_flat_shape(GarmentPattern& pattern);

} // namespace hygroloom
