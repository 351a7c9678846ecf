// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The tubes of a cell, as a graphics card gets them.
#pragma once

#include "ui/picture/cell_vertices.h"

namespace hygroloom {

/// Of any cell that has the key.
CellMesh mesh_cell(const PreviewFabric& fabric, Cell cell, int level);

} // namespace hygroloom
