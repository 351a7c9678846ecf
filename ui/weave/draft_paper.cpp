// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave/draft_paper.h"

#include "ui/basics/appearance.h"
#include "ui/weave/cloth_picture.h"
#include "ui/weave/weave_edits.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int margin = 8, gap = 6, bar = 12;
constexpr double most_of_room = 0.4; // for threading in height, for treadling in width
constexpr DraftPart parts[] = {DraftPart::drawdown,  DraftPart::threading, DraftPart::tieUp,
                               DraftPart::treadling, DraftPart::warpBar,   DraftPart::weftBar};

std::vector<std::vector<bool>> table(const std::vector<std::vector<int>>& lists, int columns)
{
    std::vector<std::vector<bool>> marks(lists.size(), std::vector<bool>(static_cast<std::size_t>(std::max(columns, 0))));
    for (std::size_t i = 0; i < lists.size(); ++i) {
        for (const int one : lists[i]) { marks[i][static_cast<std::size_t>(one)] = true; }
    }
    return marks;
}

} // namespace

DraftPaper::DraftPaper(QWidget* parent) : QAbstractScrollArea(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Draft"));
    setAccessibleDescription(
        tr("Threading above, treadling on the right, tie-up in the corner, yarns along both edges. Click or drag to change; with Ctrl a "
           "second shaft or treadle is added. Arrow keys move, Space changes."));
    horizontalScrollBar()->setAccessibleName(tr("Scroll along the picks"));
    verticalScrollBar()->setAccessibleName(tr("Scroll along the ends"));
}

void DraftPaper::setDraft(const Fabric& fabric, const Draft& draft)
{
    const QSize before = cells(DraftPart::drawdown);
    fabric_ = fabric;
    draft_ = draft;
    threaded_ = table(draft.threading, draft.shafts);
    tied_ = table(draft.tie_up, draft.shafts);
    pressed_ = draft.liftplan.empty() ? table(draft.treadling, draft.treadles) : table(draft.liftplan, draft.shafts);
    warp_yarns_ = threadYarns(fabric, true, cells(DraftPart::drawdown).width());
    weft_yarns_ = threadYarns(fabric, false, cells(DraftPart::drawdown).height());
    fitCells();
    first_shaft_ = std::clamp(first_shaft_, 0, std::max(0, draft.shafts - shownShafts()));
    first_treadle_ = std::clamp(first_treadle_, 0, std::max(0, cells(DraftPart::treadling).width() - shownTreadles()));
    const QSize size = cells(cursor_part_);
    cursor_ = size.isEmpty() ? QPoint() : QPoint(std::min(cursor_.x(), size.width() - 1), std::min(cursor_.y(), size.height() - 1));
    if (size.isEmpty()) { cursor_part_ = DraftPart::drawdown; }
    updateScrollBars();
    if (before != cells(DraftPart::drawdown)) { verticalScrollBar()->setValue(verticalScrollBar()->maximum()); }
    viewport()->update();
}

void DraftPaper::setColored(bool colored)
{
    colored_ = colored;
    viewport()->update();
}

void DraftPaper::fitCells()
{
    if (!zoomed_) {
        const QSize cloth = cells(DraftPart::drawdown);
        const int across = cloth.width() + cells(DraftPart::treadling).width(), up = cloth.height() + draft_.shafts;
        const int room = 2 * (margin + gap) + bar;
        cell_ = std::clamp(std::min((viewport()->width() - room) / std::max(1, across), (viewport()->height() - room) / std::max(1, up)),
                           10, 28);
    }
}

void DraftPaper::zoomBy(double factor)
{
    zoomed_ = true;
    const int size = static_cast<int>(std::lround(cell_ * factor));
    cell_ = std::clamp(size == cell_ ? cell_ + (factor > 1 ? 1 : -1) : size, 3, 40);
    updateScrollBars();
    verticalScrollBar()->setValue(verticalScrollBar()->maximum());
    viewport()->update();
}

