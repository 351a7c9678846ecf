// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is written over the picture of the fabric.
#include "core/base/units.h"
#include "ui/appearance.h"
#include "ui/quantity.h"
#include "ui/textile_canvas.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double margin = 16;

void drawPlate(QPainter& painter, const QRectF& area, const QPalette& palette)
{
    QColor plate = palette.color(QPalette::Base);
    plate.setAlphaF(0.86F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(plate);
    painter.drawRoundedRect(area, 4, 4);
    painter.setBrush(Qt::NoBrush);
}

} // namespace

void TextileCanvas::drawOverlay(QPainter& painter)
{
    const QColor ink = palette().color(QPalette::WindowText);
    const QColor paper = colors().background;
    if (!usable_ || !mesh_) {
        painter.fillRect(rect(), paper);
        painter.setPen(ink);
        const QString text = usable_ ? caption_.notice : renderer_.problem();
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, text);
        return;
    }
    drawHighlight(painter);
    const QFontMetricsF metrics(painter.font());
    if (!caption_.title.isEmpty()) {
        const QRectF plate(margin - 6, margin - 4, metrics.horizontalAdvance(caption_.title) + 12, metrics.height() + 8);
        drawPlate(painter, plate, palette());
        painter.setPen(ink);
        painter.drawText(plate, Qt::AlignCenter, caption_.title);
    }
    if (!caption_.notice.isEmpty()) {
        const double room = width() - 2 * margin - (caption_.legend.isEmpty() ? 0 : 120);
        const QRectF text = metrics.boundingRect(QRectF(0, 0, std::max(120.0, room), height()), Qt::TextWordWrap, caption_.notice);
        const QRectF plate(margin - 6, margin + metrics.height() + 10, text.width() + 20, text.height() + 10);
        drawPlate(painter, plate, palette());
        painter.fillRect(QRectF(plate.left(), plate.top(), 3, plate.height()), severityColor(Severity::warning, palette()));
        painter.setPen(ink);
        painter.drawText(plate.adjusted(10, 5, -4, -4), Qt::TextWordWrap, caption_.notice);
    }
    drawPlate(painter, QRectF(margin - 8, height() - margin - metrics.height() - 12, scaleBarLength(camera_.millimetrePerPixel(QSizeF(size())), width() * 0.6) + 16, metrics.height() + 22),
              palette());
    drawScaleBar(painter, {margin, height() - margin}, camera_.millimetrePerPixel(QSizeF(size())), width() * 0.6, ink);
    drawAxes(painter, ink);
    if (!caption_.legend.isEmpty()) {
        const double width = std::max(90.0, metrics.horizontalAdvance(caption_.legend) + 8);
        const QRectF area(this->width() - width - margin, margin, width, std::min(170.0, height() * 0.45));
        drawPlate(painter, area.adjusted(-8, -6, 6, 8), palette());
        painter.setPen(ink);
        drawLegend(painter, area, caption_.legend, caption_.legend_maximum * caption_.legend_scale, caption_.unit, water_colors_);
    }
    drawHover(painter, ink);
}

void TextileCanvas::drawAxes(QPainter& painter, const QColor& ink)
{
    // A small cross of the fabric's directions, in the lower right corner.
    const QPointF centre(width() - margin - 46, height() - margin - 22);
    drawPlate(painter, QRectF(centre.x() - 52, centre.y() - 46, 106, 76), palette());
    const QMatrix4x4 view = camera_.view();
    const QFontMetricsF metrics(painter.font());
    const auto arm = [&](const QVector3D& axis, const QString& text) {
        const QVector3D turned = view.mapVector(axis);
        const QPointF direction(turned.x(), -turned.y());
        painter.setPen(QPen(ink, 1.5));
        painter.drawLine(centre, centre + 28 * direction);
        // Looked along, an arm is a point and needs no name.
        if (std::hypot(direction.x(), direction.y()) < 0.25 || text.isEmpty()) {
            return;
        }
        const QPointF label = centre + 28 * direction + 14 * direction / std::hypot(direction.x(), direction.y());
        painter.drawText(label - QPointF(0.5 * metrics.horizontalAdvance(text), -0.35 * metrics.ascent()), text);
    };
    arm({0, 0, 0.6F}, {});
    arm({0, 1, 0}, tr("warp"));
    arm({1, 0, 0}, tr("weft"));
}

