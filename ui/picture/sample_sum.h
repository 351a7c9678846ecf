// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The mean of pictures drawn a share of a pixel beside each other, which has smooth edges: made while nothing moves.
#pragma once

#include "ui/picture/drawing.h"

#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLVertexArrayObject>

#include <memory>

namespace hygroloom {

/// All members need the same current context.
class SampleSum {
public:
    /// The driver's complaint about the shader, or nothing.
    QString initialize();
    void release();
    /// Forgets what was added.
    void begin(const QSize& pixels);
    bool begun() const { return sum_ != nullptr; }
    /// What the next picture is drawn into.
    QOpenGLFramebufferObject& sample() { return *sample_; }
    /// Takes in what was drawn there.
    void add();
    int count() const { return count_; }
    /// The mean of all that were added, in linear light.
    QOpenGLFramebufferObject& mean() { return *sum_; }
    /// Where the next is drawn, in pixels beside its place: evenly spread over one pixel.
    QPointF nextShift() const;

private:
    QOpenGLFunctions_3_3_Core* gl_ = nullptr;
    QOpenGLShaderProgram program_;
    QOpenGLVertexArrayObject nothing_; ///< of a triangle that needs no vertices
    std::unique_ptr<QOpenGLFramebufferObject> sample_;
    std::unique_ptr<QOpenGLFramebufferObject> sum_;
    int count_ = 0;
};

} // namespace hygroloom
