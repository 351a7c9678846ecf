// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The fibres on the skins of yarns, for a look from very near. They wind as the yarn is twisted, and wander a little.
#pragma once

#include "ui/cell_mesh.h"
#include "ui/yarn_field.h"

namespace hygroloom {

/// The yarn's body under its fibres.
constexpr TubeLevel fibre_core{6, 16, 0};
/// m; how far under the skin that body lies.
double fibre_depth(const PreviewFabric& fabric);
std::size_t fibre_triangles(int crossings);
/// Of the yarns in a part of the fabric; the same fibres go on in the next part.
void add_fibres(const PreviewFabric& fabric, const TextileRegion& part, const YarnField& field, CellMesh& mesh);

} // namespace hygroloom
