// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Pictures of fabrics for the gallery, drawn as the viewport draws them but without a window, and kept on the disk.
#pragma once

#include "ui/picture/textile_renderer.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace hygroloom {

/// To be made in the window's thread. nullptr where pictures cannot be drawn with OpenGL.
std::unique_ptr<QOffscreenSurface> swatchSurface();

/// Belongs to the thread that makes it. OpenGL is used only when a picture is not in the folder.
class SwatchPainter {
public:
    /// surface outlives this. The folder is made when it is needed, and keeps to most_swatch_bytes.
    SwatchPainter(QOffscreenSurface* surface, const QString& folder, int pixels, const PictureColors& colors);
    ~SwatchPainter();
    SwatchPainter(const SwatchPainter&) = delete;
    SwatchPainter& operator=(const SwatchPainter&) = delete;

    /// A piece of the design's first fabric from above, at the same scale for all but coarse ones. Where OpenGL cannot draw it, the flat
    /// cloth, which is not kept. Precondition: the fabric has no error.
    QImage picture(const std::shared_ptr<const Design>& design);
    /// Pictures that were not in the folder.
    int drawn() const { return drawn_; }

private:
    QString fileOf(const Design& design) const;
    void keep(const QImage& picture, const QString& file) const;
    bool begin();
    /// Null where there is no such large picture.
    QImage draw(const PreviewRequest& request, double side_mm);

    QOffscreenSurface* surface_;
    QString folder_;
    int pixels_;
    PictureColors colors_;
    std::optional<bool> usable_;
    std::unique_ptr<QOpenGLContext> context_;
    std::unique_ptr<TextileRenderer> renderer_;
    int drawn_ = 0;
};

constexpr qint64 most_swatch_bytes = 16 << 20;

} // namespace hygroloom
