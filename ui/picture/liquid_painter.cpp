// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/liquid_painter.h"

#include <cstddef>

namespace hygroloom {

QString LiquidPainter::initialize(QOpenGLFunctions_3_3_Core* gl, QOpenGLBuffer& square)
{
    gl_ = gl;
    for (const auto& [program, name] : {std::pair(&surface_, "drop"), std::pair(&particles_, "ball")}) {
        if (const QString problem = loadShaders(*program, name); !problem.isEmpty()) { return problem; }
    }
    surface_array_.create();
    vertices_.create();
    indices_.create();
    surface_array_.bind();
    vertices_.bind();
    indices_.bind();
    constexpr int stride = sizeof(LiquidSurface::Vertex);
    gl_->glEnableVertexAttribArray(0);
    gl_->glEnableVertexAttribArray(1);
    gl_->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
    gl_->glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, vertexOffset(offsetof(LiquidSurface::Vertex, normal)));
    surface_array_.release();

    particle_array_.create();
    centres_.create();
    particle_array_.bind();
    gl_->glEnableVertexAttribArray(0);
    gl_->glEnableVertexAttribArray(1);
    square.bind();
    gl_->glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    centres_.bind();
    gl_->glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(QVector3D), nullptr);
    gl_->glVertexAttribDivisor(1, 1);
    particle_array_.release();
    return {};
}

void LiquidPainter::release()
{
    surface_array_.destroy();
    particle_array_.destroy();
    for (QOpenGLBuffer* buffer : {&vertices_, &indices_, &centres_}) { buffer->destroy(); }
    below_.reset();
    surface_.removeAllShaders();
    particles_.removeAllShaders();
}

void LiquidPainter::setLiquid(const LiquidSurface& surface)
{
    index_count_ = static_cast<int>(surface.indices.size());
    if (index_count_ > 0) {
        surface_array_.bind();
        vertices_.bind();
        vertices_.allocate(surface.vertices.data(), static_cast<int>(surface.vertices.size() * sizeof(LiquidSurface::Vertex)));
        indices_.bind();
        indices_.allocate(surface.indices.data(), static_cast<int>(surface.indices.size() * sizeof(std::uint32_t)));
        surface_array_.release();
    }
    particle_count_ = static_cast<int>(surface.centres.size());
    radius_ = surface.particle_radius;
    if (particle_count_ > 0) {
        centres_.bind();
        centres_.allocate(surface.centres.data(), static_cast<int>(surface.centres.size() * sizeof(QVector3D)));
        centres_.release();
    }
}

void LiquidPainter::draw(const SceneView& view, const PictureColors& colors, const QSize& pixels, float face)
{
    if (particles_shown_ && particle_count_ > 0) {
        drawParticles(view, colors);
    } else if (!particles_shown_ && index_count_ > 0) {
        takeBelow(pixels);
        drawSurface(view, colors, face);
    }
}

void LiquidPainter::takeBelow(const QSize& pixels)
{
    int target = 0;
    gl_->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    if (!below_ || below_->size() != pixels) { below_ = lightCopy(pixels); }
    gl_->glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned>(target));
    gl_->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, below_->handle());
    gl_->glBlitFramebuffer(0, 0, pixels.width(), pixels.height(), 0, 0, pixels.width(), pixels.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_->glBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(target));
}

void LiquidPainter::prepare(QOpenGLShaderProgram& program, const SceneView& view, const PictureColors& colors)
{
    program.bind();
    program.setUniformValue("view_projection", view.clip());
    program.setUniformValue("eye", view.camera.eye());
    program.setUniformValue("tint", lightOf(waterColor(0.42, colors.water)));
    program.setUniformValue("cut", cutOf(view));
    gl_->glEnable(GL_CLIP_DISTANCE0);
}

void LiquidPainter::drawSurface(const SceneView& view, const PictureColors& colors, float face)
{
    prepare(surface_, view, colors);
    surface_.setUniformValue("tinted", colors.water == WaterColors::natural ? 0.08F : 0.6F);
    surface_.setUniformValue("face", view.camera.eye().z() >= 0 ? face : -face);
    surface_.setUniformValue("below", 0);
    gl_->glActiveTexture(GL_TEXTURE0);
    gl_->glBindTexture(GL_TEXTURE_2D, below_->texture());
    surface_array_.bind();
    if (!view.cut) { // the inside is seen where the drop is cut
        gl_->glEnable(GL_CULL_FACE);
    }
    // Depth first, so that only the nearest surface shows and the drop reads as one body.
    gl_->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_->glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_->glDepthMask(GL_FALSE);
    gl_->glEnable(GL_BLEND);
    gl_->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    gl_->glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    gl_->glDisable(GL_BLEND);
    gl_->glDepthMask(GL_TRUE);
    gl_->glDisable(GL_CULL_FACE);
    gl_->glDisable(GL_CLIP_DISTANCE0);
    surface_array_.release();
    surface_.release();
}

void LiquidPainter::drawParticles(const SceneView& view, const PictureColors& colors)
{
    prepare(particles_, view, colors);
    particles_.setUniformValue("radius", radius_);
    particle_array_.bind();
    gl_->glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE); // smooth edges without an order of drawing
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    gl_->glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, particle_count_);
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_->glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    gl_->glDisable(GL_CLIP_DISTANCE0);
    particle_array_.release();
    particles_.release();
}

} // namespace hygroloom
