// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/textile_renderer.h"

#include "core/base/units.h"
#include "core/project/wet_look.h"

#include <QCoreApplication>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hygroloom {

namespace {

constexpr std::size_t most_mesh_bytes = 384u << 20;
constexpr long kept_pictures = 8; // a mesh not shown for so long may go
enum Unit { water_unit, ramp_unit, end_unit, pick_unit, light_unit, looks_unit };

} // namespace

bool TextileRenderer::initialize()
{
    gl_ = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(QOpenGLContext::currentContext());
    if (!gl_ || !gl_->initializeOpenGLFunctions()) {
        problem_ = QCoreApplication::translate("hygroloom", "The picture needs OpenGL 3.3, which this display does not provide.");
        return false;
    }
    for (const int fading : {0, 1}) {
        if (!load(yarns_[fading], "yarn", fading) || !load(flats_[fading], "flat", fading)) { return false; }
    }
    if (!load(blend_, "blend", false)) { return false; }
    makeTextures();
    makeSquare();
    problem_ = repeat_light_.initialize(gl_);
    if (problem_.isEmpty()) { problem_ = ground_.initialize(gl_); }
    if (problem_.isEmpty()) { problem_ = encoder_.initialize(); }
    if (problem_.isEmpty()) { problem_ = liquid_.initialize(gl_, flat_vertices_); }
    return problem_.isEmpty();
}

bool TextileRenderer::load(QOpenGLShaderProgram& program, const QString& name, bool fading)
{
    problem_ = loadShaders(program, name, fading);
    return problem_.isEmpty();
}

void TextileRenderer::makeTextures()
{
    unsigned textures[3];
    gl_->glGenTextures(3, textures);
    water_ = textures[0];
    end_colors_ = textures[1];
    pick_colors_ = textures[2];
    for (const unsigned texture : {water_, end_colors_, pick_colors_}) {
        gl_->glBindTexture(GL_TEXTURE_2D, texture);
        gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        const float nothing[] = {0, 0};
        gl_->glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, 1, 1, 0, GL_RG, GL_FLOAT, nothing);
    }
}

/// The unit square that flat cells and particles are drawn on.
void TextileRenderer::makeSquare()
{
    instances_.create();
    flat_array_.create();
    flat_vertices_.create();
    flat_array_.bind();
    flat_vertices_.bind();
    const float corners[] = {0, 0, 1, 0, 0, 1, 1, 1};
    flat_vertices_.allocate(corners, sizeof corners);
    gl_->glEnableVertexAttribArray(0);
    gl_->glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    flat_array_.release();
}

void TextileRenderer::release()
{
    meshes_.clear();
    mesh_bytes_ = 0;
    fabric_.reset();
    liquid_.release();
    repeat_light_.release();
    ground_.release();
    encoder_.release();
    flat_array_.destroy();
    for (QOpenGLBuffer* buffer : {&flat_vertices_, &instances_}) { buffer->destroy(); }
    ramp_.reset();
    for (auto& picture : belt_pictures_) { picture.reset(); }
    if (gl_ && water_) {
        const unsigned textures[] = {water_, end_colors_, pick_colors_};
        gl_->glDeleteTextures(3, textures);
        water_ = 0;
    }
    for (QOpenGLShaderProgram* program : {&yarns_[0], &yarns_[1], &flats_[0], &flats_[1], &blend_}) { program->removeAllShaders(); }
}

void TextileRenderer::setFabric(std::shared_ptr<const PreviewFabric> fabric)
{
    fabric_ = std::move(fabric);
    meshes_.clear();
    mesh_bytes_ = 0;
    picture_ = {};
    shown_warp_ = QColor();
}

