// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How point paper looks and scrolls; point_paper_tools.cpp has what mouse and keys do.
#include "ui/weave/point_paper.h"

#include "ui/basics/appearance.h"

#include <QPainter>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double least_cell = 1, largest_cell = 48;
constexpr double least_lined_cell = 4; // smaller squares have no lines between them

} // namespace

PointPaper::PointPaper(QWidget* parent) : QAbstractScrollArea(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    viewport()->setMouseTracking(true);
    setAccessibleName(tr("Weave on point paper"));
    setAccessibleDescription(
        tr("A filled square means the warp end lies over the weft pick. Arrow keys move, with Shift they select, Space uses the tool."));
    viewport()->setToolTip("<p>" + accessibleDescription() + "</p>");
    horizontalScrollBar()->setAccessibleName(tr("Scroll along the picks"));
    verticalScrollBar()->setAccessibleName(tr("Scroll along the ends"));
}

void PointPaper::setWeave(const Weave& weave)
{
    const bool otherSize = weave.ends() != weave_.ends() || weave.picks() != weave_.picks();
    weave_ = weave;
    cursor_ = nearestInRepeat(cursor_);
    updateScrollBars();
    if (otherSize) {
        setSelection({});
        verticalScrollBar()->setValue(verticalScrollBar()->maximum());
    }
    viewport()->update();
}

void PointPaper::setHighlight(int end, int pick)
{
    const QPoint highlight = end < 0 || pick < 0 ? QPoint(-1, -1) : inRepeat({end, pick});
    if (highlight != highlight_) {
        highlight_ = highlight;
        viewport()->update();
    }
}

void PointPaper::setSelectedYarn(int end, int pick)
{
    selected_ = {end < 0 ? -1 : wrapped(end, weave_.ends()), pick < 0 ? -1 : wrapped(pick, weave_.picks())};
    viewport()->update();
}

void PointPaper::setSelection(const QRect& selection)
{
    const QRect inside = selection & QRect(0, 0, weave_.ends(), weave_.picks());
    if (inside != selection_) {
        selection_ = inside;
        viewport()->update();
        Q_EMIT selectionChanged();
    }
}

double PointPaper::fittingCell() const
{
    // The repeat with some of its neighbours, at least eight squares across.
    const double across = std::max({8.0, weave_.ends() + 2.0, weave_.picks() + 2.0});
    return std::clamp(std::floor(std::min(viewport()->width(), viewport()->height()) / across), 4.0, 24.0);
}

double PointPaper::cell() const { return zoom_ > 0 ? zoom_ : fittingCell(); }

QSizeF PointPaper::contentSize() const { return QSizeF(weave_.ends() + 2, weave_.picks() + 2) * cell(); }

QPointF PointPaper::origin() const
{
    const double c = cell();
    const QSizeF content = contentSize();
    const double room_x = viewport()->width(), room_y = viewport()->height();
    return {content.width() > room_x ? c - horizontalScrollBar()->value() : std::round((room_x - c * weave_.ends()) / 2),
            content.height() > room_y ? content.height() - c - verticalScrollBar()->value()
                                      : room_y - std::round((room_y - c * weave_.picks()) / 2)};
}

QPoint PointPaper::crossingAt(const QPointF& at) const
{
    const double c = cell();
    return {static_cast<int>(std::floor((at.x() - origin().x()) / c)), static_cast<int>(std::floor((origin().y() - at.y()) / c))};
}

QPoint PointPaper::inRepeat(const QPoint& at) const { return {wrapped(at.x(), weave_.ends()), wrapped(at.y(), weave_.picks())}; }

QPoint PointPaper::nearestInRepeat(const QPoint& at) const
{
    return {std::clamp(at.x(), 0, weave_.ends() - 1), std::clamp(at.y(), 0, weave_.picks() - 1)};
}

QRectF PointPaper::squareOf(int end, int pick) const
{
    const double c = cell();
    return {origin().x() + end * c, origin().y() - (pick + 1) * c, c, c};
}

void PointPaper::updateScrollBars()
{
    const QSizeF content = contentSize();
    const auto set = [&](QScrollBar* bar, double whole, int room) {
        bar->setRange(0, std::max(0, static_cast<int>(std::ceil(whole)) - room));
        bar->setPageStep(room);
        bar->setSingleStep(static_cast<int>(std::ceil(cell())));
    };
    set(horizontalScrollBar(), content.width(), viewport()->width());
    set(verticalScrollBar(), content.height(), viewport()->height());
}

void PointPaper::zoomBy(double factor) { zoomAt(cell() * factor, QRectF(viewport()->rect()).center()); }

void PointPaper::zoomToFit()
{
    zoom_ = 0;
    updateScrollBars();
    verticalScrollBar()->setValue(verticalScrollBar()->maximum());
    viewport()->update();
}

void PointPaper::zoomAt(double cell, const QPointF& at)
{
    const QPointF before = (at - origin()) / this->cell();
    const double size = std::clamp(std::round(cell), least_cell, largest_cell);
    zoom_ = size == this->cell() ? this->cell() + (cell > size ? 1 : cell < size ? -1 : 0) : size;
    zoom_ = std::clamp(zoom_, least_cell, largest_cell);
    updateScrollBars();
    const QPointF off = origin() + before * zoom_ - at;
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() + qRound(off.x()));
    verticalScrollBar()->setValue(verticalScrollBar()->value() + qRound(off.y()));
    viewport()->update();
}

