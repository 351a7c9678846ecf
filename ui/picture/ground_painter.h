// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The cloth's soft shadow on a ground a little below it.
#pragma once

#include "ui/picture/drawing.h"

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVertexArrayObject>

namespace hygroloom {

constexpr float ground_dark = 0.5F; ///< share of the background's light that the shadow takes

/// All members need the same current context.
class GroundPainter {
public:
    /// The driver's complaint about the shader, or nothing.
    QString initialize(QOpenGLFunctions_3_3_Core* gl);
    void release();
    /// Before all else: what is drawn later covers it. Nothing where it is looked at from below.
    void draw(const SceneView& view, const PreviewFabric& fabric, const QColor& background);

private:
    QOpenGLFunctions_3_3_Core* gl_ = nullptr;
    QOpenGLShaderProgram program_;
    QOpenGLVertexArrayObject nothing_; ///< of a square that needs no vertices
};

} // namespace hygroloom