void TextileRenderer::addMesh(const CellMesh& mesh)
{
    auto& slot = meshes_[mesh.key];
    if (slot) { return; }
    slot = std::make_unique<TubeMesh>();
    slot->array.create();
    slot->vertices.create();
    slot->indices.create();
    slot->array.bind();
    slot->vertices.bind();
    slot->vertices.allocate(mesh.vertices.data(), static_cast<int>(mesh.vertices.size() * sizeof(CellVertex)));
    slot->indices.bind();
    slot->indices.allocate(mesh.indices.data(), static_cast<int>(mesh.indices.size() * sizeof(std::uint32_t)));
    constexpr int stride = sizeof(CellVertex);
    for (unsigned attribute = 0; attribute < 4; ++attribute) { gl_->glEnableVertexAttribArray(attribute); }
    gl_->glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, vertexOffset(offsetof(CellVertex, position)));
    gl_->glVertexAttribPointer(1, 4, GL_SHORT, GL_TRUE, stride, vertexOffset(offsetof(CellVertex, shape)));
    gl_->glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride, vertexOffset(offsetof(CellVertex, along)));
    gl_->glVertexAttribIPointer(3, 4, GL_UNSIGNED_BYTE, stride, vertexOffset(offsetof(CellVertex, crossing)));
    slot->array.release();
    slot->index_count = static_cast<int>(mesh.indices.size());
    slot->bytes = mesh.vertices.size() * sizeof(CellVertex) + mesh.indices.size() * sizeof(std::uint32_t);
    slot->used = picture_number_;
    mesh_bytes_ += slot->bytes;
    dropUnused();
}

void TextileRenderer::dropUnused()
{
    for (auto mesh = meshes_.begin(); mesh_bytes_ > most_mesh_bytes && mesh != meshes_.end();) {
        if (mesh->second->used + kept_pictures < picture_number_) {
            mesh_bytes_ -= mesh->second->bytes;
            mesh = meshes_.erase(mesh);
        } else {
            ++mesh;
        }
    }
}

void TextileRenderer::setPicture(const RepeatPicture& picture)
{
    repeat_light_.setPicture(picture);
    picture_ = picture;
    picture_.texels.clear();
}

bool TextileRenderer::has(const MeshKey& key) const { return key.level == 0 ? picture_.width > 0 : meshes_.count(key) > 0; }

std::size_t TextileRenderer::triangles(const std::vector<CellBatch>& batches) const
{
    std::size_t sum = 0;
    for (const CellBatch& batch : batches) {
        const auto mesh = meshes_.find(batch.key);
        const std::size_t each = batch.key.level == 0    ? 2
                                 : mesh == meshes_.end() ? 0
                                                         : static_cast<std::size_t>(mesh->second->index_count) / 3;
        for (const auto& cells : batch.cells) { sum += each * cells.size(); }
    }
    return sum;
}

void TextileRenderer::setWater(const std::vector<float>& values, double maximum)
{
    const auto crossings = fabric_ ? static_cast<std::size_t>(fabric_->textile.crossings()) : 0;
    water_maximum_ = values.size() < 2 * crossings || crossings == 0 ? 0 : maximum;
    if (water_maximum_ <= 0) { return; }
    const Textile& textile = fabric_->textile;
    std::vector<float> texels;
    texels.reserve(2 * crossings);
    for (int pick = 0; pick < textile.picks(); ++pick) {
        for (int end = 0; end < textile.ends(); ++end) {
            texels.push_back(values[static_cast<std::size_t>(textile.segment(YarnKind::warp, end, pick))]);
            texels.push_back(values[static_cast<std::size_t>(textile.segment(YarnKind::weft, end, pick))]);
        }
    }
    gl_->glBindTexture(GL_TEXTURE_2D, water_);
    gl_->glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1000);
    gl_->glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, textile.ends(), textile.picks(), 0, GL_RG, GL_FLOAT, texels.data());
    gl_->glGenerateMipmap(GL_TEXTURE_2D);
    gl_->glBindTexture(GL_TEXTURE_2D, 0);
}