QSize DraftPaper::cells(DraftPart part) const
{
    const int ends = std::max(fabric_.weave.ends(), std::min(orderPeriod(fabric_, true), largest_repeat));
    const int picks = std::max(fabric_.weave.picks(), std::min(orderPeriod(fabric_, false), largest_repeat));
    const int columns = draft_.liftplan.empty() ? draft_.treadles : draft_.shafts;
    switch (part) {
    case DraftPart::drawdown: return {ends, picks};
    case DraftPart::threading: return {ends, draft_.shafts};
    case DraftPart::tieUp: return {draft_.liftplan.empty() ? columns : 0, draft_.shafts};
    case DraftPart::treadling: return {columns, picks};
    case DraftPart::warpBar: return {ends, 1};
    case DraftPart::weftBar: return {1, picks};
    }
    return {};
}

int DraftPaper::shownShafts() const
{
    // All of them where the drawdown keeps a few picks; else a share of the height.
    const int few = std::min(cells(DraftPart::drawdown).height(), 4) * cell_;
    const double room = std::max(viewport()->height() * most_of_room, 1.0 * viewport()->height() - 2 * (margin + gap) - bar - few);
    return std::max(1, std::min(draft_.shafts, static_cast<int>(room / cell_)));
}

int DraftPaper::shownTreadles() const
{
    return std::max(1, std::min(cells(DraftPart::treadling).width(), static_cast<int>(viewport()->width() * most_of_room / cell_)));
}

QRectF DraftPaper::areaOf(DraftPart part) const
{
    const QSize size = cells(DraftPart::drawdown);
    const double above = shownShafts() * cell_, beside = shownTreadles() * cell_;
    const double top = margin + bar + gap + above + gap;
    const double width =
        std::max<double>(cell_, std::min<double>(size.width() * cell_, viewport()->width() - 2 * margin - beside - 2 * gap - bar));
    const double height = std::max<double>(cell_, std::min<double>(size.height() * cell_, viewport()->height() - margin - top));
    const double right = margin + width + gap;
    switch (part) {
    case DraftPart::drawdown: return {margin, top, width, height};
    case DraftPart::threading: return {margin, top - gap - above, width, above};
    case DraftPart::tieUp: return {right, top - gap - above, cells(DraftPart::tieUp).width() > 0 ? beside : 0, above};
    case DraftPart::treadling: return {right, top, beside, height};
    case DraftPart::warpBar: return {margin, margin, width, bar};
    case DraftPart::weftBar: return {right + beside + gap, top, bar, height};
    }
    return {};
}

QRectF DraftPaper::squareOf(DraftPart part, const QPoint& cell) const
{
    const QRectF area = areaOf(part);
    const bool ends = part == DraftPart::drawdown || part == DraftPart::threading || part == DraftPart::warpBar;
    const bool picks = part == DraftPart::drawdown || part == DraftPart::treadling || part == DraftPart::weftBar;
    const double x = part == DraftPart::weftBar ? 0
                     : ends                     ? cell.x() * cell_ - horizontalScrollBar()->value()
                                                : (cell.x() - first_treadle_) * cell_;
    const double down = verticalScrollBar()->maximum() - verticalScrollBar()->value();
    const double y = part == DraftPart::warpBar ? bar : picks ? (cell.y() + 1) * cell_ - down : (cell.y() - first_shaft_ + 1) * cell_;
    return {area.left() + x, area.bottom() - y, part == DraftPart::weftBar ? bar : static_cast<double>(cell_),
            part == DraftPart::warpBar ? bar : static_cast<double>(cell_)};
}

bool DraftPaper::cellAt(DraftPart part, const QPointF& at, QPoint* cell) const
{
    const QRectF first = squareOf(part, {0, 0});
    *cell = {static_cast<int>(std::floor((at.x() - first.left()) / first.width())),
             static_cast<int>(std::floor((first.bottom() - at.y()) / first.height()))};
    return areaOf(part).contains(at) && QRect(QPoint(), cells(part)).contains(*cell);
}

