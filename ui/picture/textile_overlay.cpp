// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is written over the picture of the fabric.
#include "core/base/units.h"
#include "ui/basics/appearance.h"
#include "ui/basics/quantity.h"
#include "ui/picture/textile_canvas.h"

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
    if (!usable_ || !fabric()) {
        painter.fillRect(rect(), paper);
        painter.setPen(ink);
        const QString text = usable_ ? caption_.notice : renderer_.problem();
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, text);
        return;
    }
    drawHighlight(painter);
    const QFontMetricsF metrics(painter.font());
    drawTitle(painter, ink);
    if (const auto scale = millimetre_per_pixel(camera_, *fabric(), cut(), QSizeF(size()))) {
        drawPlate(painter,
                  QRectF(margin - 8, height() - margin - metrics.height() - 12, scaleBarLength(*scale, width() * 0.6) + 16,
                         metrics.height() + 22),
                  palette());
        drawScaleBar(painter, {margin, height() - margin}, *scale, width() * 0.6, ink);
    }
    drawAxes(painter, ink);
    if (showsLegend()) {
        const double width = std::max(90.0, metrics.horizontalAdvance(caption_.legend) + 8);
        const QRectF area(this->width() - width - margin, margin, width, std::min(170.0, height() * 0.45));
        drawPlate(painter, area.adjusted(-8, -6, 6, 8), palette());
        painter.setPen(ink);
        const double low = caption_.legend_zero, high = low + caption_.legend_maximum * caption_.legend_scale;
        drawLegend(painter, area, caption_.legend, low, high, caption_.unit, water_colors_);
    }
    drawDrops(painter);
    drawMeasurement(painter, ink);
    drawHover(painter, ink);
}

/// The time of a film's picture, on a plate of its own so that it is read over any cloth. Returns the plate's lower edge.
double TextileCanvas::drawClock(QPainter& painter, const QColor& ink)
{
    if (caption_.clock.isEmpty()) { return margin - 8; }
    painter.save();
    QFont large = painter.font();
    large.setBold(true);
    large.setPointSizeF(1.4 * large.pointSizeF());
    painter.setFont(large);
    const QFontMetricsF metrics(large);
    const QRectF plate(margin - 6, margin - 4, metrics.horizontalAdvance(caption_.clock) + 12, metrics.height() + 8);
    drawPlate(painter, plate, palette());
    painter.setPen(ink);
    painter.drawText(plate.adjusted(6, 4, -2, -2), Qt::AlignLeft | Qt::AlignVCenter, caption_.clock);
    painter.restore();
    return plate.bottom();
}

void TextileCanvas::drawTitle(QPainter& painter, const QColor& ink)
{
    double top = drawClock(painter, ink) + 8;
    const QFontMetricsF metrics(painter.font());
    const auto line = [&](const QString& text, const QColor& edge) {
        if (text.isEmpty()) { return; }
        const double room = width() - 2 * margin - (caption_.legend.isEmpty() ? 0 : 120);
        const QRectF size = metrics.boundingRect(QRectF(0, 0, std::max(120.0, room), height()), Qt::TextWordWrap, text);
        const QRectF plate(margin - 6, top - 4, size.width() + (edge.isValid() ? 20 : 12), size.height() + 8);
        drawPlate(painter, plate, palette());
        if (edge.isValid()) { painter.fillRect(QRectF(plate.left(), plate.top(), 3, plate.height()), edge); }
        painter.setPen(ink);
        painter.drawText(plate.adjusted(edge.isValid() ? 10 : 6, 4, -2, -2), Qt::TextWordWrap, text);
        top = plate.bottom() + 8;
    };
    line(caption_.title, {});
    line(caption_.notice, severityColor(Severity::warning, palette()));
    line(selectionText(), palette().color(QPalette::Highlight));
    if (measuring_ && measured_.size() < 2) {
        line(measured_.empty() ? tr("Click the first point on a yarn. Esc ends measuring.")
                               : tr("Click the second point. Esc starts again."),
             palette().color(QPalette::Highlight));
    }
}

QString TextileCanvas::selectionText() const
{
    if (selected_.yarn < 0 || !fabric()) { return {}; }
    const Textile& textile = fabric()->textile;
    if (selected_.kind == YarnKind::warp) {
        return tr("End %1 of the repeat, %2 of the piece")
            .arg((textile.first_end + selected_.yarn) % textile.weave.ends() + 1)
            .arg(selected_.yarn + 1);
    }
    return tr("Pick %1 of the repeat, %2 of the piece")
        .arg((textile.first_pick + selected_.yarn) % textile.weave.picks() + 1)
        .arg(selected_.yarn + 1);
}

void TextileCanvas::drawMeasurement(QPainter& painter, const QColor& ink)
{
    const QColor accent = palette().color(QPalette::Highlight);
    const auto marked = [&](const QVector3D& point) {
        const QPointF at = camera_.project(point, QSizeF(size()));
        painter.setPen(QPen(colors().background, 4));
        painter.drawEllipse(at, 5, 5);
        painter.setPen(QPen(accent, 2));
        painter.drawEllipse(at, 5, 5);
        return at;
    };
    std::vector<QPointF> ends;
    for (const QVector3D& point : measured_) { ends.push_back(marked(point)); }
    const auto found = measurement();
    if (!found) { return; }
    painter.setPen(QPen(colors().background, 4));
    painter.drawLine(ends[0], ends[1]);
    painter.setPen(QPen(accent, 2));
    painter.drawLine(ends[0], ends[1]);
    const QVector3D way = found->to - found->from;
    const auto length = [](double mm) { return valueText(mm, "mm"); };
    const QStringList lines{
        length(found->length()),
        tr("warp %1, weft %2, height %3").arg(length(std::abs(way.y())), length(std::abs(way.x())), length(std::abs(way.z())))};
    const QFontMetricsF metrics(painter.font());
    QRectF plate(0, 0, metrics.horizontalAdvance(lines[1]) + 16, 2 * metrics.height() + 8);
    plate.moveCenter(0.5 * (ends[0] + ends[1]) + QPointF(0, metrics.height() * 2));
    plate.moveLeft(std::clamp(plate.left(), 4.0, std::max(4.0, width() - plate.width() - 4)));
    plate.moveTop(std::clamp(plate.top(), 4.0, std::max(4.0, height() - plate.height() - 4)));
    drawPlate(painter, plate, palette());
    painter.setPen(ink);
    painter.drawText(plate.adjusted(8, 4, -8, -4), Qt::AlignLeft | Qt::AlignTop, lines.join('\n'));
}