void TextileRenderer::setColors(const PictureColors& colors)
{
    if (colors.warp == shown_warp_ && colors.weft == shown_weft_) { return; }
    shown_warp_ = colors.warp;
    shown_weft_ = colors.weft;
    const QVector3D pitch = fabric_->pitch();
    const auto load = [this](unsigned texture, const std::vector<const Yarn*>& yarns, const QColor& undyed, float along) {
        std::vector<float> texels;
        for (const Yarn* yarn : yarns) {
            const QVector3D shown = lightOf(yarn->color ? QColor(yarn->color->red, yarn->color->green, yarn->color->blue) : undyed);
            const double turns = yarn->twist_per_m * metre_from_mm(along) * (yarn->twist_direction == TwistDirection::z ? 1 : -1);
            texels.insert(texels.end(), {shown.x(), shown.y(), shown.z(), static_cast<float>(turns)});
        }
        gl_->glBindTexture(GL_TEXTURE_2D, texture);
        gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1000);
        gl_->glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        gl_->glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<int>(yarns.size()), 1, 0, GL_RGBA, GL_FLOAT, texels.data());
        gl_->glGenerateMipmap(GL_TEXTURE_2D);
    };
    load(end_colors_, fabric_->end_yarns, colors.warp, pitch.y());
    load(pick_colors_, fabric_->pick_yarns, colors.weft, pitch.x());
    gl_->glBindTexture(GL_TEXTURE_2D, 0);
}

void TextileRenderer::draw(const SceneView& view, const std::vector<CellBatch>& batches, const QSize& pixels, const PictureColors& colors)
{
    ++picture_number_;
    gl_->glViewport(0, 0, pixels.width(), pixels.height());
    const QVector3D clear = lightOf(colors.background);
    const bool belt =
        std::any_of(batches.begin(), batches.end(), [](const CellBatch& batch) { return !batch.of(CellRole::fibres).empty(); });
    gl_->glClearColor(clear.x(), clear.y(), clear.z(), belt ? 0 : 1);
    gl_->glEnable(GL_DEPTH_TEST);
    gl_->glDisable(GL_BLEND);
    if (belt) {
        blendBelt(view, batches, pixels, colors);
    } else {
        drawFabric(view, batches, colors, {});
    }
    liquid_.draw(view, colors, pixels, fabric_ ? 0.5F * fabric_->pitch().z() : 0.0F);
    gl_->glDisable(GL_DEPTH_TEST);
}

void TextileRenderer::drawFabric(const SceneView& view, const std::vector<CellBatch>& batches, const PictureColors& colors,
                                 std::optional<CellRole> belt)
{
    gl_->glDepthMask(GL_TRUE);
    gl_->glDepthFunc(GL_LEQUAL);
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (!fabric_) { return; }
    setColors(colors);
    repeat_light_.lightFrom(view.camera.direction());
    if (colors.shadow) { ground_.draw(view, *fabric_, colors.background); }
    for (const CellRole role : {CellRole::whole, CellRole::fading, CellRole::over}) {
        drawCells(view, batches, colors, role, belt.has_value());
    }
    if (belt) { drawCells(view, batches, colors, *belt, true); }
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void TextileRenderer::blendBelt(const SceneView& view, const std::vector<CellBatch>& batches, const QSize& pixels,
                                const PictureColors& colors)
{
    int target = 0;
    gl_->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    for (const bool fibres : {false, true}) {
        auto& picture = belt_pictures_[fibres ? 1 : 0];
        drawFabric(view, batches, colors, fibres ? CellRole::fibres : CellRole::skins);
        if (!picture || picture->size() != pixels) { picture = lightCopy(pixels); }
        gl_->glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned>(target));
        gl_->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture->handle());
        gl_->glBlitFramebuffer(0, 0, pixels.width(), pixels.height(), 0, 0, pixels.width(), pixels.height(), GL_COLOR_BUFFER_BIT,
                               GL_NEAREST);
        gl_->glBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(target));
    }
    for (const unsigned unit : {1U, 0U}) {
        gl_->glActiveTexture(GL_TEXTURE0 + unit);
        gl_->glBindTexture(GL_TEXTURE_2D, belt_pictures_[unit]->texture());
    }
    blend_.bind();
    blend_.setUniformValue("skins", 0);
    blend_.setUniformValue("fibres", 1);
    gl_->glDepthFunc(GL_ALWAYS);
    gl_->glDepthMask(GL_FALSE); // that of the fibres stays, for drops
    flat_array_.bind();
    gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
    flat_array_.release();
    blend_.release();
    gl_->glDepthMask(GL_TRUE);
    gl_->glDepthFunc(GL_LEQUAL);
}

