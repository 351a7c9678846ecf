// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Draws free liquid: the surface round its particles, or the particles themselves.
#pragma once

#include "ui/picture/drawing.h"
#include "ui/picture/liquid_surface.h"

#include <QOpenGLBuffer>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVertexArrayObject>

namespace hygroloom {

/// All members need the same current context.
class LiquidPainter {
public:
    /// square: the corners of the unit square. The driver's complaint about the shaders, or nothing.
    QString initialize(QOpenGLFunctions_3_3_Core* gl, QOpenGLBuffer& square);
    void release();

    void setLiquid(const LiquidSurface& surface);
    /// Whether the particles are drawn instead of the surface.
    void setParticlesShown(bool shown) { particles_shown_ = shown; }
    /// Over what is drawn already, which is seen refracted. face: mm, height of the cloth's upper face, where lines of sight end.
    void draw(const SceneView& view, const PictureColors& colors, const QSize& pixels, float face);

private:
    void takeBelow(const QSize& pixels);
    void prepare(QOpenGLShaderProgram& program, const SceneView& view, const PictureColors& colors);
    void drawSurface(const SceneView& view, const PictureColors& colors, float face);
    void drawParticles(const SceneView& view, const PictureColors& colors);

    QOpenGLFunctions_3_3_Core* gl_ = nullptr;
    QOpenGLShaderProgram surface_;
    QOpenGLShaderProgram particles_;
    QOpenGLVertexArrayObject surface_array_;
    QOpenGLBuffer vertices_{QOpenGLBuffer::VertexBuffer};
    QOpenGLBuffer indices_{QOpenGLBuffer::IndexBuffer};
    int index_count_ = 0;
    std::unique_ptr<QOpenGLFramebufferObject> below_; ///< the picture without liquid
    QOpenGLVertexArrayObject particle_array_;
    QOpenGLBuffer centres_{QOpenGLBuffer::VertexBuffer};
    int particle_count_ = 0;
    float radius_ = 0; ///< mm, of a particle
    bool particles_shown_ = false;
};

} // namespace hygroloom