bool DraftPaper::filled(DraftPart part, const QPoint& cell) const
{
    const auto in = [](const std::vector<std::vector<bool>>& marks, int row, int column) {
        return marks[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    };
    switch (part) {
    case DraftPart::drawdown: return fabric_.weave.warp_up(cell.x(), cell.y());
    case DraftPart::threading: return in(threaded_, wrapped(cell.x(), draft_.ends()), cell.y());
    case DraftPart::tieUp: return in(tied_, cell.x(), cell.y());
    case DraftPart::treadling: return in(pressed_, wrapped(cell.y(), draft_.picks()), cell.x());
    default: return false;
    }
}

void DraftPaper::updateScrollBars()
{
    const QSizeF all = QSizeF(cells(DraftPart::drawdown)) * cell_;
    const QRectF shown = areaOf(DraftPart::drawdown);
    horizontalScrollBar()->setRange(0, std::max(0, static_cast<int>(all.width() - shown.width())));
    horizontalScrollBar()->setPageStep(static_cast<int>(shown.width()));
    horizontalScrollBar()->setSingleStep(cell_);
    verticalScrollBar()->setRange(0, std::max(0, static_cast<int>(all.height() - shown.height())));
    verticalScrollBar()->setPageStep(static_cast<int>(shown.height()));
    verticalScrollBar()->setSingleStep(cell_);
}

void DraftPaper::resizeEvent(QResizeEvent*)
{
    fitCells();
    updateScrollBars();
    verticalScrollBar()->setValue(verticalScrollBar()->maximum());
}

void DraftPaper::drawPart(QPainter& painter, DraftPart part)
{
    const QRectF area = areaOf(part);
    if (cells(part).isEmpty() || area.isEmpty()) { return; }
    const auto [paper, ink, accent] = paperColors(palette());
    QColor line = ink;
    line.setAlphaF(0.18F);
    painter.save();
    painter.setClipRect(area.adjusted(0, 0, 1, 1));
    const QRect shown = shownCells(part);
    drawSquares(painter, part, shown);
    painter.setPen(QPen(line, 1));
    if (cell_ >= 5) { drawGrid(painter, part, shown); }
    if (part == DraftPart::drawdown) {
        painter.setPen(QPen(accent, 2));
        const QRectF first = squareOf(part, {0, 0}), last = squareOf(part, {fabric_.weave.ends() - 1, fabric_.weave.picks() - 1});
        painter.drawRect(QRectF(QPointF(first.left(), last.top()), QPointF(last.right(), first.bottom())));
    }
    if (hasFocus() && part == cursor_part_) {
        const QRectF square = squareOf(part, cursor_).adjusted(1, 1, -1, -1);
        painter.setPen(QPen(paper, 3));
        painter.drawRect(square);
        painter.setPen(QPen(accent, 2));
        painter.drawRect(square);
    }
    painter.restore();
    painter.setPen(QPen(line, 1));
    painter.drawRect(area.adjusted(-0.5, -0.5, 0.5, 0.5));
}

/// The cells of a part that are scrolled into view, the lowest row first.
QRect DraftPaper::shownCells(DraftPart part) const
{
    const QRectF area = areaOf(part), one = squareOf(part, {0, 0});
    const QSize size = cells(part);
    const int left = std::max(0, static_cast<int>(std::floor((area.left() - one.left()) / one.width())));
    const int right = std::min(size.width() - 1, static_cast<int>(std::floor((area.right() - 1 - one.left()) / one.width())));
    const int low = std::max(0, static_cast<int>(std::floor((one.bottom() - area.bottom()) / one.height())));
    const int high = std::min(size.height() - 1, static_cast<int>(std::floor((one.bottom() - area.top() - 1) / one.height())));
    return {QPoint(left, low), QPoint(right, high)};
}

void DraftPaper::drawSquares(QPainter& painter, DraftPart part, const QRect& shown)
{
    const QSize size = cells(part);
    const QColor ink = paperColors(palette()).ink;
    QColor pale = ink;
    pale.setAlphaF(0.3F);
    for (int y = shown.top(); y <= shown.bottom(); ++y) {
        for (int x = shown.left(); x <= shown.right(); ++x) {
            const bool inside = x < (part == DraftPart::tieUp || part == DraftPart::treadling ? size.width() : fabric_.weave.ends()) &&
                                y < (part == DraftPart::tieUp || part == DraftPart::threading ? size.height() : fabric_.weave.picks());
            const bool up = filled(part, {x, y});
            const auto yarn = [&](bool warp) {
                const int number = warp ? warp_yarns_[static_cast<std::size_t>(x)] : weft_yarns_[static_cast<std::size_t>(y)];
                return yarnColor(yarn_in(fabric_, warp, number), warp);
            };
            const QRectF square = squareOf(part, {x, y});
            if (part == DraftPart::warpBar || part == DraftPart::weftBar) {
                painter.fillRect(square, yarn(part == DraftPart::warpBar));
            } else if (part == DraftPart::drawdown && colored_) {
                painter.fillRect(square, yarn(up));
            } else if (up) {
                painter.fillRect(square, inside ? ink : pale);
            }
        }
    }
}

void DraftPaper::drawGrid(QPainter& painter, DraftPart part, const QRect& shown)
{
    const QRectF area = areaOf(part);
    for (int x = shown.left(); x <= shown.right() + 1; ++x) {
        const double at = squareOf(part, {x, 0}).left() + 0.5;
        painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
    }
    for (int y = shown.top(); y <= shown.bottom() + 1; ++y) {
        const double at = squareOf(part, {0, y}).bottom() + 0.5;
        painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
    }
}

void DraftPaper::drawThumbs(QPainter& painter)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(paperColors(palette()).accent);
    const int shafts = draft_.shafts, treadles = cells(DraftPart::treadling).width();
    if (shownShafts() < shafts) {
        const QRectF area = areaOf(DraftPart::threading);
        const double one = area.height() / shafts;
        painter.drawRect(QRectF(area.right() + 2, area.bottom() - (first_shaft_ + shownShafts()) * one, 2, shownShafts() * one));
    }
    if (shownTreadles() < treadles) {
        const QRectF area = areaOf(DraftPart::treadling);
        const double one = area.width() / treadles;
        painter.drawRect(QRectF(area.left() + first_treadle_ * one, area.top() - 4, shownTreadles() * one, 2));
    }
}