void TextileRenderer::prepare(QOpenGLShaderProgram& program, const SceneView& view, const PictureColors& colors)
{
    const Textile& textile = fabric_->textile;
    const QVector3D pitch = fabric_->pitch();
    const float side = view.camera.eye().z() >= 0 ? 1.0F : -1.0F;
    program.bind();
    program.setUniformValue("view_projection", view.clip());
    program.setUniformValue("eye", view.camera.eye());
    program.setUniformValue("side", side);
    program.setUniformValue("water", water_unit);
    program.setUniformValue("ramp", ramp_unit);
    program.setUniformValue("end_colors", end_unit);
    program.setUniformValue("pick_colors", pick_unit);
    program.setUniformValue("repeat_light", light_unit);
    program.setUniformValue("looks", looks_unit);
    const bool natural = colors.water == WaterColors::natural;
    program.setUniformValue("natural", natural ? 1.0F : 0.0F);
    static const QVector2D film(static_cast<float>(film_entry), static_cast<float>(inner_reflection(water_index)));
    program.setUniformValue("film", film);
    const double full = natural && water_maximum_ > 0 ? 1 : water_maximum_; // how wet yarns look depends on no range of colours
    program.setUniformValue("water_scale", full > 0 ? static_cast<float>(1 / full) : 0.0F);
    // Water leaves dry yarns their colour; warmth is shown of every yarn.
    program.setUniformValue("bare", colors.water == WaterColors::warmth ? 1e-6F : 0.02F);
    program.setUniformValue("background",
                            (colors.shadow && side > 0 ? 1 - ground_dark : 1) * lightOf(colors.background)); // seen through gaps
    program.setUniformValue("marked_color", lightOf(colors.marked));
    gl_->glUniform2i(program.uniformLocation("marked"), marked_.kind == YarnKind::warp ? 0 : 1, marked_.yarn);
    const auto around = [&](YarnKind kind, float along) { return static_cast<float>(mm_from_metre(perimeter_of(textile, kind))) / along; };
    program.setUniformValue("winding", QVector2D(around(YarnKind::warp, pitch.y()), around(YarnKind::weft, pitch.x())));
    program.setUniformValue("half_thickness", 0.5F * pitch.z());
    program.setUniformValue("pitch", QVector3D(pitch.x(), pitch.y(), side * picture_.level));
    program.setUniformValue("period", QVector2D(static_cast<float>(picture_.ends), static_cast<float>(picture_.picks)));
    program.setUniformValue("crossings", QVector2D(static_cast<float>(textile.ends()), static_cast<float>(textile.picks())));
    // In a parallel view the depth that the card divides by is 1 everywhere.
    const double depth = view.camera.parallel() ? view.camera.depth({}) : 1;
    const double one = pitch_scale(*fabric_, view) * view.camera.pixelsPerMillimetre(1e9, view.size) * 1e9 / depth;
    program.setUniformValue("belt",
                            QVector3D(static_cast<float>(one), static_cast<float>(belt_pixels[0]), static_cast<float>(belt_pixels[1])));
    program.setUniformValue("fibre_belt", QVector3D(static_cast<float>(one), static_cast<float>(fibre_belt_pixels[0]),
                                                    static_cast<float>(fibre_belt_pixels[1])));
    program.setUniformValue("cut", cutOf(view));
}

void TextileRenderer::placeInstances(const std::vector<CellInstance>& instances)
{
    instances_.bind();
    instances_.allocate(instances.data(), static_cast<int>(instances.size() * sizeof(CellInstance)));
    constexpr int stride = sizeof(CellInstance);
    for (const unsigned attribute : {4U, 5U}) {
        gl_->glEnableVertexAttribArray(attribute);
        gl_->glVertexAttribDivisor(attribute, 1);
    }
    gl_->glVertexAttribPointer(4, 4, GL_FLOAT, GL_FALSE, stride, vertexOffset(offsetof(CellInstance, corner)));
    gl_->glVertexAttribPointer(5, 3, GL_FLOAT, GL_FALSE, stride, vertexOffset(offsetof(CellInstance, size)));
}

