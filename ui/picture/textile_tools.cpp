// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the pointer and the keys do in the picture: turning, moving, choosing, measuring, cutting open.
#include "core/base/units.h"
#include "ui/basics/preferences.h"
#include "ui/picture/framing.h"
#include "ui/picture/textile_canvas.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double click_reach = 4; // pixels that a click may move
constexpr double key_turn = 20;   // pixels of a drag
constexpr double key_zoom = 1.2;

Vec3d metres(const QVector3D& point) { return {metre_from_mm(point.x()), metre_from_mm(point.y()), metre_from_mm(point.z())}; }

QVector3D millimetres(const Vec3d& point)
{
    return {static_cast<float>(mm_from_metre(point.x)), static_cast<float>(mm_from_metre(point.y)),
            static_cast<float>(mm_from_metre(point.z))};
}

} // namespace

void TextileCanvas::mousePressEvent(QMouseEvent* event)
{
    pressed_ = true;
    dragged_ = false;
    pressed_at_ = event->position();
    dragged_from_ = event->position();
    if (takeDrop(*event)) { return; }
    // What was taken hold of stays under the pointer's reach; beside the fabric the middle of the picture does.
    const auto found = hit(event->position());
    pivot_ = found ? millimetres(found->point) : camera_.target();
}

void TextileCanvas::mouseMoveEvent(QMouseEvent* event)
{
    if (!pressed_) {
        hover(event->position());
        return;
    }
    if (!dragged_ && std::hypot(event->position().x() - pressed_at_.x(), event->position().y() - pressed_at_.y()) < click_reach) { return; }
    dragged_ = true;
    if (dragged_drop_ >= 0) {
        dragDrop(event->position());
        return;
    }
    const QPointF pixels = event->position() - dragged_from_;
    dragged_from_ = event->position();
    drag_ = dragOf(event->buttons(), event->modifiers());
    if (drag_ == Drag::none) { return; }
    moved_by_hand_ = true;
    if (drag_ == Drag::pan) {
        camera_.pan(pixels, QSizeF(size()));
    } else {
        camera_.orbit(pixels, pivot_);
    }
    redraw(true);
}

void TextileCanvas::mouseReleaseEvent(QMouseEvent* event)
{
    if (dragged_drop_ >= 0) {
        if (event->button() == Qt::LeftButton) { dropDrop(); }
    } else if (pressed_ && !dragged_ && event->button() == Qt::LeftButton) {
        click(event->position());
    }
    pressed_ = event->buttons() != Qt::NoButton;
    drag_ = Drag::none;
    if (moving_) { redraw(false); }
}

void TextileCanvas::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (drops_editable_ && !measuring_ && !placing_) {
        const auto point = dropAt(event->position()) < 0 ? pointUnder(event->position()) : std::nullopt;
        if (point && event->button() == Qt::LeftButton) { Q_EMIT dropAdded(snapped({point->x(), point->y()}, -1).at); }
        return;
    }
    const auto found = hit(event->position());
    if (found && !measuring_ && !placing_) {
        camera_.centreOn(millimetres(found->point));
        moved_by_hand_ = true;
        redraw(false);
    }
}

void TextileCanvas::wheelEvent(QWheelEvent* event)
{
    zoomAt(wheelZoom(event->angleDelta().y()), zoomedAt(event->position(), QSizeF(size())));
}

void TextileCanvas::zoomBy(double factor) { zoomAt(factor, QPointF(0.5 * width(), 0.5 * height())); }

/// To what is there; beside the cloth, and through its gaps, to the cloth nearest to it.
void TextileCanvas::zoomAt(double factor, const QPointF& at)
{
    moved_by_hand_ = true;
    if (const auto found = hit(at)) {
        camera_.zoomTo(factor, millimetres(found->point));
    } else if (fabric()) {
        camera_ = zoomed_to_cloth(camera_, *fabric(), cut(), factor, at, QSizeF(size()));
    } else {
        camera_.zoom(factor, at, QSizeF(size()));
    }
    redraw(true);
}

