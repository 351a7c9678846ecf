// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A chart over time with a cursor at the time shown.
#pragma once

#include "ui/results/pointed_chart_view.h"

namespace hygroloom {

class TimeChartView : public PointedChartView {
    Q_OBJECT
public:
    explicit TimeChartView(QChart* chart, QWidget* parent = nullptr);

    /// Negative: no cursor.
    void setCursorTime(double time);

Q_SIGNALS:
    void timeChosen(double time);

protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    void choose(const QPointF& at);

    double time_ = -1;
};

} // namespace hygroloom
