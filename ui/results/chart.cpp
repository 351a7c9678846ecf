// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/chart.h"

#include "core/base/units.h"
#include "ui/basics/appearance.h"
#include "ui/basics/color_map.h"
#include "ui/results/curve_legend.h"
#include "ui/results/time_chart_view.h"

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
constexpr Stroke strokes[] = {{"#0b6aa8", "#5ab0e8", Qt::SolidLine},
                              {"#9a5b00", "#e0a94a", Qt::DashLine},
                              {"#7a3f98", "#c79be0", Qt::DashDotLine},
                              {"#5b6570", "#a8b2bb", Qt::DotLine}};

constexpr std::size_t most_curves = std::size(strokes);

} // namespace

/// What a plot shows: curves as factor times series plus offset.
struct PlotContent {
    struct Curve {
        QString name;
        std::vector<double> Series::*values;
        bool taken_up = false; ///< less what the cloth held before the experiment
    };
    QString title;
    std::vector<Curve> curves;
    double factor = 1, offset = 0;
    bool from_zero = true; ///< the value axis begins there, and less than that is none
};

namespace {

/// Where the water is; in a test of the fibres' uptake, how much they hold.
PlotContent waterContent(ExperimentType type)
{
    if (type == ExperimentType::conditioning) { return {Chart::tr("Regain, %"), {{Chart::tr("fibres"), &Series::regain_mean}}, 100}; }
    return {Chart::tr("Water, mg"),
            {{Chart::tr("free"), &Series::free_water},
             {Chart::tr("in yarns"), &Series::yarn_water},
             {Chart::tr("in fibres"), &Series::bound_water, true},
             {Chart::tr("evaporated"), &Series::evaporated}},
            1e6};
}

PlotContent subjectContent(ExperimentType type)
{
    using S = Series;
    const QString top = Chart::tr("top"), bottom = Chart::tr("bottom");
    switch (type) {
    case ExperimentType::droplet:
    case ExperimentType::horizontal_wicking: break;
    case ExperimentType::moisture_management:
        return {Chart::tr("Water content, % of dry mass"), {{top, &S::content_top}, {bottom, &S::content_bottom}}};
    case ExperimentType::vertical_wicking: return {Chart::tr("Height, mm"), {{Chart::tr("risen"), &S::wick_height}}, 1e3};
    case ExperimentType::drying:
    case ExperimentType::conditioning:
        return {Chart::tr("Temperature, °C"),
                {{Chart::tr("sample"), &S::temperature_mean}, {Chart::tr("air"), &S::air_temperature}},
                1,
                -zero_celsius,
                false};
    case ExperimentType::sweat: return {Chart::tr("Water in the faces, mg"), {{top, &S::water_top}, {bottom, &S::water_bottom}}, 1e6};
    }
    return {Chart::tr("Wetted radius, mm"), {{top, &S::radius_top}, {bottom, &S::radius_bottom}}, 1e3};
}

} // namespace

Chart::Chart(Playback& playback, QWidget* parent) : QWidget(parent), playback_(playback), water_(addPlot()), subject_(addPlot())
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (const Plot* plot : {&water_, &subject_}) {
        layout->addWidget(plot->view, 1);
        layout->addWidget(plot->legend);
    }
    setMinimumHeight(110);
    water_.view->setToolTip(tr("In fibres: what they have taken up, beyond what they held before.\nClick to show that moment."));
    applyPalette();
    connect(&playback_, &Playback::metricsChanged, this, &Chart::refresh);
    connect(&playback_, &Playback::runChanged, this, &Chart::refresh);
    connect(&playback_, &Playback::frameShown, this, [this] {
        const double time = playback_.current() >= 0 ? playback_.timeOf(playback_.current()) : -1;
        water_.view->setCursorTime(time);
        subject_.view->setCursorTime(time);
    });
    refresh();
}

Chart::Plot Chart::addPlot()
{
    Plot plot;
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

void Chart::fill(Plot& plot, const PlotContent& content)
{
    static const Series nothing;
    const Series& series = playback_.metrics() ? playback_.metrics()->series : nothing;
    plot.chart->setTitle(content.title);
    plot.view->setAccessibleName(content.title);
    double lowest = content.from_zero ? 0 : 1e300, highest = content.from_zero ? 0 : -1e300;
    for (std::size_t i = 0; i < most_curves; ++i) {
        QLineSeries* line = plot.lines[i];
        line->setVisible(i < content.curves.size());
        QList<QPointF> points;
        if (i < content.curves.size()) {
            line->setName(content.curves[i].name);
            const std::vector<double>& values = series.*content.curves[i].values;
            points.reserve(static_cast<qsizetype>(values.size()));
            const double before = content.curves[i].taken_up && playback_.metrics() ? playback_.metrics()->ledger.water_initial : 0;
            for (std::size_t k = 0; k < std::min(series.time.size(), values.size()); ++k) {
                // A radius below zero stands for no circle.
                const double value =
                    content.factor * (content.from_zero ? std::max(0.0, values[k] - before) : values[k] - before) + content.offset;
                points << QPointF(series.time[k], value);
                lowest = std::min(lowest, value);
                highest = std::max(highest, value);
            }
        }
        line->replace(points);
    }
    refreshLegend(plot);
    plot.time->setRange(0, playback_.duration() > 0 ? playback_.duration() : 10);
    if (content.from_zero) {
        plot.value->setRange(0, highest > 0 ? highest * 1.08 : 1);
    } else if (lowest <= highest) {
        const double margin = std::max(0.5, 0.05 * (highest - lowest));
        plot.value->setRange(lowest - margin, highest + margin);
    } else {
        plot.value->setRange(15, 30);
    }
    // Round ends and three even steps.
    plot.value->applyNiceNumbers();
}

void Chart::refresh()
{
    const Experiment* experiment = playback_.run() ? find_experiment(playback_.run()->design, playback_.run()->experiment) : nullptr;
    const ExperimentType type = experiment ? experiment->type : ExperimentType::droplet;
    fill(water_, waterContent(type));
    fill(subject_, subjectContent(type));
}

void Chart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    for (Plot* plot : {&water_, &subject_}) {
        plot->time->setTickCount(width() < 800 ? 3 : 6); // labels side by side
    }
}

void Chart::refreshLegend(Plot& plot)
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
    for (Plot* plot : {&water_, &subject_}) {
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
