// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/drawing.h"

#include "core/base/units.h"
#include "ui/basics/appearance.h"

#include <QCoreApplication>
#include <QFile>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <QVector3D>
#include <QVector4D>

#include <cmath>
#include <vector>

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

std::unique_ptr<QOpenGLFramebufferObject> lightCopy(const QSize& pixels)
{
    QOpenGLFramebufferObjectFormat format;
    format.setInternalTextureFormat(GL_RGBA16F);
    return std::make_unique<QOpenGLFramebufferObject>(pixels, format);
}

QString DisplayEncoder::initialize()
{
    nothing_.create();
    return loadShaders(program_, "encode");
}

void DisplayEncoder::release()
{
    nothing_.destroy();
    program_.removeAllShaders();
}

void DisplayEncoder::encode(QOpenGLFramebufferObject& light, QOpenGLFramebufferObject& shown)
{
    QOpenGLFunctions* gl = QOpenGLContext::currentContext()->functions();
    shown.bind();
    gl->glViewport(0, 0, shown.width(), shown.height());
    gl->glDisable(GL_DEPTH_TEST);
    gl->glActiveTexture(GL_TEXTURE0);
    gl->glBindTexture(GL_TEXTURE_2D, light.texture());
    program_.bind();
    program_.setUniformValue("picture", 0);
    nothing_.bind();
    gl->glDrawArrays(GL_TRIANGLES, 0, 3);
    nothing_.release();
    program_.release();
    gl->glBindTexture(GL_TEXTURE_2D, 0);
    shown.release();
}

std::unique_ptr<QOpenGLTexture> lightRamp(WaterColors colors)
{
    const QImage ramp = waterRamp(colors);
    std::vector<float> texels;
    for (int i = 0; i < ramp.width(); ++i) {
        const QVector3D light = lightOf(ramp.pixelColor(i, 0));
        texels.insert(texels.end(), {light.x(), light.y(), light.z(), 1});
    }
    auto texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
    texture->setSize(ramp.width(), 1);
    texture->setFormat(QOpenGLTexture::RGBA32F);
    texture->allocateStorage(QOpenGLTexture::RGBA, QOpenGLTexture::Float32);
    texture->setData(QOpenGLTexture::RGBA, QOpenGLTexture::Float32, texels.data());
    texture->setMinMagFilters(QOpenGLTexture::Linear, QOpenGLTexture::Linear);
    texture->setWrapMode(QOpenGLTexture::ClampToEdge);
    return texture;
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