void TextileCanvas::turnBy(const QPointF& pixels)
{
    moved_by_hand_ = true;
    camera_.orbit(pixels, camera_.target());
    redraw(true);
}

void TextileCanvas::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left: turnBy({-key_turn, 0}); return;
    case Qt::Key_Right: turnBy({key_turn, 0}); return;
    case Qt::Key_Up: turnBy({0, -key_turn}); return;
    case Qt::Key_Down: turnBy({0, key_turn}); return;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomBy(key_zoom); return;
    case Qt::Key_Minus: zoomBy(1 / key_zoom); return;
    case Qt::Key_Return:
    case Qt::Key_Enter: click(QPointF(0.5 * width(), 0.5 * height())); return; // what lies in the middle
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (drops_editable_ && chosen_drop_ >= 0 && dragged_drop_ < 0) { Q_EMIT dropRemoved(chosen_drop_); }
        return;
    case Qt::Key_Escape:
        if (dragged_drop_ >= 0) {
            putDropBack();
        } else if (measuring_ && !measured_.empty()) {
            measured_.clear();
            update();
        } else if (measuring_) {
            setMeasuring(false);
            Q_EMIT measuringEnded();
        } else if (placing_) {
            setPlacing(false);
            Q_EMIT placingEnded();
        } else {
            select({});
        }
        return;
    default: QOpenGLWidget::keyPressEvent(event);
    }
}

std::optional<CutPlane> TextileCanvas::cut() const
{
    const double side = section_.flipped ? -1 : 1;
    const double at = metre_from_mm(section_.position);
    switch (section_.across) {
    case SectionPlane::Across::warp: return CutPlane{{0, -side, 0}, -side * at};
    case SectionPlane::Across::weft: return CutPlane{{-side, 0, 0}, -side * at};
    case SectionPlane::Across::thickness: return CutPlane{{0, 0, side}, side * at};
    case SectionPlane::Across::nothing: break;
    }
    return std::nullopt;
}

void TextileCanvas::setSection(const SectionPlane& section)
{
    if (section != section_) {
        section_ = section;
        redraw(true);
    }
}

std::optional<YarnHit> TextileCanvas::hit(const QPointF& at) const
{
    if (!fabric() || !rect().contains(at.toPoint())) { return std::nullopt; }
    const Ray ray = camera_.ray(at, QSizeF(size()));
    return first_skin(fabric()->textile, metres(ray.from), {ray.direction.x(), ray.direction.y(), ray.direction.z()}, cut());
}

void TextileCanvas::click(const QPointF& at)
{
    if (placing_) {
        if (const auto point = pointUnder(at)) { Q_EMIT placed({point->x(), point->y()}); }
        return;
    }
    const auto found = hit(at);
    if (!measuring_) {
        select(found ? YarnNumber{found->place.kind, found->place.yarn} : YarnNumber{});
        return;
    }
    if (!found) { return; }
    if (measured_.size() == 2) { measured_.clear(); }
    measured_.push_back(millimetres(measure_on_axes_ ? axis_point(fabric()->textile, found->place) : found->point));
    update();
    if (measured_.size() == 2) { Q_EMIT measured(); }
}