void DraftPaper::paintEvent(QPaintEvent*)
{
    QPainter painter(viewport());
    painter.fillRect(viewport()->rect(), paperColors(palette()).paper);
    for (const DraftPart part : parts) { drawPart(painter, part); }
    drawThumbs(painter);
}

void DraftPaper::mousePressEvent(QMouseEvent* event)
{
    for (const DraftPart part : parts) {
        QPoint cell;
        if (event->button() == Qt::LeftButton && cellAt(part, event->position(), &cell)) {
            drag_part_ = cursor_part_ = part;
            last_ = cursor_ = cell;
            dragging_ = true;
            fill_ = !filled(part, cell);
            add_ = event->modifiers() & Qt::ControlModifier;
            Q_EMIT cellPainted(part, cell, fill_, add_);
        }
    }
    viewport()->update();
}

void DraftPaper::mouseMoveEvent(QMouseEvent* event)
{
    QPoint cell;
    if (dragging_ && cellAt(drag_part_, event->position(), &cell) && cell != last_) {
        for (const QPoint& at : lineOf(last_, cell)) {
            if (at != last_) { Q_EMIT cellPainted(drag_part_, at, fill_, add_); }
        }
        last_ = cursor_ = cell;
    }
}

void DraftPaper::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && std::exchange(dragging_, false)) { Q_EMIT strokeEnded(); }
}

void DraftPaper::wheelEvent(QWheelEvent* event)
{
    const int steps = event->angleDelta().y() > 0 ? 1 : -1;
    if (event->modifiers() & Qt::ControlModifier) {
        zoomBy(steps > 0 ? 1.2 : 1 / 1.2);
    } else if (areaOf(DraftPart::threading).contains(event->position()) && shownShafts() < draft_.shafts) {
        first_shaft_ = std::clamp(first_shaft_ + steps, 0, draft_.shafts - shownShafts());
    } else if (areaOf(DraftPart::treadling).contains(event->position()) && shownTreadles() < cells(DraftPart::treadling).width() &&
               (event->modifiers() & Qt::ShiftModifier)) {
        first_treadle_ = std::clamp(first_treadle_ - steps, 0, cells(DraftPart::treadling).width() - shownTreadles());
    } else {
        QAbstractScrollArea::wheelEvent(event);
    }
    viewport()->update();
    event->accept();
}

