// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The surface of free liquid: smooth round particles, so that a drop looks like one; of bodies as they are shaped.
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

/// Empty without free liquid. Round particles the surface lies most of their spacing outside the outermost centres: a picture, not a
/// measure of volume. Bodies are parts of balls: see liquid_bodies().
LiquidSurface liquid_surface(const Frame& frame, const std::vector<FrameCap>& bodies);

} // namespace hygroloom