void TextileCanvas::setMeasuring(bool measuring)
{
    measuring_ = measuring;
    measured_.clear();
    setCursor(measuring ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

void TextileCanvas::setPlacing(bool placing)
{
    placing_ = placing;
    setCursor(placing ? Qt::CrossCursor : Qt::ArrowCursor);
}

std::optional<Measurement> TextileCanvas::measurement() const
{
    return measured_.size() == 2 ? std::optional(Measurement{measured_[0], measured_[1]}) : std::nullopt;
}

void TextileCanvas::select(const YarnNumber& yarn)
{
    if (yarn == selected_ || (yarn.yarn < 0 && selected_.yarn < 0)) { return; }
    selected_ = yarn;
    redraw(false);
    Q_EMIT yarnSelected(selected_);
}

void TextileCanvas::selectNext(int step)
{
    if (!fabric()) { return; }
    const Textile& textile = fabric()->textile;
    if (selected_.yarn < 0) {
        const double end = (camera_.target().x() - fabric()->low().x()) / fabric()->pitch().x();
        select({YarnKind::warp, std::clamp(static_cast<int>(end), 0, textile.ends() - 1)});
        return;
    }
    // After the last end come the picks.
    const int all = textile.ends() + textile.picks();
    const int number = (selected_.kind == YarnKind::warp ? 0 : textile.ends()) + selected_.yarn;
    const int next = (number + step + all) % all;
    select(next < textile.ends() ? YarnNumber{YarnKind::warp, next} : YarnNumber{YarnKind::weft, next - textile.ends()});
}

void TextileCanvas::zoomToSelection()
{
    if (!fabric() || selected_.yarn < 0) { return; }
    // A few crossings of the yarn, those nearest to what is looked at.
    constexpr int shown = 7;
    const bool is_warp = selected_.kind == YarnKind::warp;
    const Textile& textile = fabric()->textile;
    const QVector3D from_low = camera_.target() - fabric()->low();
    const QVector3D pitch = fabric()->pitch();
    const int crossings = is_warp ? textile.picks() : textile.ends();
    const int middle = static_cast<int>(is_warp ? from_low.y() / pitch.y() : from_low.x() / pitch.x());
    const int first = std::clamp(middle - shown / 2, 0, std::max(0, crossings - shown));
    const TextileRegion part = is_warp ? TextileRegion{selected_.yarn, first, 1, std::min(shown, crossings)}
                                       : TextileRegion{first, selected_.yarn, std::min(shown, crossings), 1};
    camera_.showFace();
    camera_.fit(fabric()->low(part), fabric()->high(part), QSizeF(size()));
    moved_by_hand_ = true;
    redraw(false);
}

/// On the plane of the face that is seen, also beside the cloth.
std::optional<QVector3D> TextileCanvas::onPlane(const QPointF& at) const
{
    if (!fabric()) { return std::nullopt; }
    const Ray ray = camera_.ray(at, QSizeF(size()));
    const QVector3D low = fabric()->low(), high = fabric()->high();
    const float surface = 0.5F * (camera_.direction().z() >= 0 ? high.z() : low.z());
    if (std::abs(ray.direction.z()) < 1e-3F) { return std::nullopt; }
    const float along = (surface - ray.from.z()) / ray.direction.z();
    return along < 0 ? std::nullopt : std::optional(ray.from + along * ray.direction);
}

std::optional<QVector3D> TextileCanvas::pointUnder(const QPointF& at) const
{
    const auto point = rect().contains(at.toPoint()) ? onPlane(at) : std::nullopt;
    if (!point) { return std::nullopt; }
    const QVector3D low = fabric()->low(), high = fabric()->high();
    const bool on_cloth = point->x() >= low.x() && point->x() <= high.x() && point->y() >= low.y() && point->y() <= high.y();
    return on_cloth ? point : std::nullopt;
}

void TextileCanvas::hover(const QPointF& at)
{
    pointer_ = at;
    if (drops_editable_ && !measuring_ && !placing_) { setCursor(dropAt(at) >= 0 ? Qt::SizeAllCursor : Qt::ArrowCursor); }
    QPoint found(-1, -1);
    if (const auto point = pointUnder(at)) {
        const QVector3D from_low = *point - fabric()->low();
        const int end = static_cast<int>(from_low.x() / fabric()->pitch().x());
        const int pick = static_cast<int>(from_low.y() / fabric()->pitch().y());
        found = {std::clamp(end, 0, fabric()->textile.ends() - 1), std::clamp(pick, 0, fabric()->textile.picks() - 1)};
    }
    if (found != hovered_) {
        hovered_ = found;
        Q_EMIT crossingHovered(found.x(), found.y());
    }
    update();
}

} // namespace hygroloom
