// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A flat polygon as triangles of its corners.
#pragma once

#include "core/garment/pattern.h"

namespace hygroloom {

/// Cuts ears off a simple polygon, convex or not, whichever way round it goes; the triangles go round as it does. work: comparisons that
/// are left. False where the polygon crosses itself, has no area, or would take more work; the triangles are then too few.
bool cut_ears(const std::vector<FlatPlace>& outline, std::vector<std::array<int, 3>>& triangles, std::size_t& work);

} // namespace hygroloom
