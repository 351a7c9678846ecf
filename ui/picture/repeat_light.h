// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The light of a repeat, for cloth so far away that its yarns are not drawn one by one: a texture that may be averaged over any
// number of repeats, made anew for each direction of view.
#pragma once

#include "ui/picture/drawing.h"
#include "ui/picture/repeat_picture.h"

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVertexArrayObject>
#include <QVector2D>

namespace hygroloom {

/// All members need the same current context.
class RepeatLight {
public:
    /// The driver's complaint about the shader, or nothing.
    QString initialize(QOpenGLFunctions_3_3_Core* gl);
    void release();
    void setPicture(const RepeatPicture& picture);
    /// Leaves framebuffer and viewport as they were.
    void lightFrom(const QVector3D& to_eye);
    /// The light, and how bright the whole is from each direction, for two units of textures.
    void bind(unsigned light_unit, unsigned looks_unit);

private:
    QOpenGLFunctions_3_3_Core* gl_ = nullptr;
    QOpenGLShaderProgram program_;
    QOpenGLVertexArrayObject nothing_; ///< of a triangle that needs no vertices
    unsigned normals_ = 0;
    unsigned looks_ = 0;
    unsigned light_ = 0;
    unsigned target_ = 0; ///< framebuffer that draws into the light
    QVector2D wound_;
    QSize size_;
    QVector3D lit_from_;
};

} // namespace hygroloom
