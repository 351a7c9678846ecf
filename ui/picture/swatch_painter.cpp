// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/swatch_painter.h"

#include "core/project/project_file.h"
#include "ui/basics/appearance.h"
#include "ui/weave/cloth_picture.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QGuiApplication>
#include <QOpenGLFramebufferObject>
#include <QSaveFile>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr const char* picture_version = "4"; // to be raised when meshes, framing or sampling change; shaders count by themselves
constexpr double swatch_mm = 5;
constexpr double least_threads = 6; // across the picture of a coarse fabric
constexpr int oversampling = 2;

double sideOf(const Fabric& fabric) { return std::max(swatch_mm, 10 * least_threads / std::min(fabric.ends_per_cm, fabric.picks_per_cm)); }

} // namespace

std::unique_ptr<QOffscreenSurface> swatchSurface()
{
    const QString platform = QGuiApplication::platformName();
    if (platform == "offscreen" || platform == "minimal" || !QOpenGLContext::supportsThreadedOpenGL()) { return nullptr; }
    auto surface = std::make_unique<QOffscreenSurface>();
    surface->create();
    return surface->isValid() ? std::move(surface) : nullptr;
}

SwatchPainter::SwatchPainter(QOffscreenSurface* surface, const QString& folder, int pixels, const PictureColors& colors)
    : surface_(surface), folder_(folder), pixels_(pixels), colors_(colors)
{
    useResources();
}

SwatchPainter::~SwatchPainter()
{
    if (renderer_ && context_->makeCurrent(surface_)) {
        renderer_->release();
        renderer_.reset();
        context_->doneCurrent();
    }
}

QImage SwatchPainter::picture(const std::shared_ptr<const Design>& design)
{
    const QString file = fileOf(*design);
    if (const QImage kept(file); kept.size() == QSize(pixels_, pixels_)) {
        QFile used(file);
        if (used.open(QIODevice::ReadWrite)) {
            used.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime); // what is looked at stays longest
        }
        return kept;
    }
    ++drawn_;
    const Fabric& fabric = design->fabrics[0];
    const double side = sideOf(fabric);
    const QImage drawn = begin() ? draw({design, 0, region_of_sample(fabric, 2 * side, 2 * side), {}}, side) : QImage();
    if (drawn.isNull()) {
        const auto threads = [&](double per_cm) { return std::min(pixels_, static_cast<int>(std::lround(0.1 * side * per_cm))); };
        return clothPicture(fabric, threads(fabric.ends_per_cm), threads(fabric.picks_per_cm)).scaled(pixels_, pixels_);
    }
    keep(drawn, file);
    return drawn;
}

QString SwatchPainter::fileOf(const Design& design) const
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const QDir shaders(":/shaders");
    for (const QString& name : shaders.entryList()) {
        QFile shader(shaders.filePath(name));
        if (shader.open(QIODevice::ReadOnly)) { hash.addData(&shader); }
    }
    hash.addData(picture_version);
    hash.addData(QCoreApplication::applicationVersion().toUtf8() + ' ');
    for (const QColor& color : {colors_.background, colors_.warp, colors_.weft}) { hash.addData(color.name().toLatin1()); }
    hash.addData(QByteArray::number(pixels_) + ' ');
    hash.addData(QByteArray::fromStdString(format_project(design)));
    return QDir(folder_).filePath(hash.result().toHex() + ".png");
}

void SwatchPainter::keep(const QImage& picture, const QString& file) const
{
    QDir folder(folder_);
    QSaveFile out(file);
    if (!folder.mkpath(".") || !out.open(QIODevice::WriteOnly) || !picture.save(&out, "PNG") || !out.commit()) {
        return; // drawn again the next time
    }
    qint64 bytes = 0;
    for (const QFileInfo& kept : folder.entryInfoList({"*.png"}, QDir::Files, QDir::Time)) {
        bytes += kept.size();
        if (bytes > most_swatch_bytes) { QFile::remove(kept.filePath()); }
    }
}

bool SwatchPainter::begin()
{
    if (!usable_) {
        usable_ = false;
        context_ = std::make_unique<QOpenGLContext>();
        if (surface_ && context_->create() && context_->makeCurrent(surface_)) {
            renderer_ = std::make_unique<TextileRenderer>();
            usable_ = renderer_->initialize();
        }
    }
    return *usable_ && context_->makeCurrent(surface_);
}

QImage SwatchPainter::draw(const PreviewRequest& request, double side_mm)
{
    const auto fabric = prepare_fabric(request);
    const auto half = static_cast<float>(0.5 * side_mm);
    SceneView view;
    view.size = QSizeF(oversampling * pixels_, oversampling * pixels_);
    view.detail = oversampling;
    view.camera.setReach(2.0 * (fabric->high() - fabric->low()).length());
    view.camera.setParallel(true);
    view.camera.lookFrom(0, 90);
    view.camera.fit({-half, -half, 0}, {half, half, 0}, view.size);
    FabricScene scene;
    scene.setFabric(fabric);
    renderer_->setFabric(fabric);
    complete(scene, *renderer_, view);
    const QSize drawn = view.size.toSize(), kept(pixels_, pixels_);
    const auto sampled = lightPicture(drawn, 4), light = lightCopy(drawn), smaller = lightCopy(kept);
    QOpenGLFramebufferObject shown(kept);
    if (!sampled->isValid() || !light->isValid() || !smaller->isValid() || !shown.isValid()) { return {}; }
    sampled->bind();
    renderer_->draw(view, scene.batches(), drawn, colors_);
    sampled->release();
    QOpenGLFramebufferObject::blitFramebuffer(light.get(), sampled.get());
    QOpenGLFramebufferObject::blitFramebuffer(smaller.get(), {{0, 0}, kept}, light.get(), {{0, 0}, drawn}, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    renderer_->encode(*smaller, shown);
    return shown.toImage().convertToFormat(QImage::Format_RGB32);
}

} // namespace hygroloom
