// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a graphics card gets: the tubes of a cell, and the flat picture of a repeat that stands for them from afar.
#pragma once

#include "ui/picture/cell_vertices.h"

namespace hygroloom {

/// Of any cell that has the key.
CellMesh mesh_cell(const PreviewFabric& fabric, Cell cell, int level);

/// One period seen square on. Each texel holds means that may be averaged further: light adds up.
/// Layers of 4 bytes a texel: ends from the top, picks from the top, ends from below, picks from below, how much is covered.
/// The first four hold openness times normal (128 is 0) and openness itself; nothing where the other yarns are in front.
struct RepeatPicture {
    static constexpr int layers = 5;
    int ends = 0;
    int picks = 0;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> texels;
    float level = 0;   ///< mm, mean height of what is seen, above the fabric's middle
    float covered = 1; ///< share of the area
};
RepeatPicture picture_of_repeat(const PreviewFabric& fabric);

} // namespace hygroloom
