// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/chart.h"

#include "ui/appearance.h"
#include "ui/color_map.h"
#include "ui/time_chart_view.h"

#include <QChart>
#include <QEvent>
#include <QHBoxLayout>
#include <QLegend>
#include <QLineSeries>
#include <QValueAxis>

#include <algorithm>

namespace hygroloom {

namespace {

struct Stroke {
    const char* light;
    const char* dark;
    Qt::PenStyle style;
};

// Told apart by dash as well as by colour.
constexpr Stroke strokes[] = {{"#0b6aa8", "#5ab0e8", Qt::SolidLine}, {"#9a5b00", "#e0a94a", Qt::DashLine}, {"#5b6570", "#a8b2bb", Qt::DotLine}};

} // namespace

Chart::Chart(Playback& playback, QWidget* parent)
    : QWidget(parent)
    , playback_(playback)
    , water_(addPlot(tr("Water, mg"), {tr("free"), tr("in yarns"), tr("evaporated")}))
    , radius_(addPlot(tr("Wetted radius, mm"), {tr("top"), tr("bottom")}))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(water_.view);
    layout->addWidget(radius_.view);
    setMinimumHeight(110);
    applyPalette();
    connect(&playback_, &Playback::metricsChanged, this, &Chart::refresh);
    connect(&playback_, &Playback::runChanged, this, &Chart::refresh);
    connect(&playback_, &Playback::frameShown, this, [this] {
        const double time = playback_.current() >= 0 ? playback_.timeOf(playback_.current()) : -1;
        water_.view->setCursorTime(time);
        radius_.view->setCursorTime(time);
    });
    refresh();
}

Chart::Plot Chart::addPlot(const QString& title, const QStringList& names)
{
    Plot plot;
    plot.chart = new QChart;
    plot.chart->setTitle(title);
    plot.chart->setMargins(QMargins(2, 0, 6, 0));
    plot.chart->setBackgroundRoundness(0);
    plot.chart->legend()->setAlignment(Qt::AlignRight);
    plot.chart->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    plot.chart->layout()->setContentsMargins(0, 0, 0, 0);
    plot.time = new QValueAxis;
    plot.value = new QValueAxis;
    plot.time->setLabelFormat("%g s");
    plot.value->setLabelFormat("%g");
    plot.time->setTickCount(6);
    plot.value->setTickCount(4);
    plot.chart->addAxis(plot.time, Qt::AlignBottom);
    plot.chart->addAxis(plot.value, Qt::AlignLeft);
    for (const QString& name : names) {
        auto* line = new QLineSeries;
        line->setName(name);
        plot.chart->addSeries(line);
        line->attachAxis(plot.time);
        line->attachAxis(plot.value);
        plot.lines.push_back(line);
    }
    plot.view = new TimeChartView(plot.chart);
    plot.view->setAccessibleName(title);
    connect(plot.view, &TimeChartView::timeChosen, this, [this](double time) { playback_.show(playback_.frameAt(time)); });
    return plot;
}

int Chart::points() const
{
    return water_.lines.front()->count();
}

void Chart::fill(Plot& plot, const std::vector<double>& time, const std::vector<const std::vector<double>*>& values, double scale)
{
    double highest = 0;
    for (std::size_t i = 0; i < plot.lines.size(); ++i) {
        QList<QPointF> points;
        points.reserve(static_cast<qsizetype>(time.size()));
        for (std::size_t k = 0; k < std::min(time.size(), values[i]->size()); ++k) {
            // A radius below zero stands for no circle.
            points << QPointF(time[k], scale * std::max(0.0, (*values[i])[k]));
            highest = std::max(highest, points.last().y());
        }
        plot.lines[i]->replace(points);
    }
    plot.time->setRange(0, playback_.duration() > 0 ? playback_.duration() : 10);
    // Round ends and three even steps.
    plot.value->setRange(0, highest > 0 ? highest * 1.08 : 1);
    plot.value->applyNiceNumbers();
}

void Chart::refresh()
{
    static const Series nothing;
    const Series& series = playback_.metrics() ? playback_.metrics()->series : nothing;
    fill(water_, series.time, {&series.free_water, &series.yarn_water, &series.evaporated}, 1e6);
    fill(radius_, series.time, {&series.radius_top, &series.radius_bottom}, 1e3);
}

void Chart::applyPalette()
{
    const bool dark = isDark(palette());
    const QColor ink = palette().color(QPalette::WindowText);
    QColor grid = ink;
    grid.setAlphaF(0.12F);
    QFont small = font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() - 1));
    for (Plot* plot : {&water_, &radius_}) {
        plot->chart->setBackgroundBrush(palette().color(QPalette::Window));
        plot->chart->setTitleBrush(ink);
        QFont title = small;
        title.setBold(true);
        plot->chart->setTitleFont(title);
        plot->chart->legend()->setLabelColor(ink);
        plot->chart->legend()->setFont(small);
        for (QValueAxis* axis : {plot->time, plot->value}) {
            axis->setLabelsColor(ink);
            axis->setLabelsFont(small);
            axis->setGridLineColor(grid);
            axis->setLinePen(QPen(grid, 1));
        }
        for (std::size_t i = 0; i < plot->lines.size(); ++i) {
            plot->lines[i]->setPen(QPen(QColor(dark ? strokes[i].dark : strokes[i].light), 2, strokes[i].style));
        }
        plot->view->update();
    }
}

void Chart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && radius_.view) {
        applyPalette();
    }
    QWidget::changeEvent(event);
}

} // namespace hygroloom
