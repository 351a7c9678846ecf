// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/pointed_chart_view.h"

#include <QHelpEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

namespace {

constexpr double reach = 24; // pixels from a marker's middle
constexpr double ring = 4.5; // the same, radius

/// Between the points that lie on both sides; none: it is not beside any. Precondition: x never falls.
std::optional<QPointF> valueAt(const QList<QPointF>& points, double x)
{
    const auto after = std::lower_bound(points.begin(), points.end(), x, [](const QPointF& point, double at) { return point.x() < at; });
    if (after == points.end()) { return {}; }
    if (after->x() == x) { return *after; }
    if (after == points.begin()) { return {}; }
    const QPointF &from = *(after - 1), &to = *after;
    return QPointF(x, from.y() + (x - from.x()) / (to.x() - from.x()) * (to.y() - from.y()));
}

QString inTip(const QString& words) { return "<p style='white-space:pre'>" + words.toHtmlEscaped() + "</p>"; }

} // namespace

PointedChartView::PointedChartView(QChart* chart, QWidget* parent) : QChartView(chart, parent)
{
    setMouseTracking(true);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate); // otherwise parts of the ring stay at its old places
}

void PointedChartView::tell(QXYSeries* series, Told told, Words words) { sources_.push_back({series, told, std::move(words)}); }

void PointedChartView::forget()
{
    sources_.clear();
    point({});
}

std::optional<PointedChartView::Found> PointedChartView::find(const QPointF& at) const
{
    const QPointF scene = mapToScene(at.toPoint()), place = chart()->mapFromScene(scene);
    if (!chart()->plotArea().adjusted(-2, -2, 2, 2).contains(place)) { return {}; }
    std::optional<Found> nearest;
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Source& source, const QPointF& value, const QPointF& where, double off) {
        if (!(off < least)) { return; }
        least = off;
        nearest = Found{where, source.words(value)};
    };
    for (const Source& source : sources_) { // a marker before any curve
        if (source.told != Told::points || !source.series || !source.series->isVisible()) { continue; }
        for (const QPointF& value : source.series->points()) {
            const QPointF where = chart()->mapToPosition(value, source.series);
            if (const double off = QLineF(where, place).length(); off <= reach) { consider(source, value, where, off); }
        }
    }
    if (nearest) { return nearest; }
    for (const Source& source : sources_) {
        if (source.told != Told::curve || !source.series || !source.series->isVisible()) { continue; }
        const auto value = valueAt(source.series->points(), chart()->mapToValue(place, source.series).x());
        if (!value) { continue; }
        const QPointF where = chart()->mapToPosition(*value, source.series);
        consider(source, *value, where, std::abs(where.y() - place.y()));
    }
    return nearest;
}

QString PointedChartView::wordsAt(const QPointF& at) const
{
    const auto found = find(at);
    return found ? found->words : QString();
}

void PointedChartView::point(const std::optional<Found>& found)
{
    const QString before = found_ ? found_->words : QString(), now = found ? found->words : QString();
    found_ = found;
    viewport()->update();
    if (before != now) { Q_EMIT pointed(now); }
}

void PointedChartView::mouseMoveEvent(QMouseEvent* event)
{
    QChartView::mouseMoveEvent(event);
    point(find(event->position()));
    if (found_) {
        QToolTip::showText(event->globalPosition().toPoint(), inTip(found_->words), this);
    } else {
        QToolTip::hideText();
    }
}

void PointedChartView::leaveEvent(QEvent* event)
{
    point({});
    QChartView::leaveEvent(event);
}

/// The widget's own tip stands below the number.
bool PointedChartView::viewportEvent(QEvent* event)
{
    if (event->type() != QEvent::ToolTip) { return QChartView::viewportEvent(event); }
    auto* help = static_cast<QHelpEvent*>(event);
    QStringList parts;
    if (const QString words = wordsAt(help->pos()); !words.isEmpty()) { parts << words; }
    if (!toolTip().isEmpty()) { parts << toolTip(); }
    QToolTip::showText(help->globalPos(), parts.isEmpty() ? QString() : inTip(parts.join('\n')), this);
    return true;
}

void PointedChartView::drawForeground(QPainter* painter, const QRectF& rect)
{
    QChartView::drawForeground(painter, rect);
    if (!found_) { return; }
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(palette().color(QPalette::WindowText), 1.5));
    painter->setBrush(palette().color(QPalette::Window));
    painter->drawEllipse(chart()->mapToScene(found_->place), ring, ring);
}

} // namespace hygroloom
