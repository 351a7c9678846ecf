// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/chart.h"

#include "core/base/text.h"
#include "ui/basics/appearance.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
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

namespace {

struct Stroke {
    const char* light;
    const char* dark;
    Qt::PenStyle style;
};

// Curves differ by dash as well as by colour.
constexpr Stroke strokes[] = {{"#0b6aa8", "#5ab0e8", Qt::SolidLine},
                              {"#9a5b00", "#e0a94a", Qt::DashLine},
                              {"#7a3f98", "#c79be0", Qt::DashDotLine},
                              {"#5b6570", "#a8b2bb", Qt::DotLine}};

constexpr std::size_t most_curves = std::size(strokes);

} // namespace

Chart::Chart(ShownRun& shown, QWidget* parent) : QWidget(parent), shown_(shown)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (const TimePlot& each : shown_.plots()) {
        plots_.push_back(addPlot());
        plots_.back().view->setToolTip(each.tip);
        layout->addWidget(plots_.back().view, 1);
        layout->addWidget(plots_.back().legend);
    }
    setMinimumHeight(110);
    applyPalette();
    connect(&shown_, &ShownRun::metricsChanged, this, &Chart::refresh);
    connect(&shown_, &ShownRun::runChanged, this, &Chart::refresh);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &Chart::refresh);
    connect(&shown_, &ShownRun::frameShown, this, [this] {
        for (const PlotView& plot : plots_) { plot.view->setCursorTime(shown_.current() >= 0 ? shown_.time() : -1); }
    });
    refresh();
}

Chart::PlotView Chart::addPlot()
{
    PlotView plot;
    plot.chart = new QChart;
    plot.chart->setMargins(QMargins(2, 0, 6, 0));
    plot.chart->setBackgroundRoundness(0);
    plot.chart->legend()->hide(); // its pieces of the lines are too short for dashes
    plot.legend = new CurveLegend;
    plot.chart->layout()->setContentsMargins(0, 0, 0, 0);
    plot.time = new QValueAxis;
    plot.value = new QValueAxis;
    plot.time->setLabelFormat("%g s");
    plot.value->setLabelFormat("%g");
    plot.value->setTickCount(4);
    plot.chart->addAxis(plot.time, Qt::AlignBottom);
    plot.chart->addAxis(plot.value, Qt::AlignLeft);
    for (std::size_t i = 0; i < most_curves; ++i) {
        auto* line = new QLineSeries;
        plot.chart->addSeries(line);
        line->attachAxis(plot.time);
        line->attachAxis(plot.value);
        plot.lines.push_back(line);
    }
    plot.view = new TimeChartView(plot.chart);
    connect(plot.view, &TimeChartView::timeChosen, this, [this](double time) { shown_.show(shown_.frameAt(time)); });
    return plot;
}

QList<QPointF> Chart::points() const { return plots_.front().lines.front()->points(); }

QStringList Chart::curves() const
{
    QStringList names;
    for (const QLineSeries* line : plots_.front().lines) {
        if (line->isVisible()) { names << line->name(); }
    }
    return names;
}

QString Chart::title() const { return plots_.back().chart->title(); }

void Chart::fill(PlotView& view, const TimePlot& plot)
{
    view.chart->setTitle(plot.title);
    view.view->setAccessibleName(plot.title);
    view.view->forget();
    for (std::size_t i = 0; i < most_curves; ++i) {
        QLineSeries* line = view.lines[i];
        line->setVisible(i < plot.lines.size());
        const TimePlot::Line drawn = i < plot.lines.size() ? plot.lines[i] : TimePlot::Line();
        line->setName(drawn.name);
        line->replace(drawn.points);
        if (drawn.points.isEmpty()) { continue; }
        const auto text = [](double number) { return shownNumber(number, decimals_for(number, 3)); };
        view.view->tell(line, PointedChartView::Told::curve, [text, name = drawn.told, unit = plot.unit](const QPointF& at) {
            return tr("%1: %2 %3 at %4 s").arg(name, text(at.y()), unit, text(at.x()));
        });
    }
}

void Chart::setRanges(PlotView& view, const TimePlot& plot) const
{
    double lowest = plot.from_zero ? 0 : 1e300, highest = plot.from_zero ? 0 : -1e300, last = shown_.duration();
    for (const TimePlot::Line& line : plot.lines) {
        for (const QPointF& point : line.points) {
            lowest = std::min(lowest, point.y());
            highest = std::max(highest, point.y());
            last = std::max(last, point.x());
        }
    }
    view.time->setRange(0, last > 0 ? last : 10);
    if (plot.from_zero) {
        view.value->setRange(0, highest > 0 ? highest * 1.08 : 1);
    } else if (lowest <= highest) {
        const double margin = std::max(0.5, 0.05 * (highest - lowest));
        view.value->setRange(lowest - margin, highest + margin);
    } else {
        view.value->setRange(plot.low, plot.high);
    }
    view.value->applyNiceNumbers(); // round ends and three even steps
}

void Chart::refresh()
{
    const std::vector<TimePlot> plots = shown_.plots();
    for (std::size_t i = 0; i < plots_.size(); ++i) {
        fill(plots_[i], plots[i]);
        setRanges(plots_[i], plots[i]);
        refreshLegend(plots_[i]);
    }
}

void Chart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int needed = 400 * static_cast<int>(plots_.size()); // pixels, for labels side by side
    for (const PlotView& plot : plots_) { plot.time->setTickCount(width() < needed ? 3 : 6); }
}

void Chart::refreshLegend(PlotView& plot)
{
    std::vector<CurveLegend::Entry> entries;
    for (const QLineSeries* line : plot.lines) {
        if (line->isVisible() && !line->name().isEmpty()) { entries.push_back({line->name(), line->pen()}); }
    }
    plot.legend->setEntries(entries);
}

void Chart::applyPalette()
{
    const bool dark = isDark(palette());
    const QColor ink = palette().color(QPalette::WindowText);
    QColor grid = ink;
    grid.setAlphaF(0.12F);
    QFont small = font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() - 1));
    for (PlotView& plot : plots_) {
        plot.chart->setBackgroundBrush(palette().color(QPalette::Window));
        plot.chart->setTitleBrush(ink);
        QFont title = small;
        title.setBold(true);
        plot.chart->setTitleFont(title);
        plot.legend->setFont(small);
        for (QValueAxis* axis : {plot.time, plot.value}) {
            axis->setLabelsColor(ink);
            axis->setLabelsFont(small);
            axis->setGridLineColor(grid);
            axis->setLinePen(QPen(grid, 1));
        }
        for (std::size_t i = 0; i < plot.lines.size(); ++i) {
            plot.lines[i]->setPen(QPen(QColor(dark ? strokes[i].dark : strokes[i].light), 2, strokes[i].style));
        }
        refreshLegend(plot);
        plot.view->update();
    }
}

void Chart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) { applyPalette(); }
    QWidget::changeEvent(event);
}

} // namespace hygroloom
