// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A draft as weavers draw it: threading above, tie-up in the corner, treadling beside the drawdown, yarns along both.
// Counts start at the drawdown's lower left corner: first pick at the bottom, shaft 1 and treadle 1 next to the drawdown.
#pragma once

#include "core/design/draft.h"
#include "core/design/fabric.h"

#include <QAbstractScrollArea>

namespace hygroloom {

enum class DraftPart { drawdown, threading, tieUp, treadling, warpBar, weftBar };

/// Shows; what a click or a drag does is up to who listens. Arrow keys move the cursor, across the parts too; Space clicks.
class DraftPaper : public QAbstractScrollArea {
    Q_OBJECT
public:
    explicit DraftPaper(QWidget* parent = nullptr);

    void setDraft(const Fabric& fabric, const Draft& draft);
    const Draft& draft() const { return draft_; }
    /// The yarn on top in its colour, instead of black and white.
    void setColored(bool colored);
    void zoomBy(double factor);
    /// Cells of a part: x is end, treadle, or shaft of a liftplan; y is pick or shaft.
    QSize cells(DraftPart part) const;
    QRectF squareOf(DraftPart part, const QPoint& cell) const;
    bool filled(DraftPart part, const QPoint& cell) const;
    DraftPart cursorPart() const { return cursor_part_; }
    const QPoint& cursor() const { return cursor_; }
    QSize sizeHint() const override { return {480, 300}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

Q_SIGNALS:
    /// A square is to become filled or not; add: beside what is in its column or row. More of the stroke may follow.
    void cellPainted(hygroloom::DraftPart part, const QPoint& cell, bool fill, bool add);
    void strokeEnded();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    QRectF areaOf(DraftPart part) const; ///< on the viewport
    int shownShafts() const;
    int shownTreadles() const;
    bool cellAt(DraftPart part, const QPointF& at, QPoint* cell) const;
    void updateScrollBars();
    void fitCells();
    void moveCursor(int x, int y);
    void showCursor();
    void drawPart(QPainter& painter, DraftPart part);
    QRect shownCells(DraftPart part) const;
    void drawSquares(QPainter& painter, DraftPart part, const QRect& shown);
    void drawGrid(QPainter& painter, DraftPart part, const QRect& shown);
    /// Which of the shafts and treadles are shown, where not all are.
    void drawThumbs(QPainter& painter);

    Fabric fabric_;
    Draft draft_;
    std::vector<int> warp_yarns_, weft_yarns_; ///< of all shown ends and picks
    std::vector<std::vector<bool>> threaded_, tied_, pressed_;
    bool colored_ = true;
    int cell_ = 14;
    bool zoomed_ = false;                     ///< by the user; else small drafts have larger squares
    int first_shaft_ = 0, first_treadle_ = 0; ///< the nearest that are shown
    DraftPart cursor_part_ = DraftPart::drawdown;
    QPoint cursor_{0, 0};
    DraftPart drag_part_ = DraftPart::drawdown;
    QPoint last_;
    bool dragging_ = false, fill_ = false, add_ = false;
};

} // namespace hygroloom
