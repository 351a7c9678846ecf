// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A smooth surface round the particles of free liquid, so that a drop looks like one.
#pragma once

#include "core/scene/frame.h"

#include <QVector3D>

#include <cstdint>
#include <vector>

namespace hygroloom {

/// Triangles in millimetres; normals point out of the liquid.
struct LiquidSurface {
    struct Vertex {
        QVector3D position;
        QVector3D normal;
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<QVector3D> centres; ///< of the particles within
    float particle_radius = 0;      ///< of a ball as large as a particle
};

/// Empty for a frame without free liquid. The surface lies most of a particle's spacing outside the outermost centres:
/// a picture, not a measure of volume.
LiquidSurface liquid_surface(const Frame& frame);

} // namespace hygroloom
