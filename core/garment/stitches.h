// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which edges of a pattern are sewn together.
#pragma once

#include "core/garment/pattern.h"
#include "core/project/migrations.h"

namespace hygroloom {

/// Two edges as a seam. They run against each other, as edges of panels that face the same way do, unless their placed ends lie clearly
/// nearer to each other the other way round, or nothing is placed and the pattern says so (turned).
PatternSeam seam_of(const GarmentPattern& pattern, std::array<int, 2> a, std::array<int, 2> b, bool turned);

/// Reads [{panel, edge}, {panel, edge}], more such pairs, lists of edges on either side and the word "right_wrong". edge_numbers: of each
/// panel, where the file's edges are among the panel's. What cannot be understood becomes an issue.
void read_stitches(const ProjectJson& list, const std::string& file, const std::vector<std::vector<int>>& edge_numbers,
                   GarmentPattern& pattern);

} // namespace hygroloom
