// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Point paper: a grid of which a filled square means the end lies over the pick. First pick at the bottom.
#pragma once

#include "ui/weave/weave_edits.h"

#include <QAbstractScrollArea>

namespace hygroloom {

enum class PaperTool { brush, line, rectangle, fill, select };

/// One repeat stands out; around it the weave continues, paler. The tool says what a drag draws; it draws what the first crossing is not.
/// Arrow keys move the cursor (with Shift they select), Space uses the tool there. The wheel scrolls, with Ctrl it zooms.
class PointPaper : public QAbstractScrollArea {
    Q_OBJECT
public:
    explicit PointPaper(QWidget* parent = nullptr);

    void setWeave(const Weave& weave);
    /// Marks a crossing of the repeat that is pointed at elsewhere; negative for none.
    void setHighlight(int end, int pick);
    /// Marks all squares of an end or of a pick of the repeat; negative for none.
    void setSelectedYarn(int end, int pick);
    QPoint selectedYarn() const { return selected_; }
    void setTool(PaperTool tool);
    PaperTool tool() const { return tool_; }
    /// Within the repeat; from its first end and pick. Empty for none.
    const QRect& selection() const { return selection_; }
    void setSelection(const QRect& selection);
    const QPoint& cursor() const { return cursor_; }
    void zoomBy(double factor);
    void zoomToFit();
    /// On the viewport.
    QRectF squareOf(int end, int pick) const;
    QSize sizeHint() const override { return {200, 200}; }
    QSize minimumSizeHint() const override { return {120, 120}; }

Q_SIGNALS:
    /// More of the same stroke may follow, until strokeEnded().
    void painted(const hygroloom::Crossings& crossings, bool up);
    void strokeEnded();
    void selectionChanged();
    /// Pointed at; negative when the pointer leaves.
    void crossingHovered(int end, int pick);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    double cell() const;
    double fittingCell() const;
    QSizeF contentSize() const;
    QPointF origin() const; ///< lower left corner of the repeat
    QPoint crossingAt(const QPointF& at) const;
    QPoint inRepeat(const QPoint& at) const;
    QPoint nearestInRepeat(const QPoint& at) const;
    void updateScrollBars();
    void showCursor();
    void zoomAt(double cell, const QPointF& at);
    void begin(const QPoint& at);
    void goOn(const QPoint& at);
    void finish();
    void useToolAtCursor();
    void brush(const Crossings& crossings);
    void drawShape(const QPoint& to);
    /// The squares between these, cell by cell.
    QImage squares(const QPoint& low, const QPoint& high) const;

    Weave weave_;
    PaperTool tool_ = PaperTool::brush;
    double zoom_ = 0; ///< pixels per square; 0: as many as fit
    QRect selection_;
    QPoint cursor_{0, 0};
    QPoint highlight_{-1, -1};
    QPoint selected_{-1, -1};
    QPoint last_{-1, -1};
    QPoint anchor_;     ///< where a shape begins
    Crossings pending_; ///< of a shape being drawn, or of a stroke on a large repeat
    bool drawing_ = false;
    bool anchored_ = false; ///< by the keyboard
    bool paintUp_ = false;
};

} // namespace hygroloom
