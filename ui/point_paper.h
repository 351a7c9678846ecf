// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Point paper: a grid of which a filled square means the end lies over the pick. First pick at the bottom.
#pragma once

#include "core/design/weave.h"

#include <QWidget>

namespace hygroloom {

/// One repeat stands out; around it the weave goes on, paler. A click turns a crossing over, a drag paints the same onto others.
/// Arrow keys move the cursor, Space turns over.
class PointPaper : public QWidget {
    Q_OBJECT
public:
    explicit PointPaper(QWidget* parent = nullptr);

    void setWeave(const Weave& weave);
    /// Marks a crossing of the repeat that is pointed at elsewhere; negative for none.
    void setHighlight(int end, int pick);
    /// Marks all squares of an end or of a pick of the repeat; negative for none.
    void setSelectedYarn(int end, int pick);
    QPoint selectedYarn() const { return selected_; }
    QSize sizeHint() const override { return {200, 200}; }
    QSize minimumSizeHint() const override { return {120, 120}; }

Q_SIGNALS:
    void crossingPainted(int end, int pick, bool up);
    void strokeEnded();
    /// Pointed at; negative when the pointer leaves.
    void crossingHovered(int end, int pick);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    double cell() const;
    QPointF origin() const; ///< lower left corner of the repeat
    QPoint crossingAt(const QPointF& at) const;
    QRectF squareOf(int end, int pick) const;
    void paintCrossing(const QPoint& at);

    Weave weave_;
    QPoint cursor_{0, 0};
    QPoint highlight_{-1, -1};
    QPoint selected_{-1, -1};
    QPoint last_{-1, -1};
    bool painting_ = false;
    bool paintUp_ = false;
};

} // namespace hygroloom