void TextileCanvas::drawAxes(QPainter& painter, const QColor& ink)
{
    // A small cross of the fabric's directions, in the lower right corner, on a plate with room for its names in every direction.
    constexpr double arm_length = 22, gap = 12;
    const QString warp = tr("warp"), weft = tr("weft");
    const QFontMetricsF metrics(painter.font());
    const double half_width = arm_length + gap + 0.5 * std::max(metrics.horizontalAdvance(warp), metrics.horizontalAdvance(weft)) + 4;
    const double half_height = arm_length + gap + 0.5 * metrics.height();
    const QPointF centre(width() - margin - half_width, height() - margin - half_height + 8);
    drawPlate(painter, QRectF(centre - QPointF(half_width, half_height), 2 * QSizeF(half_width, half_height)), palette());
    const QMatrix4x4 view = camera_.view();
    const auto arm = [&](const QVector3D& axis, const QString& text) {
        const QVector3D turned = view.mapVector(axis);
        const QPointF direction(turned.x(), -turned.y());
        painter.setPen(QPen(ink, 1.5));
        painter.drawLine(centre, centre + arm_length * direction);
        // Looked along, an arm is a point and needs no name.
        const double length = std::hypot(direction.x(), direction.y());
        if (length < 0.25 || text.isEmpty()) { return; }
        const QPointF label = centre + (arm_length + gap / length) * direction;
        painter.drawText(label - QPointF(0.5 * metrics.horizontalAdvance(text), -0.35 * metrics.ascent()), text);
    };
    arm({0, 0, 0.6F}, {});
    arm({0, 1, 0}, warp);
    arm({1, 0, 0}, weft);
}

void TextileCanvas::drawHover(QPainter& painter, const QColor& ink)
{
    if (hovered_.x() < 0 || pressed_ || measuring_) { return; }
    const Textile& textile = fabric()->textile;
    const int end = hovered_.x(), pick = hovered_.y();
    if (end >= textile.ends() || pick >= textile.picks()) { return; }
    const bool warpUp = textile.warp_up(end, pick);
    QStringList lines{tr("End %1, pick %2: %3").arg(end + 1).arg(pick + 1).arg(warpUp ? tr("warp over weft") : tr("weft over warp"))};
    const auto warp = static_cast<std::size_t>(textile.segment(YarnKind::warp, end, pick));
    const auto weft = static_cast<std::size_t>(textile.segment(YarnKind::weft, end, pick));
    if (weft < water_.size()) {
        const auto shown = [this](float value) {
            return shownNumber(caption_.legend_zero + value * caption_.legend_scale, 1) + QChar(0x00a0) + caption_.unit;
        };
        lines << caption_.pointed.arg(shown(water_[warp]), shown(water_[weft]));
    }
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines) { width = std::max(width, metrics.horizontalAdvance(line)); }
    QRectF plate(pointer_ + QPointF(16, 16), QSizeF(width + 16, metrics.height() * static_cast<double>(lines.size()) + 8));
    plate.moveRight(std::min(plate.right(), this->width() - 4.0));
    if (plate.bottom() > height() - 4) { plate.moveBottom(pointer_.y() - 8); }
    drawPlate(painter, plate, palette());
    painter.setPen(ink);
    painter.drawText(plate.adjusted(8, 4, -8, -4), Qt::AlignLeft | Qt::AlignTop, lines.join('\n'));
}

void TextileCanvas::drawHighlight(QPainter& painter)
{
    constexpr double least_pixels = 6; // of a pitch: narrower, marks would only be a veil
    const Textile& textile = fabric()->textile;
    const QVector3D pitch = fabric()->pitch();
    if (highlight_.x() < 0 || std::min(pitch.x(), pitch.y()) < least_pixels * camera_.millimetrePerPixel(QSizeF(size()))) { return; }
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    const float top = (camera_.direction().z() >= 0 ? 0.5F : -0.5F) * pitch.z();
    for (const Cell cell : scene_.visible()) {
        const TextileRegion part = fabric()->crossings(cell);
        for (int end = part.first_end; end < part.first_end + part.ends; ++end) {
            for (int pick = part.first_pick; pick < part.first_pick + part.picks; ++pick) {
                if ((textile.first_end + end) % textile.weave.ends() != highlight_.x() ||
                    (textile.first_pick + pick) % textile.weave.picks() != highlight_.y()) {
                    continue;
                }
                const QVector3D middle(static_cast<float>(mm_from_metre(textile.x_of_end(end))),
                                       static_cast<float>(mm_from_metre(textile.y_of_pick(pick))), top);
                const auto corner = [&](float across, float along) {
                    return camera_.project(middle + 0.42F * QVector3D(across * pitch.x(), along * pitch.y(), 0), QSizeF(size()));
                };
                const QPointF frame[] = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
                painter.drawPolygon(frame, 4);
            }
        }
    }
}

} // namespace hygroloom
