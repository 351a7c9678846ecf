// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Draws yarns, their water, and free liquid with OpenGL 3.3. Knows no widget: any current context will do.
#pragma once

#include "ui/camera.h"
#include "ui/color_map.h"
#include "ui/liquid_surface.h"
#include "ui/preview_mesh.h"

#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>

#include <array>

namespace hygroloom {

/// How a picture is coloured.
struct PictureColors {
    QColor background;
    QColor warp;
    QColor weft;
    WaterColors water = WaterColors::blue;
};

/// All members need the same current context.
class TextileRenderer {
public:
    /// False when the context has no OpenGL 3.3 or a shader does not compile; problem() then says so.
    bool initialize();
    const QString& problem() const { return problem_; }
    void release();

    /// A coarse mesh is kept beside the fine one, for drawing while things move. nullptr clears both.
    void setMesh(std::shared_ptr<const PreviewMesh> mesh);
    /// Share of full colour per segment of the patch; empty for a dry fabric.
    void setWater(const std::vector<float>& values, double maximum);
    void setLiquid(const LiquidSurface& surface);
    void draw(const Camera& camera, const QSize& pixels, const QSizeF& size, const PictureColors& colors, bool moving);
    bool hasFine() const { return slots_[1].mesh != nullptr; }

private:
    struct Slot {
        std::shared_ptr<const PreviewMesh> mesh;
        QOpenGLVertexArrayObject array;
        QOpenGLBuffer vertices{QOpenGLBuffer::VertexBuffer};
        QOpenGLBuffer indices{QOpenGLBuffer::IndexBuffer};
    };
    bool load(QOpenGLShaderProgram& program, const QString& name);
    void upload(Slot& slot);
    void drawYarns(Slot& slot, const Camera& camera, const QSizeF& size, const PictureColors& colors);
    void drawLiquid(const Camera& camera, const QSizeF& size, const PictureColors& colors);

    QOpenGLFunctions_3_3_Core* gl_ = nullptr;
    QString problem_;
    std::array<Slot, 2> slots_; ///< coarse, fine
    QOpenGLShaderProgram yarns_;
    QOpenGLShaderProgram drops_;
    unsigned water_ = 0;
    double water_maximum_ = 0;
    std::unique_ptr<QOpenGLTexture> ramp_;
    WaterColors ramp_colors_ = WaterColors::blue;
    QOpenGLVertexArrayObject drop_array_;
    QOpenGLBuffer drop_vertices_{QOpenGLBuffer::VertexBuffer};
    QOpenGLBuffer drop_indices_{QOpenGLBuffer::IndexBuffer};
    int drop_index_count_ = 0;
};

} // namespace hygroloom
