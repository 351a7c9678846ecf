// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What all that is drawn with OpenGL has in common: the context, colours, shaders and the cut.
#pragma once

#include "ui/basics/color_map.h"
#include "ui/picture/fabric_scene.h"

#include <QColor>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>
#include <QPalette>

#include <memory>

namespace hygroloom {

/// Asks for contexts that the renderer can use. To be called before the application begins.
void requestOpenGL();

/// How a picture is coloured.
struct PictureColors {
    QColor background;
    QColor warp; ///< of ends without a colour of their own
    QColor weft;
    QColor marked;
    WaterColors water = WaterColors::blue;
    bool shadow = false; ///< the cloth throws one on a ground below it
};

/// For a widget with this palette.
PictureColors pictureColors(const QPalette& palette);

/// Red, green and blue of a display (sRGB, IEC 61966-2-1) as shares of linear light, which pictures are drawn in.
QVector3D lightOf(const QColor& color);
/// A target for that: half floats with depth. samples: of a pixel, 0 for none.
std::unique_ptr<QOpenGLFramebufferObject> lightPicture(const QSize& pixels, int samples = 0);
/// A target for what has been drawn, without depth.
std::unique_ptr<QOpenGLFramebufferObject> lightCopy(const QSize& pixels);

/// From linear light to the values that a display takes. All members need the same current context.
class DisplayEncoder {
public:
    /// The driver's complaint about the shader, or nothing.
    QString initialize();
    void release();
    /// Both are as large; light has no samples.
    void encode(QOpenGLFramebufferObject& light, QOpenGLFramebufferObject& shown);

private:
    QOpenGLShaderProgram program_;
    QOpenGLVertexArrayObject nothing_; ///< of a triangle that needs no vertices
};

/// The colours of water in linear light, from little to much.
std::unique_ptr<QOpenGLTexture> lightRamp(WaterColors colors);

/// The plane of the view's cut, for shaders: a point is kept where its product with the first three is at most the fourth, in mm.
QVector4D cutOf(const SceneView& view);

/// Compiles resources/shaders/NAME.frag and NAME.vert, or whole.vert where there is none of the name. fading: with cells that fade over.
/// The driver's complaint, or nothing.
QString loadShaders(QOpenGLShaderProgram& program, const QString& name, bool fading = false);

/// A place in a vertex, as OpenGL takes it.
// NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL's own way
inline const void* vertexOffset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

} // namespace hygroloom
