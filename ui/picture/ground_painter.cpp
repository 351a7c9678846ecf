// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/ground_painter.h"

#include <QVector2D>
#include <QVector4D>

#include <algorithm>

namespace hygroloom {

QString GroundPainter::initialize(QOpenGLFunctions_3_3_Core* gl)
{
    gl_ = gl;
    nothing_.create();
    return loadShaders(program_, "ground");
}

void GroundPainter::release()
{
    nothing_.destroy();
    program_.removeAllShaders();
}

void GroundPainter::draw(const SceneView& view, const PreviewFabric& fabric, const QColor& background)
{
    const QVector3D low = fabric.low(), high = fabric.high();
    const float side = std::min(high.x() - low.x(), high.y() - low.y());
    const float below = 0.02F * side;
    if (view.camera.eye().z() < low.z() - below) { return; }
    program_.bind();
    program_.setUniformValue("view_projection", view.clip());
    program_.setUniformValue("cloth", QVector4D(low.x(), low.y(), high.x(), high.y()));
    program_.setUniformValue("height", low.z() - below);
    program_.setUniformValue("aside", below * QVector2D(0.5F, -0.4F)); // away from the lamp of light.glsl
    program_.setUniformValue("soft", 0.045F * side);
    program_.setUniformValue("dark", ground_dark);
    program_.setUniformValue("background", lightOf(background));
    gl_->glDepthMask(GL_FALSE);
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE); // alpha is of the belt alone
    nothing_.bind();
    gl_->glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    nothing_.release();
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_->glDepthMask(GL_TRUE);
    program_.release();
}

} // namespace hygroloom