void TextileCanvas::drawHover(QPainter& painter, const QColor& ink)
{
    if (hovered_.x() < 0 || drag_ != Qt::NoButton) {
        return;
    }
    const Textile& textile = mesh_->textile;
    const TextileRegion& patch = mesh_->request.patch;
    const TextileRegion& whole = mesh_->request.whole;
    const int end = hovered_.x() - (patch.first_end - whole.first_end);
    const int pick = hovered_.y() - (patch.first_pick - whole.first_pick);
    if (end < 0 || pick < 0 || end >= textile.ends() || pick >= textile.picks()) {
        return;
    }
    const bool warpUp = textile.warp_up(end, pick);
    QStringList lines{tr("End %1, pick %2: %3").arg(hovered_.x() + 1).arg(hovered_.y() + 1).arg(warpUp ? tr("warp over weft") : tr("weft over warp"))};
    if (!water_.empty()) {
        const auto crossings = static_cast<std::size_t>(whole.ends) * static_cast<std::size_t>(whole.picks);
        const auto warp = static_cast<std::size_t>(hovered_.x()) * static_cast<std::size_t>(whole.picks) + static_cast<std::size_t>(hovered_.y());
        const auto weft = crossings + static_cast<std::size_t>(hovered_.y()) * static_cast<std::size_t>(whole.ends) + static_cast<std::size_t>(hovered_.x());
        if (weft < water_.size()) {
            const auto shown = [this](float value) { return shownNumber(value * caption_.legend_scale, 1) + QChar(0x00a0) + caption_.unit; };
            lines << tr("End %1, pick %2 of the pores filled").arg(shown(water_[warp]), shown(water_[weft]));
        }
    }
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines) {
        width = std::max(width, metrics.horizontalAdvance(line));
    }
    QRectF plate(pointer_ + QPointF(16, 16), QSizeF(width + 16, metrics.height() * static_cast<double>(lines.size()) + 8));
    plate.moveRight(std::min(plate.right(), this->width() - 4.0));
    if (plate.bottom() > height() - 4) {
        plate.moveBottom(pointer_.y() - 8);
    }
    drawPlate(painter, plate, palette());
    painter.setPen(ink);
    painter.drawText(plate.adjusted(8, 4, -8, -4), Qt::AlignLeft | Qt::AlignTop, lines.join('\n'));
}

void TextileCanvas::drawHighlight(QPainter& painter)
{
    const QPoint repeat(mesh_->textile.weave.ends(), mesh_->textile.weave.picks());
    QPoint wanted = highlight_;
    if (wanted.x() < 0) {
        return;
    }
    const Textile& textile = mesh_->textile;
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    const double side = camera_.eye().z() >= 0 ? 1 : -1;
    for (int end = 0; end < textile.ends(); ++end) {
        for (int pick = 0; pick < textile.picks(); ++pick) {
            if ((textile.first_end + end) % repeat.x() != wanted.x() || (textile.first_pick + pick) % repeat.y() != wanted.y()) {
                continue;
            }
            const auto corner = [&](double across, double along) {
                return camera_.project(mesh_->offset
                                           + QVector3D(static_cast<float>(mm_from_metre(textile.x_of_end(end) + 0.42 * across * textile.warp.pitch)),
                                                       static_cast<float>(mm_from_metre(textile.y_of_pick(pick) + 0.42 * along * textile.weft.pitch)),
                                                       static_cast<float>(mm_from_metre(side * textile.half_thickness()))),
                                       QSizeF(size()));
            };
            const QPointF frame[] = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
            painter.drawPolygon(frame, 4);
        }
    }
}

} // namespace hygroloom
