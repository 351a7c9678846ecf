// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/chart.h"

#include "core/analysis/outcomes.h"
#include "core/base/text.h"
#include "ui/basics/appearance.h"
#include "ui/basics/color_map.h"
#include "ui/basics/core_words.h"
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

/// The curves that the window draws.
std::vector<Curve> curvesOf(const Plot& plot)
{
    std::vector<Curve> curves = plot.curves;
    std::erase_if(curves, [](const Curve& curve) { return curve.in_reports_only; });
    curves.resize(std::min(curves.size(), most_curves));
    return curves;
}

} // namespace

Chart::Chart(Playback& playback, QWidget* parent) : QWidget(parent), playback_(playback), water_(addPlot()), subject_(addPlot())
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (const PlotView* plot : {&water_, &subject_}) {
        layout->addWidget(plot->view, 1);
        layout->addWidget(plot->legend);
    }
    setMinimumHeight(110);
    water_.view->setToolTip(tr("In fibres: water absorbed since the start.\nClick to show that time."));
    applyPalette();
    connect(&playback_, &Playback::metricsChanged, this, &Chart::refresh);
    connect(&playback_, &Playback::runChanged, this, &Chart::refresh);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &Chart::refresh);
    connect(&playback_, &Playback::frameShown, this, [this] {
        const double time = playback_.current() >= 0 ? playback_.timeOf(playback_.current()) : -1;
        water_.view->setCursorTime(time);
        subject_.view->setCursorTime(time);
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
    connect(plot.view, &TimeChartView::timeChosen, this, [this](double time) { playback_.show(playback_.frameAt(time)); });
    return plot;
}

int Chart::points() const { return water_.lines.front()->count(); }

QStringList Chart::waterCurves() const
{
    QStringList names;
    for (const QLineSeries* line : water_.lines) {
        if (line->isVisible()) { names << line->name(); }
    }
    return names;
}

QString Chart::title() const { return subject_.chart->title(); }

void Chart::fill(PlotView& view, const Plot& plot)
{
    static const Metrics nothing;
    const Metrics& metrics = playback_.metrics() ? *playback_.metrics() : nothing;
    const UserUnit user = userUnit(plot.unit);
    const QString title = coreTitle(plot.title, user.unit.toStdString());
    view.chart->setTitle(title);
    view.view->setAccessibleName(title);
    const std::vector<Curve> curves = curvesOf(plot);
    view.view->forget();
    double lowest = plot.from_zero ? 0 : 1e300, highest = plot.from_zero ? 0 : -1e300;
    for (std::size_t i = 0; i < most_curves; ++i) {
        QLineSeries* line = view.lines[i];
        line->setVisible(i < curves.size());
        QList<QPointF> points;
        if (i < curves.size()) {
            line->setName(coreWord(curves[i].name));
            const std::vector<double> values = plotted(plot, curves[i], metrics);
            const std::size_t count = std::min(metrics.series.time.size(), values.size());
            points.reserve(static_cast<qsizetype>(count));
            for (std::size_t k = 0; k < count; ++k) {
                const double value = user.of(plot.from_zero ? std::max(0.0, values[k]) : values[k]);
                points << QPointF(metrics.series.time[k], value);
                lowest = std::min(lowest, value);
                highest = std::max(highest, value);
            }
        }
        line->replace(points);
        if (points.isEmpty()) { continue; }
        const auto text = [](double number) { return shownNumber(number, decimals_for(number, 3)); };
        const QString name = curves.size() > 1 ? QString("%1, %2").arg(coreWord(plot.title), line->name()) : coreWord(plot.title);
        view.view->tell(line, PointedChartView::Told::curve, [text, name, unit = coreWord(user.unit)](const QPointF& at) {
            return tr("%1: %2 %3 at %4 s").arg(name, text(at.y()), unit, text(at.x()));
        });
    }
    setRanges(view, plot.from_zero, lowest, highest, user);
    refreshLegend(view);
}

void Chart::setRanges(PlotView& view, bool fromZero, double lowest, double highest, const UserUnit& user) const
{
    view.time->setRange(0, playback_.duration() > 0 ? playback_.duration() : 10);
    if (fromZero) {
        view.value->setRange(0, highest > 0 ? highest * 1.08 : 1);
    } else if (lowest <= highest) {
        const double margin = std::max(0.5, 0.05 * (highest - lowest));
        view.value->setRange(lowest - margin, highest + margin);
    } else {
        view.value->setRange(user.of(15), user.of(30));
    }
    view.value->applyNiceNumbers(); // round ends and three even steps
}

void Chart::refresh()
{
    const Experiment* experiment = playback_.run() ? find_experiment(playback_.run()->design, playback_.run()->experiment) : nullptr;
    const ExperimentType type = experiment ? experiment->type : ExperimentType::droplet;
    fill(water_, water_plot(type));
    fill(subject_, subject_plot(type));
}

void Chart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    for (PlotView* plot : {&water_, &subject_}) {
        plot->time->setTickCount(width() < 800 ? 3 : 6); // labels side by side
    }
}

void Chart::refreshLegend(PlotView& plot)
{
    std::vector<CurveLegend::Entry> entries;
    for (const QLineSeries* line : plot.lines) {
        if (line->isVisible()) { entries.push_back({line->name(), line->pen()}); }
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
    for (PlotView* plot : {&water_, &subject_}) {
        plot->chart->setBackgroundBrush(palette().color(QPalette::Window));
        plot->chart->setTitleBrush(ink);
        QFont title = small;
        title.setBold(true);
        plot->chart->setTitleFont(title);
        plot->legend->setFont(small);
        for (QValueAxis* axis : {plot->time, plot->value}) {
            axis->setLabelsColor(ink);
            axis->setLabelsFont(small);
            axis->setGridLineColor(grid);
            axis->setLinePen(QPen(grid, 1));
        }
        for (std::size_t i = 0; i < plot->lines.size(); ++i) {
            plot->lines[i]->setPen(QPen(QColor(dark ? strokes[i].dark : strokes[i].light), 2, strokes[i].style));
        }
        refreshLegend(*plot);
        plot->view->update();
    }
}

void Chart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && subject_.view) { applyPalette(); }
    QWidget::changeEvent(event);
}

} // namespace hygroloom
