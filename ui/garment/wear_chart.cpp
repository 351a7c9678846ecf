// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/wear_chart.h"

#include "core/wear/wear_outcomes.h"
#include "ui/basics/appearance.h"
#include "ui/results/curve_legend.h"
#include "ui/results/time_chart_view.h"

#include <QChart>
#include <QEvent>
#include <QGraphicsLayout>
#include <QHBoxLayout>
#include <QLegend>
#include <QLineSeries>
#include <QValueAxis>

#include <algorithm>

namespace hygroloom {

WearChart::WearChart(WearPlayback& playback, QWidget* parent)
    : QWidget(parent), playback_(playback), chart_(new QChart), view_(new TimeChartView(chart_)), legend_(new CurveLegend),
      time_(new QValueAxis), value_(new QValueAxis), newest_(new QLineSeries), kept_(new QLineSeries)
{
    chart_->setMargins(QMargins(2, 0, 6, 0));
    chart_->setBackgroundRoundness(0);
    chart_->legend()->hide();
    chart_->layout()->setContentsMargins(0, 0, 0, 0);
    time_->setLabelFormat("%g s");
    value_->setLabelFormat("%g");
    value_->setTickCount(4);
    chart_->addAxis(time_, Qt::AlignBottom);
    chart_->addAxis(value_, Qt::AlignLeft);
    for (QLineSeries* line : {kept_, newest_}) {
        chart_->addSeries(line);
        line->attachAxis(time_);
        line->attachAxis(value_);
    }
    view_->setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(view_, 1);
    layout->addWidget(legend_);
    setMinimumHeight(100);
    connect(view_, &TimeChartView::timeChosen, this, [this](double time) {
        if (playback_.frames() > 0) { playback_.show(playback_.run()->frameAt(std::min(time, playback_.run()->frames.back()->time))); }
    });
    for (const auto signal :
         {&WearPlayback::runChanged, &WearPlayback::framesChanged, &WearPlayback::scaleChanged, &WearPlayback::pinChanged}) {
        connect(&playback_, signal, this, &WearChart::refresh);
    }
    connect(&playback_, &WearPlayback::frameShown, this,
            [this] { view_->setCursorTime(playback_.current() >= 0 ? playback_.time() : -1); });
    applyPalette();
    refresh();
}

QString WearChart::title() const { return chart_->title(); }

QList<QPointF> WearChart::points() const { return newest_->points(); }

/// Of the pinned cell, else of the garment.
QList<QPointF> WearChart::curveOf(const WornRun& run) const
{
    QList<QPointF> points;
    const bool share = playback_.value() == WearValue::share;
    if (playback_.pin().panel >= 0) {
        if (!playback_.run()) { return points; }
        const int cell = run.lookup->at(sameSpot(playback_.run()->layout(), run.layout(), playback_.pin()));
        if (cell < 0) { return points; }
        const GarmentCell& at = run.layout().cells[static_cast<std::size_t>(cell)];
        for (const auto& frame : run.frames) {
            const double water = frame->water(static_cast<std::size_t>(cell));
            points << QPointF(frame->time, share ? 100 * water / at.capacity : 1e3 * water / at.area);
        }
    } else if (run.metrics) {
        const WearPart& all = run.metrics->all();
        const WearNumber& number = wear_number(share ? "share_of_capacity" : "water_g_m2");
        for (const WearNow& now : all.course) {
            points << QPointF(now.time, shown(number.info, number.value({*run.metrics, all, now}).value_or(0)).value);
        }
    }
    return points;
}

void WearChart::refresh()
{
    const bool share = playback_.value() == WearValue::share, pinned = playback_.pin().panel >= 0;
    chart_->setTitle(pinned ? (share ? tr("Share of capacity at the pin, %") : tr("Water at the pin, g/m²"))
                            : (share ? tr("Share of the garment's capacity, %") : tr("Water in the garment, g/m²")));
    view_->setAccessibleName(chart_->title());
    newest_->replace(playback_.run() ? curveOf(*playback_.run()) : QList<QPointF>());
    kept_->replace(playback_.kept() ? curveOf(*playback_.kept()) : QList<QPointF>());
    kept_->setVisible(playback_.kept() != nullptr);
    double highest = 0, last = playback_.duration();
    for (const QLineSeries* line : {newest_, kept_}) {
        for (const QPointF& point : line->points()) {
            highest = std::max(highest, point.y());
            last = std::max(last, point.x());
        }
    }
    time_->setRange(0, last > 0 ? last : 10);
    value_->setRange(0, highest > 0 ? 1.08 * highest : 1);
    value_->applyNiceNumbers();
    std::vector<CurveLegend::Entry> entries;
    if (playback_.kept()) { entries = {{"A", kept_->pen()}, {"B", newest_->pen()}}; }
    legend_->setEntries(entries);
}

void WearChart::applyPalette()
{
    const QColor ink = palette().color(QPalette::WindowText);
    QColor grid = ink;
    grid.setAlphaF(0.12F);
    QFont small = font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() - 1));
    QFont bold = small;
    bold.setBold(true);
    chart_->setBackgroundBrush(palette().color(QPalette::Window));
    chart_->setTitleBrush(ink);
    chart_->setTitleFont(bold);
    legend_->setFont(small);
    for (QValueAxis* axis : {time_, value_}) {
        axis->setLabelsColor(ink);
        axis->setLabelsFont(small);
        axis->setGridLineColor(grid);
        axis->setLinePen(QPen(grid, 1));
    }
    const bool dark = isDark(palette());
    newest_->setPen(QPen(QColor(dark ? "#5ab0e8" : "#0b6aa8"), 2, Qt::SolidLine));
    kept_->setPen(QPen(QColor(dark ? "#e0a94a" : "#9a5b00"), 2, Qt::DashLine));
    refresh();
}

void WearChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && kept_) { applyPalette(); }
    QWidget::changeEvent(event);
}

} // namespace hygroloom
