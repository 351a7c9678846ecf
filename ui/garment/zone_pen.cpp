// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/zone_pen.h"

#include "core/base/units.h"

#include <QPainter>
#include <QPalette>

#include <algorithm>

namespace hygroloom {

namespace {

const QColor ink("#6a1b9a");

QPointF pixelOf(const FlatPlace& place, const DrawnPanel& panel, const QTransform& view)
{
    return view.map(QPointF(place[0] + panel.on_sheet[0], place[1] + panel.on_sheet[1]));
}

QPolygonF pixelsOf(const std::vector<FlatPlace>& outline, const DrawnPanel& panel, const QTransform& view)
{
    QPolygonF polygon;
    for (const FlatPlace& place : outline) { polygon << pixelOf(place, panel, view); }
    return polygon;
}

} // namespace

std::vector<ZoneOnPanel> zonesOn(const Garment& garment, const GarmentDrawing& drawing)
{
    std::vector<ZoneOnPanel> zones;
    for (const OwnZone& own : garment.wearer.own_zones) {
        const auto at =
            std::find_if(drawing.panels.begin(), drawing.panels.end(), [&own](const DrawnPanel& panel) { return panel.name == own.panel; });
        if (at == drawing.panels.end()) { continue; }
        ZoneOnPanel zone{QString::fromStdString(own.name), static_cast<int>(at - drawing.panels.begin()), {}};
        for (const auto& place : own.outline_mm) { zone.outline.push_back({metre_from_mm(place[0]), metre_from_mm(place[1])}); }
        zones.push_back(std::move(zone));
    }
    return zones;
}

void paintZones(QPainter& painter, const std::vector<ZoneOnPanel>& zones, const GarmentDrawing& drawing, const QTransform& view,
                const QPalette& palette)
{
    const QFontMetricsF metrics(painter.font());
    for (const ZoneOnPanel& zone : zones) {
        if (zone.panel >= static_cast<int>(drawing.panels.size())) { continue; }
        const QPolygonF polygon = pixelsOf(zone.outline, drawing.panels[static_cast<std::size_t>(zone.panel)], view);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(255, 255, 255, 200), 3.5));
        painter.drawPolygon(polygon);
        painter.setPen(QPen(ink, 1.6, Qt::DashLine));
        painter.drawPolygon(polygon);
        const QRectF box = polygon.boundingRect();
        if (box.width() < 4 * metrics.height() || box.height() < 1.5 * metrics.height()) { continue; }
        const QString name = metrics.elidedText(zone.name, Qt::ElideRight, box.width() - 8);
        const QRectF behind(box.center().x() - 0.5 * metrics.horizontalAdvance(name) - 4, box.bottom() - metrics.height() - 4,
                            metrics.horizontalAdvance(name) + 8, metrics.height());
        painter.fillRect(behind, QColor(255, 255, 255, 215)); // as the names of panels
        painter.setPen(ink);
        painter.drawText(behind, Qt::AlignCenter, name);
    }
    painter.setPen(palette.color(QPalette::WindowText));
}

void ZonePen::setDown(bool down)
{
    down_ = down;
    panel_ = -1;
    outline_.clear();
}

bool ZonePen::click(const GarmentSpot& spot, bool on_first)
{
    if (on_first && canClose()) { return true; }
    if (spot.panel < 0 || (panel_ >= 0 && spot.panel != panel_)) { return false; }
    panel_ = spot.panel;
    if (outline_.empty() || outline_.back() != spot.flat) { outline_.push_back(spot.flat); }
    return false;
}

void ZonePen::back()
{
    if (!outline_.empty()) { outline_.pop_back(); }
    if (outline_.empty()) { panel_ = -1; }
}

void ZonePen::paint(QPainter& painter, const GarmentDrawing& drawing, const QTransform& view, const QPointF& pointer) const
{
    if (outline_.empty() || panel_ >= static_cast<int>(drawing.panels.size())) { return; }
    QPolygonF line = pixelsOf(outline_, drawing.panels[static_cast<std::size_t>(panel_)], view);
    const QPolygonF corners = line;
    line << pointer;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 200), 3.5));
    painter.drawPolyline(line);
    painter.setPen(QPen(ink, 1.6));
    painter.drawPolyline(line);
    painter.setBrush(Qt::white);
    for (const QPointF& corner : corners) {
        painter.drawEllipse(corner, corner == corners.front() ? 5 : 3, corner == corners.front() ? 5 : 3);
    }
}

} // namespace hygroloom
