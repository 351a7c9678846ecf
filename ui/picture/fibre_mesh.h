// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The fibres of yarns, for a look from very near: those of core/geometry/fibres.h, as a cell takes them.
#pragma once

#include "ui/picture/cell_vertices.h"
#include "ui/picture/yarn_field.h"

namespace hygroloom {

/// The dark body under a yarn's fibres.
constexpr TubeLevel fibre_core{6, 16, 0};
constexpr double fibre_core_share = 0.55; ///< of the yarn's half height that lies over that body

/// Of the yarns in a part of the fabric; the next part continues the same fibres.
void add_fibres(const PreviewFabric& fabric, const TextileRegion& part, const YarnField& field, CellMesh& mesh);

} // namespace hygroloom