void PointPaper::showCursor()
{
    const QRectF square = squareOf(cursor_.x(), cursor_.y());
    const auto reveal = [](QScrollBar* bar, double low, double high, int room) {
        bar->setValue(bar->value() + qRound(std::min(0.0, low) + std::max(0.0, high - room)));
    };
    reveal(horizontalScrollBar(), square.left(), square.right(), viewport()->width());
    reveal(verticalScrollBar(), square.top(), square.bottom(), viewport()->height());
    viewport()->update();
}

void PointPaper::resizeEvent(QResizeEvent*)
{
    const bool atBottom = verticalScrollBar()->value() == verticalScrollBar()->maximum();
    updateScrollBars();
    if (atBottom) { verticalScrollBar()->setValue(verticalScrollBar()->maximum()); }
}

QImage PointPaper::squares(const QPoint& low, const QPoint& high) const
{
    const QColor ink = paperColors(palette()).ink;
    QColor pale = ink;
    pale.setAlphaF(0.22F);
    const QRgb full = qPremultiply(ink.rgba()), light = qPremultiply(pale.rgba());
    QImage image(high.x() - low.x() + 1, high.y() - low.y() + 1, QImage::Format_ARGB32_Premultiplied);
    for (int pick = low.y(); pick <= high.y(); ++pick) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(high.y() - pick));
        for (int end = low.x(); end <= high.x(); ++end) {
            const bool inside = end >= 0 && end < weave_.ends() && pick >= 0 && pick < weave_.picks();
            line[end - low.x()] = !weave_.warp_up(end, pick) ? 0 : inside ? full : light;
        }
    }
    return image;
}

void PointPaper::paintEvent(QPaintEvent*)
{
    QPainter painter(viewport());
    const int width = viewport()->width(), height = viewport()->height();
    const auto [paper, ink, accent] = paperColors(palette());
    QColor line = ink;
    line.setAlphaF(0.16F);
    painter.fillRect(viewport()->rect(), paper);

    const double c = cell();
    const QPoint low = crossingAt(QPointF(0, height)), high = crossingAt(QPointF(width, 0));
    const QRectF shown(squareOf(low.x(), high.y()).topLeft(), squareOf(high.x(), low.y()).bottomRight());
    painter.drawImage(shown, squares(low, high));
    painter.setPen(QPen(line, 1));
    for (int end = low.x(); c >= least_lined_cell && end <= high.x() + 1; ++end) {
        const double x = squareOf(end, 0).left() + 0.5;
        painter.drawLine(QPointF(x, 0), QPointF(x, height));
    }
    for (int pick = low.y(); c >= least_lined_cell && pick <= high.y() + 1; ++pick) {
        const double y = squareOf(0, pick).bottom() + 0.5;
        painter.drawLine(QPointF(0, y), QPointF(width, y));
    }

    QColor veil = accent;
    veil.setAlphaF(0.45F);
    for (int end = low.x(); selected_.x() >= 0 && end <= high.x(); ++end) {
        if (wrapped(end, weave_.ends()) == selected_.x()) { painter.fillRect(QRectF(squareOf(end, 0).left(), 0, c, height), veil); }
    }
    for (int pick = low.y(); selected_.y() >= 0 && pick <= high.y(); ++pick) {
        if (wrapped(pick, weave_.picks()) == selected_.y()) { painter.fillRect(QRectF(0, squareOf(0, pick).top(), width, c), veil); }
    }
    for (const QPoint& at : pending_) {
        painter.fillRect(squareOf(at.x(), at.y()), paintUp_ ? ink : paper);
        painter.fillRect(squareOf(at.x(), at.y()), veil);
    }
    const auto frame = [&](const QRect& area) {
        return QRectF(squareOf(area.left(), area.bottom()).topLeft(), squareOf(area.right(), area.top()).bottomRight())
            .adjusted(0, 0, 1, 1);
    };
    painter.setPen(QPen(accent, 2));
    painter.drawRect(frame({0, 0, weave_.ends(), weave_.picks()}));
    if (!selection_.isEmpty()) {
        QColor light = accent;
        light.setAlphaF(0.2F);
        painter.fillRect(frame(selection_), light);
        painter.setPen(QPen(paper, 3));
        painter.drawRect(frame(selection_));
        painter.setPen(QPen(accent, 2, Qt::DashLine));
        painter.drawRect(frame(selection_));
    }
    const auto mark = [&](const QPoint& at, double inset) {
        const QRectF square = squareOf(at.x(), at.y());
        painter.setPen(QPen(weave_.warp_up(at.x(), at.y()) ? paper : ink, 3));
        painter.drawRect(square.adjusted(inset, inset, 1 - inset, 1 - inset));
        painter.setPen(QPen(accent, 2));
        painter.drawRect(square.adjusted(inset, inset, 1 - inset, 1 - inset));
    };
    if (highlight_.x() >= 0 && c >= least_lined_cell) { mark(highlight_, c * 0.2); }
    if (hasFocus()) { mark(cursor_, c >= 8 ? 2 : 0); }
}

} // namespace hygroloom
