// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/drawing.h"

#include "core/base/units.h"
#include "ui/basics/appearance.h"

#include <QCoreApplication>
#include <QFile>
#include <QSurfaceFormat>
#include <QVector3D>
#include <QVector4D>

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

QVector3D rgb(const QColor& color)
{
    return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()), static_cast<float>(color.blueF())};
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
    const QByteArray shared = lit ? (fading ? "#define FADING\n" : "") + textOf("light.glsl") : QByteArray();
    if (program.addShaderFromSourceCode(QOpenGLShader::Vertex, version + (own.isEmpty() ? textOf("whole.vert") : own)) &&
        program.addShaderFromSourceCode(QOpenGLShader::Fragment, version + shared + textOf(name + ".frag")) && program.link()) {
        return {};
    }
    return QCoreApplication::translate("hygroloom", "The graphics driver rejected a shader: %1").arg(program.log());
}

} // namespace hygroloom
