// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Drops on the cloth: their markers are drawn, taken hold of, dragged with snapping, added and deleted.
#include "ui/basics/quantity.h"
#include "ui/picture/textile_canvas.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hygroloom {

namespace {

constexpr double marker_reach = 11; // pixels from a marker's middle
constexpr double snap_reach = 7;    // pixels from a line that it snaps to
constexpr double step = 0.1;        // mm, between the places of drops

} // namespace

void TextileCanvas::setDrops(std::vector<QPointF> drops, int chosen)
{
    if (dragged_drop_ >= static_cast<int>(drops.size())) { dragged_drop_ = -1; }
    if (dragged_drop_ >= 0) { drops[static_cast<std::size_t>(dragged_drop_)] = drops_[static_cast<std::size_t>(dragged_drop_)]; }
    drops_ = std::move(drops);
    chosen_drop_ = chosen;
    update();
}

void TextileCanvas::setDropsEditable(bool editable)
{
    drops_editable_ = editable;
    if (!editable) { dragged_drop_ = -1; }
}

QPointF TextileCanvas::markerOf(const QPointF& drop) const
{
    return camera_.project({static_cast<float>(drop.x()), static_cast<float>(drop.y()), 0.5F * fabric()->pitch().z()}, QSizeF(size()));
}

int TextileCanvas::dropAt(const QPointF& at) const
{
    int found = -1;
    double nearest = marker_reach;
    if (!drops_editable_ || measuring_ || !fabric()) { return found; }
    for (std::size_t i = 0; i < drops_.size(); ++i) {
        const QPointF away = markerOf(drops_[i]) - at;
        const double distance = std::hypot(away.x(), away.y());
        // Of markers that cover each other the chosen one is on top.
        if (distance < nearest || (distance < marker_reach && static_cast<int>(i) == chosen_drop_)) {
            found = static_cast<int>(i);
            nearest = found == chosen_drop_ ? 0 : distance;
        }
    }
    return found;
}

/// The place on the cloth's plane, drawn to the sample's middle and to the lines of other drops where it is near them.
DropSnap TextileCanvas::snapped(const QPointF& place, int but) const
{
    DropSnap snap;
    snap.at = {step * std::round(place.x() / step), step * std::round(place.y() / step)};
    const double reach = snap_reach * camera_.millimetrePerPixel(QSizeF(size()));
    std::vector<QPointF> to{{0, 0}};
    for (std::size_t i = 0; i < drops_.size(); ++i) {
        if (static_cast<int>(i) != but) { to.push_back(drops_[i]); }
    }
    double nearest_x = reach, nearest_y = reach;
    for (const QPointF& other : to) {
        if (const double away = std::abs(place.x() - other.x()); away < nearest_x) {
            nearest_x = away;
            snap.at.setX(other.x());
            snap.on_x = true;
        }
        if (const double away = std::abs(place.y() - other.y()); away < nearest_y) {
            nearest_y = away;
            snap.at.setY(other.y());
            snap.on_y = true;
        }
    }
    return snap;
}

/// True when the press took hold of a marker: the camera then keeps still.
bool TextileCanvas::takeDrop(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton || event.modifiers() & Qt::ShiftModifier) { return false; }
    dragged_drop_ = dropAt(event.position());
    if (dragged_drop_ < 0) { return false; }
    drop_before_ = drops_[static_cast<std::size_t>(dragged_drop_)];
    chosen_drop_ = dragged_drop_;
    snap_ = {drop_before_, false, false};
    Q_EMIT dropChosen(dragged_drop_);
    update();
    return true;
}

/// Beside the cloth it stays on its edge.
void TextileCanvas::dragDrop(const QPointF& at)
{
    const auto point = onPlane(at);
    if (!point) { return; }
    const QVector3D low = fabric()->low(), high = fabric()->high();
    const auto onCloth = [&](const QPointF& place) {
        return QPointF(std::clamp<double>(place.x(), low.x(), high.x()), std::clamp<double>(place.y(), low.y(), high.y()));
    };
    snap_ = snapped(onCloth({point->x(), point->y()}), dragged_drop_);
    snap_.at = onCloth(snap_.at); // rounding may have left it
    drops_[static_cast<std::size_t>(dragged_drop_)] = snap_.at;
    update();
}

void TextileCanvas::dropDrop()
{
    const int drop = std::exchange(dragged_drop_, -1);
    const QPointF at = drops_[static_cast<std::size_t>(drop)];
    update();
    if (at != drop_before_) { Q_EMIT dropMoved(drop, at); }
}

void TextileCanvas::putDropBack()
{
    drops_[static_cast<std::size_t>(std::exchange(dragged_drop_, -1))] = drop_before_;
    update();
}

void TextileCanvas::drawDrops(QPainter& painter)
{
    if (dragged_drop_ >= 0) { drawSnap(painter); }
    for (std::size_t i = 0; i < drops_.size(); ++i) {
        const bool chosen = static_cast<int>(i) == chosen_drop_;
        const double radius = chosen ? 8 : 6;
        const QPointF at = markerOf(drops_[i]);
        painter.setPen(QPen(colors().background, chosen ? 6 : 4));
        painter.drawEllipse(at, radius, radius);
        painter.setPen(QPen(palette().color(QPalette::Highlight), chosen ? 3 : 2));
        painter.drawEllipse(at, radius, radius);
    }
}

/// The lines that the dragged drop has snapped to, and where it is.
void TextileCanvas::drawSnap(QPainter& painter)
{
    const QVector3D low = fabric()->low(), high = fabric()->high();
    const QPointF at = snap_.at;
    const auto line = [&](const QPointF& from, const QPointF& to) {
        painter.setPen(QPen(colors().background, 3));
        painter.drawLine(markerOf(from), markerOf(to));
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5, Qt::DashLine));
        painter.drawLine(markerOf(from), markerOf(to));
    };
    if (snap_.on_x) { line({at.x(), low.y()}, {at.x(), high.y()}); }
    if (snap_.on_y) { line({low.x(), at.y()}, {high.x(), at.y()}); }
    const QString text = tr("weft %1 mm, warp %2 mm").arg(shownNumber(at.x(), 1), shownNumber(at.y(), 1));
    const QFontMetricsF metrics(painter.font());
    QRectF plate(markerOf(at) + QPointF(14, -metrics.height() - 14), QSizeF(metrics.horizontalAdvance(text) + 16, metrics.height() + 8));
    plate.moveLeft(std::clamp(plate.left(), 4.0, std::max(4.0, width() - plate.width() - 4)));
    plate.moveTop(std::max(plate.top(), 4.0));
    QColor base = palette().color(QPalette::Base);
    base.setAlphaF(0.86F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(base);
    painter.drawRoundedRect(plate, 4, 4);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(plate, Qt::AlignCenter, text);
}

} // namespace hygroloom