void DraftPaper::moveCursor(int x, int y)
{
    const QPoint to = cursor_ + QPoint(x, y);
    const QSize size = cells(cursor_part_);
    const auto enter = [this](DraftPart part, const QPoint& at) {
        if (const QSize other = cells(part); !other.isEmpty()) {
            cursor_part_ = part;
            cursor_ = {std::clamp(at.x(), 0, other.width() - 1), std::clamp(at.y(), 0, other.height() - 1)};
        }
    };
    constexpr int far = 1 << 20;
    if (QRect(QPoint(), size).contains(to)) {
        cursor_ = to;
    } else if (to.y() >= size.height()) {
        if (cursor_part_ == DraftPart::drawdown)
            enter(DraftPart::threading, {to.x(), 0});
        else if (cursor_part_ == DraftPart::threading)
            enter(DraftPart::warpBar, {to.x(), 0});
        else if (cursor_part_ == DraftPart::treadling)
            enter(DraftPart::tieUp, {to.x(), 0});
    } else if (to.y() < 0) {
        if (cursor_part_ == DraftPart::warpBar)
            enter(DraftPart::threading, {to.x(), far});
        else if (cursor_part_ == DraftPart::threading)
            enter(DraftPart::drawdown, {to.x(), far});
        else if (cursor_part_ == DraftPart::tieUp)
            enter(DraftPart::treadling, {to.x(), far});
    } else if (to.x() >= size.width()) {
        if (cursor_part_ == DraftPart::drawdown)
            enter(DraftPart::treadling, {0, to.y()});
        else if (cursor_part_ == DraftPart::threading)
            enter(DraftPart::tieUp, {0, to.y()});
        else if (cursor_part_ == DraftPart::treadling)
            enter(DraftPart::weftBar, {0, to.y()});
    } else if (to.x() < 0) {
        if (cursor_part_ == DraftPart::weftBar)
            enter(DraftPart::treadling, {far, to.y()});
        else if (cursor_part_ == DraftPart::treadling)
            enter(DraftPart::drawdown, {far, to.y()});
        else if (cursor_part_ == DraftPart::tieUp)
            enter(DraftPart::threading, {far, to.y()});
    }
    showCursor();
}

void DraftPaper::showCursor()
{
    const DraftPart part = cursor_part_;
    const QRectF area = areaOf(part), square = squareOf(part, cursor_);
    if (part == DraftPart::threading || part == DraftPart::tieUp) {
        first_shaft_ = std::clamp(first_shaft_, cursor_.y() - shownShafts() + 1, cursor_.y());
    }
    if (part == DraftPart::treadling || part == DraftPart::tieUp) {
        first_treadle_ = std::clamp(first_treadle_, cursor_.x() - shownTreadles() + 1, cursor_.x());
    }
    if (part == DraftPart::drawdown || part == DraftPart::threading || part == DraftPart::warpBar) {
        const double off = std::min(0.0, square.left() - area.left()) + std::max(0.0, square.right() - area.right());
        horizontalScrollBar()->setValue(horizontalScrollBar()->value() + qRound(off));
    }
    if (part == DraftPart::drawdown || part == DraftPart::treadling || part == DraftPart::weftBar) {
        const double off = std::min(0.0, square.top() - area.top()) + std::max(0.0, square.bottom() - area.bottom());
        verticalScrollBar()->setValue(verticalScrollBar()->value() + qRound(off));
    }
    viewport()->update();
}

void DraftPaper::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left: moveCursor(-1, 0); return;
    case Qt::Key_Right: moveCursor(1, 0); return;
    case Qt::Key_Up: moveCursor(0, 1); return;
    case Qt::Key_Down: moveCursor(0, -1); return;
    case Qt::Key_Space:
        Q_EMIT cellPainted(cursor_part_, cursor_, !filled(cursor_part_, cursor_), event->modifiers() & Qt::ControlModifier);
        Q_EMIT strokeEnded();
        return;
    default: QAbstractScrollArea::keyPressEvent(event);
    }
}

void DraftPaper::focusInEvent(QFocusEvent* event)
{
    QAbstractScrollArea::focusInEvent(event);
    viewport()->update();
}

void DraftPaper::focusOutEvent(QFocusEvent* event)
{
    QAbstractScrollArea::focusOutEvent(event);
    viewport()->update();
}

} // namespace hygroloom
