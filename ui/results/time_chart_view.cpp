// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/time_chart_view.h"

#include <QMouseEvent>
#include <QPainter>

namespace hygroloom {

TimeChartView::TimeChartView(QChart* chart, QWidget* parent) : PointedChartView(chart, parent)
{
    setRenderHint(QPainter::Antialiasing);
    setFrameShape(QFrame::NoFrame);
    setToolTip(tr("Click to show that time."));
    setMinimumSize(160, 100);
}

void TimeChartView::setCursorTime(double time)
{
    if (time != time_) {
        time_ = time;
        scene()->update();
    }
}

void TimeChartView::drawForeground(QPainter* painter, const QRectF& rect)
{
    PointedChartView::drawForeground(painter, rect);
    if (time_ < 0) { return; }
    const QRectF area = chart()->plotArea();
    const double x = chart()->mapToPosition(QPointF(time_, 0)).x();
    if (x >= area.left() - 1 && x <= area.right() + 1) {
        painter->setPen(QPen(palette().color(QPalette::WindowText), 1));
        painter->drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
}

void TimeChartView::mousePressEvent(QMouseEvent* event) { choose(event->position()); }

void TimeChartView::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton) { choose(event->position()); }
    PointedChartView::mouseMoveEvent(event);
}

void TimeChartView::choose(const QPointF& at)
{
    const QPointF value = chart()->mapToValue(chart()->mapFromScene(mapToScene(at.toPoint())));
    if (value.x() >= 0) { Q_EMIT timeChosen(value.x()); }
}

} // namespace hygroloom
