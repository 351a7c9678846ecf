// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/textile_renderer.h"

#include <QCoreApplication>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>

#include <cstddef>

namespace hygroloom {

namespace {

constexpr int water_row = 1024; // texels, as in yarn.vert

QVector3D rgb(const QColor& color)
{
    return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()), static_cast<float>(color.blueF())};
}

} // namespace

bool TextileRenderer::initialize()
{
    gl_ = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(QOpenGLContext::currentContext());
    if (!gl_ || !gl_->initializeOpenGLFunctions()) {
        problem_ = QCoreApplication::translate("hygroloom", "The picture needs OpenGL 3.3, which this display does not offer.");
        return false;
    }
    if (!load(yarns_, "yarn") || !load(drops_, "drop")) {
        return false;
    }
    gl_->glGenTextures(1, &water_);
    gl_->glBindTexture(GL_TEXTURE_2D, water_);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    const float nothing = 0;
    gl_->glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 1, 1, 0, GL_RED, GL_FLOAT, &nothing);

    drop_array_.create();
    drop_vertices_.create();
    drop_indices_.create();
    drop_array_.bind();
    drop_vertices_.bind();
    drop_indices_.bind();
    constexpr int stride = sizeof(LiquidSurface::Vertex);
    gl_->glEnableVertexAttribArray(0);
    gl_->glEnableVertexAttribArray(1);
    gl_->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
    gl_->glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offsetof(LiquidSurface::Vertex, normal)));
    drop_array_.release();
    return true;
}

void TextileRenderer::release()
{
    for (Slot& slot : slots_) {
        slot.mesh.reset();
        slot.array.destroy();
        slot.vertices.destroy();
        slot.indices.destroy();
    }
    drop_array_.destroy();
    drop_vertices_.destroy();
    drop_indices_.destroy();
    ramp_.reset();
    if (gl_ && water_) {
        gl_->glDeleteTextures(1, &water_);
        water_ = 0;
    }
    yarns_.removeAllShaders();
    drops_.removeAllShaders();
}

bool TextileRenderer::load(QOpenGLShaderProgram& program, const QString& name)
{
    if (program.addShaderFromSourceFile(QOpenGLShader::Vertex, ":/shaders/" + name + ".vert")
        && program.addShaderFromSourceFile(QOpenGLShader::Fragment, ":/shaders/" + name + ".frag") && program.link()) {
        return true;
    }
    problem_ = QCoreApplication::translate("hygroloom", "The graphics driver refuses a shader: %1").arg(program.log());
    return false;
}

void TextileRenderer::setMesh(std::shared_ptr<const PreviewMesh> mesh)
{
    if (!mesh) {
        slots_[0].mesh.reset();
        slots_[1].mesh.reset();
        return;
    }
    Slot& slot = slots_[mesh->fine ? 1 : 0];
    if (!mesh->fine || !slots_[0].mesh || slots_[0].mesh->request.design != mesh->request.design) {
        slots_[mesh->fine ? 0 : 1].mesh.reset();
    }
    slot.mesh = std::move(mesh);
    upload(slot);
}

void TextileRenderer::upload(Slot& slot)
{
    if (!slot.array.isCreated()) {
        slot.array.create();
        slot.vertices.create();
        slot.indices.create();
    }
    slot.array.bind();
    slot.vertices.bind();
    slot.vertices.allocate(slot.mesh->vertices.data(), static_cast<int>(slot.mesh->vertices.size() * sizeof(PreviewVertex)));
    slot.indices.bind();
    slot.indices.allocate(slot.mesh->indices.data(), static_cast<int>(slot.mesh->indices.size() * sizeof(std::uint32_t)));
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    constexpr int stride = sizeof(PreviewVertex);
    for (unsigned attribute = 0; attribute < 4; ++attribute) {
        gl_->glEnableVertexAttribArray(attribute);
    }
    gl_->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, at(offsetof(PreviewVertex, position)));
    gl_->glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, at(offsetof(PreviewVertex, normal)));
    gl_->glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride, at(offsetof(PreviewVertex, along)));
    gl_->glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, stride, at(offsetof(PreviewVertex, segment)));
    slot.array.release();
}

void TextileRenderer::setWater(const std::vector<float>& values, double maximum)
{
    water_maximum_ = values.empty() ? 0 : maximum;
    if (values.empty()) {
        return;
    }
    const int rows = static_cast<int>((values.size() + water_row - 1) / water_row);
    std::vector<float> padded = values;
    padded.resize(static_cast<std::size_t>(rows) * water_row);
    gl_->glBindTexture(GL_TEXTURE_2D, water_);
    gl_->glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, water_row, rows, 0, GL_RED, GL_FLOAT, padded.data());
    gl_->glBindTexture(GL_TEXTURE_2D, 0);
}

