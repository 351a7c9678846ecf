// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Draws yarns, their water, and free liquid with OpenGL 3.3. Knows no widget: any current context will do.
#pragma once

#include "ui/picture/ground_painter.h"
#include "ui/picture/liquid_painter.h"
#include "ui/picture/repeat_light.h"

#include <QOpenGLBuffer>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>

namespace hygroloom {

/// A yarn of the whole.
struct YarnNumber {
    YarnKind kind = YarnKind::warp;
    int yarn = -1; ///< none
    bool operator==(const YarnNumber&) const = default;
};

/// All members need the same current context.
class TextileRenderer {
public:
    /// False when the context has no OpenGL 3.3 or a shader does not compile; problem() then says so.
    bool initialize();
    const QString& problem() const { return problem_; }
    void release();

    /// Forgets all meshes. nullptr: nothing to draw.
    void setFabric(std::shared_ptr<const PreviewFabric> fabric);
    void addMesh(const CellMesh& mesh);
    void setPicture(const RepeatPicture& picture);
    bool has(const MeshKey& key) const;
    /// Triangles that these take, drawn once.
    std::size_t triangles(const std::vector<CellBatch>& batches) const;
    /// Values of the whole's segments; empty for a dry fabric.
    void setWater(const std::vector<float>& values, double maximum);
    void setLiquid(const LiquidSurface& surface) { liquid_.setLiquid(surface); }
    /// Whether free liquid is drawn as its particles instead of the surface round them.
    void setParticlesShown(bool shown) { liquid_.setParticlesShown(shown); }
    void setMarked(const YarnNumber& yarn) { marked_ = yarn; }
    /// Into the target that is bound, in linear light: a lightPicture().
    void draw(const SceneView& view, const std::vector<CellBatch>& batches, const QSize& pixels, const PictureColors& colors);
    /// From linear light, without samples, to the values that a display takes.
    void encode(QOpenGLFramebufferObject& light, QOpenGLFramebufferObject& shown) { encoder_.encode(light, shown); }

private:
    struct TubeMesh {
        QOpenGLVertexArrayObject array;
        QOpenGLBuffer vertices{QOpenGLBuffer::VertexBuffer};
        QOpenGLBuffer indices{QOpenGLBuffer::IndexBuffer};
        int index_count = 0;
        std::size_t bytes = 0;
        long used = 0; ///< number of the picture that last showed it
    };
    bool load(QOpenGLShaderProgram& program, const QString& name, bool fading);
    void makeTextures();
    void makeSquare();
    void bindTextures(WaterColors water);
    void setColors(const PictureColors& colors);
    void prepare(QOpenGLShaderProgram& program, const SceneView& view, const PictureColors& colors);
    void placeInstances(const std::vector<CellInstance>& instances);
    void drawCells(const SceneView& view, const std::vector<CellBatch>& batches, const PictureColors& colors, CellRole role, bool in_belt);
    void drawFlat(const std::vector<CellInstance>& instances);
    void drawTubes(TubeMesh& mesh, const std::vector<CellInstance>& instances, bool insides);
    /// belt: which of the two the cells in the belt show; their share then stands in the picture's alpha.
    void drawFabric(const SceneView& view, const std::vector<CellBatch>& batches, const PictureColors& colors,
                    std::optional<CellRole> belt);
    /// Draws the fabric twice, and one picture over the other.
    void blendBelt(const SceneView& view, const std::vector<CellBatch>& batches, const QSize& pixels, const PictureColors& colors);
    void dropUnused();

    QOpenGLFunctions_3_3_Core* gl_ = nullptr;
    QString problem_;
    std::shared_ptr<const PreviewFabric> fabric_;
    std::map<MeshKey, std::unique_ptr<TubeMesh>> meshes_;
    std::size_t mesh_bytes_ = 0;
    long picture_number_ = 0;
    QOpenGLShaderProgram yarns_[2]; ///< whole, fading
    QOpenGLShaderProgram flats_[2];
    QOpenGLShaderProgram blend_;
    std::unique_ptr<QOpenGLFramebufferObject> belt_pictures_[2]; ///< with skins, with fibres
    QOpenGLVertexArrayObject flat_array_;
    QOpenGLBuffer flat_vertices_{QOpenGLBuffer::VertexBuffer};
    QOpenGLBuffer instances_{QOpenGLBuffer::VertexBuffer};
    RepeatPicture picture_; ///< without its texels
    RepeatLight repeat_light_;
    unsigned water_ = 0;
    unsigned end_colors_ = 0; ///< of each end; alpha holds its turns per crossing
    unsigned pick_colors_ = 0;
    QColor shown_warp_, shown_weft_;
    double water_maximum_ = 0;
    YarnNumber marked_;
    std::unique_ptr<QOpenGLTexture> ramp_;
    WaterColors ramp_colors_ = WaterColors::blue;
    GroundPainter ground_;
    DisplayEncoder encoder_;
    LiquidPainter liquid_;
};

/// Makes all meshes that the picture would like to have, however long that takes, and ends all fading. Needs the renderer's context.
void complete(FabricScene& scene, TextileRenderer& renderer, const SceneView& view);

} // namespace hygroloom
