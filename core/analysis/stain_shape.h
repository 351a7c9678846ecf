// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The shape of a stain: how long it is, and how far it is from an ellipse.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace hygroloom {

struct StainShape {
    double aspect;   ///< longer over shorter semi-axis of the ellipse of equal moments along warp and weft, 1 or more
    double armness;  ///< four-fold part of the outline over its mean radius, less that of the ellipse: more than 0 for arms along the yarns
    double solidity; ///< area over that of the convex hull, 0..1
};

/// Of wet places on a grid, m, each of which stands for a cell of so many m along both axes. The outline is true in area within each of 72
/// sectors round the middle. None for fewer than 12 places, whose corners would be all that it has.
std::optional<StainShape> stain_shape(const std::vector<std::array<double, 2>>& places, double cell_x, double cell_y);

} // namespace hygroloom
