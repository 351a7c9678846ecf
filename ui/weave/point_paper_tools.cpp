// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What mouse and keys do on point paper.
#include "ui/weave/point_paper.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

QRect between(const QPoint& a, const QPoint& b)
{
    return {QPoint(std::min(a.x(), b.x()), std::min(a.y(), b.y())), QPoint(std::max(a.x(), b.x()), std::max(a.y(), b.y()))};
}

/// A larger repeat takes too long to check and to draw anew while the mouse is down; it is painted when the stroke ends.
constexpr int most_followed_crossings = 250000;

} // namespace

void PointPaper::setTool(PaperTool tool)
{
    tool_ = tool;
    anchored_ = false;
    pending_.clear();
    viewport()->setCursor(tool == PaperTool::select ? Qt::CrossCursor : Qt::ArrowCursor);
    viewport()->update();
}

void PointPaper::drawShape(const QPoint& to)
{
    pending_ = tool_ == PaperTool::line ? lineOf(anchor_, to) : areaOf(between(anchor_, to));
    viewport()->update();
}

void PointPaper::brush(const Crossings& crossings)
{
    if (weave_.ends() * weave_.picks() <= most_followed_crossings) {
        Q_EMIT painted(crossings, paintUp_);
        return;
    }
    pending_ += crossings;
    viewport()->update();
}

void PointPaper::begin(const QPoint& at)
{
    anchor_ = last_ = at;
    cursor_ = inRepeat(at);
    paintUp_ = !weave_.warp_up(at.x(), at.y());
    drawing_ = true;
    switch (tool_) {
    case PaperTool::brush: brush({at}); break;
    case PaperTool::fill: Q_EMIT painted(floodOf(weave_, at), paintUp_); break;
    case PaperTool::select:
        anchor_ = nearestInRepeat(at);
        setSelection(between(anchor_, anchor_));
        break;
    case PaperTool::line:
    case PaperTool::rectangle: drawShape(at); break;
    }
    viewport()->update();
}

void PointPaper::goOn(const QPoint& at)
{
    switch (tool_) {
    case PaperTool::brush:
        cursor_ = inRepeat(at);
        brush(lineOf(last_, at));
        break;
    case PaperTool::line:
    case PaperTool::rectangle: drawShape(at); break;
    case PaperTool::select: setSelection(between(anchor_, nearestInRepeat(at))); break;
    case PaperTool::fill: break;
    }
    last_ = at;
}

void PointPaper::finish()
{
    drawing_ = false;
    anchored_ = false;
    if (const Crossings drawn = std::exchange(pending_, {}); !drawn.isEmpty()) {
        Q_EMIT painted(drawn, paintUp_);
    } else if (tool_ == PaperTool::select && selection_.size() == QSize(1, 1) && anchor_ == last_) {
        setSelection({}); // a click takes the selection away
    }
    viewport()->update();
    Q_EMIT strokeEnded();
}

void PointPaper::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) { begin(crossingAt(event->position())); }
}

void PointPaper::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint at = crossingAt(event->position());
    if (drawing_ && at != last_) { goOn(at); }
    const QPoint here = inRepeat(at);
    Q_EMIT crossingHovered(here.x(), here.y());
}

void PointPaper::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && drawing_) { finish(); }
}

bool PointPaper::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::Leave) { Q_EMIT crossingHovered(-1, -1); }
    return QAbstractScrollArea::viewportEvent(event);
}

void PointPaper::wheelEvent(QWheelEvent* event)
{
    if (event->modifiers() & Qt::ControlModifier) {
        zoomAt(cell() * std::pow(1.25, event->angleDelta().y() / 120.0), event->position());
        event->accept();
        return;
    }
    QAbstractScrollArea::wheelEvent(event);
}

void PointPaper::useToolAtCursor()
{
    const bool shape = tool_ == PaperTool::line || tool_ == PaperTool::rectangle || tool_ == PaperTool::select;
    if (shape && !anchored_) {
        begin(cursor_);
        drawing_ = false;
        anchored_ = true;
        return;
    }
    if (!shape) { begin(cursor_); }
    finish();
}

void PointPaper::keyPressEvent(QKeyEvent* event)
{
    const auto move = [&](int ends, int picks) {
        const bool selecting = event->modifiers() & Qt::ShiftModifier;
        if (selecting && selection_.isEmpty()) { anchor_ = cursor_; }
        const QPoint to = cursor_ + QPoint(ends, picks);
        cursor_ = selecting || anchored_ ? nearestInRepeat(to) : inRepeat(to);
        if (selecting) {
            setSelection(between(anchor_, cursor_));
        } else if (anchored_ && cursor_ != last_) {
            goOn(cursor_);
        }
        showCursor();
    };
    switch (event->key()) {
    case Qt::Key_Left: move(-1, 0); return;
    case Qt::Key_Right: move(1, 0); return;
    case Qt::Key_Up: move(0, 1); return;
    case Qt::Key_Down: move(0, -1); return;
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter: useToolAtCursor(); return;
    case Qt::Key_Escape:
        if (anchored_ || drawing_ || !selection_.isEmpty()) {
            anchored_ = drawing_ = false;
            pending_.clear();
            setSelection({});
            viewport()->update();
            return;
        }
        break;
    default: break;
    }
    QAbstractScrollArea::keyPressEvent(event);
}

void PointPaper::focusInEvent(QFocusEvent* event)
{
    QAbstractScrollArea::focusInEvent(event);
    viewport()->update();
}

void PointPaper::focusOutEvent(QFocusEvent* event)
{
    QAbstractScrollArea::focusOutEvent(event);
    viewport()->update();
}

} // namespace hygroloom