void TextileRenderer::setLiquid(const LiquidSurface& surface)
{
    drop_index_count_ = static_cast<int>(surface.indices.size());
    if (drop_index_count_ > 0) {
        drop_array_.bind();
        drop_vertices_.bind();
        drop_vertices_.allocate(surface.vertices.data(), static_cast<int>(surface.vertices.size() * sizeof(LiquidSurface::Vertex)));
        drop_indices_.bind();
        drop_indices_.allocate(surface.indices.data(), static_cast<int>(surface.indices.size() * sizeof(std::uint32_t)));
        drop_array_.release();
    }
}

void TextileRenderer::draw(const Camera& camera, const QSize& pixels, const QSizeF& size, const PictureColors& colors, bool moving)
{
    gl_->glViewport(0, 0, pixels.width(), pixels.height());
    const QVector3D clear = rgb(colors.background);
    gl_->glClearColor(clear.x(), clear.y(), clear.z(), 1);
    gl_->glDepthMask(GL_TRUE);
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_->glEnable(GL_DEPTH_TEST);
    gl_->glDepthFunc(GL_LEQUAL);
    gl_->glDisable(GL_BLEND);
    Slot& slot = slots_[1].mesh && !(moving && slots_[0].mesh) ? slots_[1] : slots_[0];
    if (slot.mesh) {
        drawYarns(slot, camera, size, colors);
    }
    if (drop_index_count_ > 0) {
        drawLiquid(camera, size, colors);
    }
    gl_->glDisable(GL_DEPTH_TEST);
}

void TextileRenderer::drawYarns(Slot& slot, const Camera& camera, const QSizeF& size, const PictureColors& colors)
{
    if (!ramp_ || ramp_colors_ != colors.water) {
        ramp_ = std::make_unique<QOpenGLTexture>(waterRamp(colors.water), QOpenGLTexture::DontGenerateMipMaps);
        ramp_->setMinMagFilters(QOpenGLTexture::Linear, QOpenGLTexture::Linear);
        ramp_->setWrapMode(QOpenGLTexture::ClampToEdge);
        ramp_colors_ = colors.water;
    }
    const PreviewMesh& mesh = *slot.mesh;
    const Fabric& fabric = mesh.request.design->fabrics[static_cast<std::size_t>(mesh.request.fabric)];
    const auto turns = [](const Yarn& yarn, double pitch) {
        return static_cast<float>(yarn.twist_per_m * pitch * (yarn.twist_direction == TwistDirection::z ? 1 : -1));
    };
    yarns_.bind();
    yarns_.setUniformValue("view_projection", camera.projection(size) * camera.view());
    yarns_.setUniformValue("eye", camera.eye());
    yarns_.setUniformValue("crossings", mesh.textile.crossings());
    yarns_.setUniformValue("water", 0);
    yarns_.setUniformValue("ramp", 1);
    yarns_.setUniformValue("water_scale", water_maximum_ > 0 ? static_cast<float>(1 / water_maximum_) : 0.0F);
    yarns_.setUniformValue("bare", 0.02F);
    yarns_.setUniformValue("warp_color", rgb(colors.warp));
    yarns_.setUniformValue("weft_color", rgb(colors.weft));
    yarns_.setUniformValue("twist", QVector2D(turns(fabric.warp, mesh.textile.weft.pitch), turns(fabric.weft, mesh.textile.warp.pitch)));
    yarns_.setUniformValue("half_thickness", static_cast<float>(1000 * mesh.textile.half_thickness()));
    gl_->glActiveTexture(GL_TEXTURE1);
    ramp_->bind();
    gl_->glActiveTexture(GL_TEXTURE0);
    gl_->glBindTexture(GL_TEXTURE_2D, water_);
    slot.array.bind();
    gl_->glEnable(GL_CULL_FACE);
    gl_->glDrawElements(GL_TRIANGLES, static_cast<int>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
    gl_->glDisable(GL_CULL_FACE);
    slot.array.release();
    yarns_.release();
}

void TextileRenderer::drawLiquid(const Camera& camera, const QSizeF& size, const PictureColors& colors)
{
    drops_.bind();
    drops_.setUniformValue("view_projection", camera.projection(size) * camera.view());
    drops_.setUniformValue("eye", camera.eye());
    drops_.setUniformValue("tint", rgb(waterColor(0.42, colors.water)));
    drop_array_.bind();
    gl_->glEnable(GL_CULL_FACE);
    // Depth first, so that only the nearest skin shows and the drop reads as one body.
    gl_->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_->glDrawElements(GL_TRIANGLES, drop_index_count_, GL_UNSIGNED_INT, nullptr);
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_->glDepthMask(GL_FALSE);
    gl_->glEnable(GL_BLEND);
    gl_->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    gl_->glDrawElements(GL_TRIANGLES, drop_index_count_, GL_UNSIGNED_INT, nullptr);
    gl_->glDisable(GL_BLEND);
    gl_->glDepthMask(GL_TRUE);
    gl_->glDisable(GL_CULL_FACE);
    drop_array_.release();
    drops_.release();
}

} // namespace hygroloom
