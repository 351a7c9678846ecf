// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The vertices of a cell's tubes, as a graphics card reads them.
#pragma once

#include "ui/picture/preview_fabric.h"

namespace hygroloom {

struct CellVertex {
    float position[3];        ///< mm, from the corner of the cell; z from the fabric's middle
    std::int16_t shape[4];    ///< normal, and share of light from the surroundings; 32767 is 1
    float along;              ///< in crossings from the cell's beginning; of a fibre: its direction across the yarn
    float around;             ///< once round is 1; of a fibre: its direction upwards
    std::uint8_t crossing[4]; ///< end and pick within the cell, 0 for an end and 1 for a pick, 1 for a fibre and 2 for a cut end
};

struct CellMesh {
    MeshKey key;
    std::vector<CellVertex> vertices;
    std::vector<std::uint32_t> indices;
};

} // namespace hygroloom