void TextileRenderer::bindTextures(WaterColors water)
{
    if (!ramp_ || ramp_colors_ != water) {
        ramp_ = lightRamp(water);
        ramp_colors_ = water;
    }
    const std::pair<int, unsigned> textures[] = {
        {water_unit, water_}, {ramp_unit, ramp_->textureId()}, {end_unit, end_colors_}, {pick_unit, pick_colors_}};
    for (const auto& [unit, texture] : textures) {
        gl_->glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
        gl_->glBindTexture(GL_TEXTURE_2D, texture);
    }
    repeat_light_.bind(light_unit, looks_unit);
}

void TextileRenderer::drawCells(const SceneView& view, const std::vector<CellBatch>& batches, const PictureColors& colors, CellRole role,
                                bool in_belt)
{
    bindTextures(colors.water);
    gl_->glEnable(GL_CLIP_DISTANCE0);
    if (role == CellRole::over) {
        // Over all tubes, high or low.
        gl_->glDepthFunc(GL_ALWAYS);
        gl_->glDepthMask(GL_FALSE);
        gl_->glEnable(GL_BLEND);
        gl_->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    }
    for (const bool flat : {true, false}) {
        QOpenGLShaderProgram& program = (flat ? flats_ : yarns_)[role == CellRole::fading ? 1 : 0];
        gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, in_belt && !flat ? GL_TRUE : GL_FALSE); // alpha is of the belt alone
        bool prepared = false;
        for (const CellBatch& batch : batches) {
            const std::vector<CellInstance>& instances = batch.of(role);
            if ((batch.key.level == 0) != flat || instances.empty() || !has(batch.key)) { continue; }
            if (!std::exchange(prepared, true)) {
                prepare(program, view, colors);
                if (flat && view.cut && view.cut->normal.z != 0) { program.setUniformValue("cut", QVector4D(0, 0, 0, 1)); }
                program.setUniformValue("over_tubes", role == CellRole::over ? 1.0F : 0.0F);
            }
            if (flat) {
                drawFlat(instances);
            } else {
                drawTubes(*meshes_.at(batch.key), instances, view.cut.has_value());
            }
        }
        gl_->glDisable(GL_CULL_FACE);
    }
    gl_->glDisable(GL_CLIP_DISTANCE0);
    gl_->glDisable(GL_BLEND);
    gl_->glDepthMask(GL_TRUE);
    gl_->glDepthFunc(GL_LEQUAL);
    gl_->glUseProgram(0);
}

void TextileRenderer::drawFlat(const std::vector<CellInstance>& instances)
{
    flat_array_.bind();
    placeInstances(instances);
    gl_->glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<int>(instances.size()));
    flat_array_.release();
}

/// insides: they are seen where yarns are cut.
void TextileRenderer::drawTubes(TubeMesh& mesh, const std::vector<CellInstance>& instances, bool insides)
{
    mesh.used = picture_number_;
    mesh.array.bind();
    placeInstances(instances);
    if (insides) {
        gl_->glDisable(GL_CULL_FACE);
    } else {
        gl_->glEnable(GL_CULL_FACE);
    }
    gl_->glDrawElementsInstanced(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr, static_cast<int>(instances.size()));
    mesh.array.release();
}

void complete(FabricScene& scene, TextileRenderer& renderer, const SceneView& view)
{
    const auto available = [&](const MeshKey& key) { return renderer.has(key); };
    scene.update(view, 0, available);
    for (int round = 0; round < 2 && scene.fabric(); ++round) { // the second: what lies under a belt
        for (const WantedMesh& wish : scene.wanted()) {
            if (wish.key.level == 0) {
                renderer.setPicture(picture_of_repeat(*scene.fabric()));
            } else {
                renderer.addMesh(mesh_cell(*scene.fabric(), wish.cell, wish.key.level));
            }
        }
        scene.settle();
        scene.update(view, 0, available);
        scene.settle();
    }
}

} // namespace hygroloom
