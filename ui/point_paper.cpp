// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/point_paper.h"

#include "ui/appearance.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double margin = 1;

int wrapped(int index, int count)
{
    return ((index % count) + count) % count;
}

} // namespace

PointPaper::PointPaper(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Weave on point paper"));
    setAccessibleDescription(tr("A filled square means the warp end lies over the weft pick. Arrow keys move, Space turns a crossing over."));
    setToolTip("<p>" + accessibleDescription() + "</p>");
}

void PointPaper::setWeave(const Weave& weave)
{
    weave_ = weave;
    cursor_ = {std::min(cursor_.x(), weave.ends() - 1), std::min(cursor_.y(), weave.picks() - 1)};
    update();
}

void PointPaper::setHighlight(int end, int pick)
{
    const QPoint highlight = end < 0 || pick < 0 ? QPoint(-1, -1) : QPoint(wrapped(end, weave_.ends()), wrapped(pick, weave_.picks()));
    if (highlight != highlight_) {
        highlight_ = highlight;
        update();
    }
}

void PointPaper::setSelectedYarn(int end, int pick)
{
    selected_ = {end < 0 ? -1 : wrapped(end, weave_.ends()), pick < 0 ? -1 : wrapped(pick, weave_.picks())};
    update();
}

double PointPaper::cell() const
{
    // The repeat with some of its neighbours, at least eight squares across.
    const double across = std::max({8.0, weave_.ends() + 2.0, weave_.picks() + 2.0});
    return std::clamp(std::floor((std::min(width(), height()) - 2 * margin) / across), 4.0, 24.0);
}

QPointF PointPaper::origin() const
{
    const double c = cell();
    const auto start = [c](double room, int count) { return std::round((room - c * count) / 2); };
    return {start(width(), weave_.ends()), height() - start(height(), weave_.picks())};
}

QPoint PointPaper::crossingAt(const QPointF& at) const
{
    const double c = cell();
    return {static_cast<int>(std::floor((at.x() - origin().x()) / c)), static_cast<int>(std::floor((origin().y() - at.y()) / c))};
}

QRectF PointPaper::squareOf(int end, int pick) const
{
    const double c = cell();
    return {origin().x() + end * c, origin().y() - (pick + 1) * c, c, c};
}

void PointPaper::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QColor ink = palette().color(QPalette::Text);
    QColor pale = ink;
    pale.setAlphaF(0.22F);
    QColor line = ink;
    line.setAlphaF(0.16F);
    painter.fillRect(rect(), palette().color(QPalette::Base));

    const double c = cell();
    const QPoint low = crossingAt(QPointF(0, height()));
    const QPoint high = crossingAt(QPointF(width(), 0));
    for (int end = low.x(); end <= high.x(); ++end) {
        for (int pick = low.y(); pick <= high.y(); ++pick) {
            const bool inRepeat = end >= 0 && end < weave_.ends() && pick >= 0 && pick < weave_.picks();
            if (weave_.warp_up(end, pick)) {
                painter.fillRect(squareOf(end, pick), inRepeat ? ink : pale);
            }
        }
    }
    painter.setPen(QPen(line, 1));
    for (int end = low.x(); end <= high.x() + 1; ++end) {
        const double x = squareOf(end, 0).left() + 0.5;
        painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    }
    for (int pick = low.y(); pick <= high.y() + 1; ++pick) {
        const double y = squareOf(0, pick).bottom() + 0.5;
        painter.drawLine(QPointF(0, y), QPointF(width(), y));
    }

    const QColor accent = palette().color(QPalette::Highlight);
    QColor veil = accent;
    veil.setAlphaF(0.45F);
    for (int end = low.x(); end <= high.x(); ++end) {
        if (selected_.x() >= 0 && wrapped(end, weave_.ends()) == selected_.x()) {
            painter.fillRect(QRectF(squareOf(end, 0).left(), 0, c, height()), veil);
        }
    }
    for (int pick = low.y(); pick <= high.y(); ++pick) {
        if (selected_.y() >= 0 && wrapped(pick, weave_.picks()) == selected_.y()) {
            painter.fillRect(QRectF(0, squareOf(0, pick).top(), width(), c), veil);
        }
    }
    painter.setPen(QPen(accent, 2));
    painter.drawRect(QRectF(squareOf(0, weave_.picks() - 1).topLeft(), squareOf(weave_.ends() - 1, 0).bottomRight()).adjusted(0, 0, 1, 1));
    const auto mark = [&](const QPoint& at, double inset) {
        const QRectF square = squareOf(at.x(), at.y());
        painter.setPen(QPen(weave_.warp_up(at.x(), at.y()) ? palette().color(QPalette::Base) : ink, 3));
        painter.drawRect(square.adjusted(inset, inset, 1 - inset, 1 - inset));
        painter.setPen(QPen(accent, 2));
        painter.drawRect(square.adjusted(inset, inset, 1 - inset, 1 - inset));
    };
    if (highlight_.x() >= 0) {
        mark(highlight_, c * 0.2);
    }
    if (hasFocus()) {
        mark(cursor_, 2);
    }
}

void PointPaper::paintCrossing(const QPoint& at)
{
    last_ = at;
    const QPoint inRepeat(wrapped(at.x(), weave_.ends()), wrapped(at.y(), weave_.picks()));
    cursor_ = inRepeat;
    update();
    if (weave_.warp_up(inRepeat.x(), inRepeat.y()) != paintUp_) {
        Q_EMIT crossingPainted(inRepeat.x(), inRepeat.y(), paintUp_);
    }
}

void PointPaper::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    const QPoint at = crossingAt(event->position());
    painting_ = true;
    paintUp_ = !weave_.warp_up(at.x(), at.y());
    paintCrossing(at);
}

void PointPaper::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint at = crossingAt(event->position());
    if (painting_ && at != last_) {
        paintCrossing(at);
    }
    Q_EMIT crossingHovered(wrapped(at.x(), weave_.ends()), wrapped(at.y(), weave_.picks()));
}

void PointPaper::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && std::exchange(painting_, false)) {
        Q_EMIT strokeEnded();
    }
}

void PointPaper::leaveEvent(QEvent*)
{
    Q_EMIT crossingHovered(-1, -1);
}

void PointPaper::keyPressEvent(QKeyEvent* event)
{
    const auto move = [this](int ends, int picks) {
        cursor_ = {wrapped(cursor_.x() + ends, weave_.ends()), wrapped(cursor_.y() + picks, weave_.picks())};
        update();
    };
    switch (event->key()) {
    case Qt::Key_Left: move(-1, 0); return;
    case Qt::Key_Right: move(1, 0); return;
    case Qt::Key_Up: move(0, 1); return;
    case Qt::Key_Down: move(0, -1); return;
    case Qt::Key_Space:
        paintUp_ = !weave_.warp_up(cursor_.x(), cursor_.y());
        paintCrossing(cursor_);
        Q_EMIT strokeEnded();
        return;
    default: QWidget::keyPressEvent(event);
    }
}

} // namespace hygroloom
