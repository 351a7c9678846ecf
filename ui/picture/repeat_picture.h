// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The flat picture of a repeat that stands for its tubes from afar, and how bright the cloth is on the whole from each direction.
#pragma once

#include "ui/picture/preview_fabric.h"

#include <array>

namespace hygroloom {

/// What is seen of a cloth from one direction, means over a repeat: what its own colours are multiplied by, and the share that is not gap.
struct MeanLook {
    float warp = 0, weft = 0, covered = 0, unused = 0;
};
/// The shine that its fibres have, and that a film of water on it would have.
struct MeanShine {
    float fibres = 0, film = 0, unused[2] = {};
};

/// Round a yarn at its first crossing, m.
double perimeter_of(const Textile& textile, YarnKind kind);

/// One period seen square on.
/// Layers of 4 bytes a texel: ends from the top, picks from the top, ends from below, picks from below, how much is covered.
/// The first four hold openness times normal (128 is 0) and openness itself; nothing where the other yarns are in front.
struct RepeatPicture {
    static constexpr int layers = 5;
    static constexpr int looks_each_way = 7;
    static constexpr std::size_t directions = std::size_t{2} * looks_each_way * looks_each_way;
    int ends = 0;
    int picks = 0;
    int width = 0; ///< a power of 2, as height: then texels of coarser pictures are means of finer ones
    int height = 0;
    std::vector<std::uint8_t> texels;
    std::array<float, 2> wound{}; ///< tangents of the angles that fibres have on the first end and the first pick
    float level = 0;              ///< mm, mean height of what is seen, above the fabric's middle
    float covered = 1;            ///< share of the area
    /// From directions whose x and y go from -1 to 1 in even steps, row by row; first from the top, then from below.
    struct {
        std::array<MeanLook, directions> seen{};
        std::array<MeanShine, directions> shine{};
    } looks;
};
RepeatPicture picture_of_repeat(const PreviewFabric& fabric);

} // namespace hygroloom
