// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/drawing.h"

#include "core/base/units.h"
#include "ui/basics/appearance.h"

#include <QCoreApplication>
#include <QFile>
#include <QSurfaceFormat>
#include <QVector3D>
#include <QVector4D>

#include <cmath>

namespace hygroloom {

namespace {

QByteArray textOf(const QString& name)
{
    QFile file(":/shaders/" + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

void requestOpenGL()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
}

PictureColors pictureColors(const QPalette& palette)
{
    PictureColors colors;
    colors.background = isDark(palette) ? QColor("#191c1f") : QColor("#e9ecee");
    colors.warp = QColor("#f0e8d8");
    colors.weft = QColor("#e2d5bb");
    colors.marked = palette.color(QPalette::Highlight);
    return colors;
}

QVector3D lightOf(const QColor& color)
{
    const auto light = [](float value) { return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F); };
    return {light(static_cast<float>(color.redF())), light(static_cast<float>(color.greenF())), light(static_cast<float>(color.blueF()))};
}

std::unique_ptr<QOpenGLFramebufferObject> lightPicture(const QSize& pixels, int samples)
{
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    format.setInternalTextureFormat(GL_RGBA16F);
    format.setSamples(samples);
    return std::make_unique<QOpenGLFramebufferObject>(pixels, format);
}

QVector4D cutOf(const SceneView& view)
{
    if (!view.cut) { return {0, 0, 0, 1}; }
    const auto& n = view.cut->normal;
    return {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z), static_cast<float>(mm_from_metre(view.cut->offset))};
}

QString loadShaders(QOpenGLShaderProgram& program, const QString& name, bool fading)
{
    const QByteArray version = "#version 330 core\n";
    const bool lit = name == "yarn" || name == "flat" || name == "repeat";
    const QByteArray own = textOf(name + ".vert");
    const QByteArray shared =
        lit ? (fading ? "#define FADING\n" : "") + QByteArray("#define real float\n") + textOf("cloth_light.glsl") + textOf("light.glsl")
            : QByteArray();
    if (program.addShaderFromSourceCode(QOpenGLShader::Vertex, version + (own.isEmpty() ? textOf("whole.vert") : own)) &&
        program.addShaderFromSourceCode(QOpenGLShader::Fragment, version + shared + textOf(name + ".frag")) && program.link()) {
        return {};
    }
    return QCoreApplication::translate("hygroloom", "The graphics driver rejected a shader: %1").arg(program.log());
}

} // namespace hygroloom
