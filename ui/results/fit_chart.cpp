// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/fit_chart.h"

#include "core/base/text.h"
#include "ui/basics/appearance.h"
#include "ui/basics/quantity.h"

#include <QChart>
#include <QEvent>
#include <QLegend>
#include <QLineSeries>
#include <QScatterSeries>
#include <QValueAxis>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

/// 1, 2 or 5 times a power of ten, the nearest to a rough step.
double roundStep(double rough)
{
    const double power = std::pow(10, std::floor(std::log10(rough))), share = rough / power;
    return power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
}

} // namespace

FitChart::FitChart(QWidget* parent)
    : PointedChartView(new QChart, parent), measured_(new QScatterSeries), before_(new QLineSeries), fitted_(new QLineSeries),
      time_(new QValueAxis), value_(new QValueAxis)
{
    measured_->setName(tr("measured"));
    before_->setName(tr("before"));
    fitted_->setName(tr("fitted"));
    measured_->setMarkerSize(8);
    chart()->setBackgroundRoundness(0);
    chart()->setMargins(QMargins(2, 0, 6, 0));
    chart()->legend()->setAlignment(Qt::AlignTop);
    chart()->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    chart()->addAxis(time_, Qt::AlignBottom);
    chart()->addAxis(value_, Qt::AlignLeft);
    for (QXYSeries* series : {static_cast<QXYSeries*>(before_), static_cast<QXYSeries*>(fitted_), static_cast<QXYSeries*>(measured_)}) {
        chart()->addSeries(series);
        series->attachAxis(time_);
        series->attachAxis(value_);
    }
    time_->setTitleText(tr("time, s"));
    time_->setLabelFormat("%.3g");
    value_->setLabelFormat("%.4g");
    setAccessibleName(tr("Measured and simulated curves"));
    setMinimumHeight(240);
    applyPalette();
}

void FitChart::show(const Calibration& calibration)
{
    QList<QPointF> measured, before, fitted;
    double latest = 0, lowest = 0, highest = 0;
    const UserUnit user = userUnit(QString::fromStdString(calibration.data.unit));
    const auto& numbers = calibration.data.numbers;
    for (std::size_t i = 0; calibration.data.is_curve() && i < numbers.size(); ++i) {
        measured << QPointF(numbers[i].time, user.of(numbers[i].value));
        if (i < calibration.before.size()) { before << QPointF(numbers[i].time, user.of(calibration.before[i])); }
        if (i < calibration.fitted.size()) { fitted << QPointF(numbers[i].time, user.of(calibration.fitted[i])); }
    }
    for (const auto& points : {measured, before, fitted}) {
        for (const QPointF& point : points) {
            latest = std::max(latest, point.x());
            lowest = std::min(lowest, point.y());
            highest = std::max(highest, point.y());
        }
    }
    measured_->replace(measured);
    before_->replace(before);
    fitted_->replace(fitted);
    time_->setRange(0, latest > 0 ? 1.02 * latest : 1); // with room for the last point
    time_->setTickType(QValueAxis::TicksDynamic);
    time_->setTickInterval(roundStep(latest > 0 ? latest / 5 : 0.2));
    const double span = highest > lowest ? highest - lowest : 1;
    value_->setRange(lowest, lowest + 1.05 * span);
    value_->setTickType(QValueAxis::TicksDynamic);
    value_->setTickInterval(roundStep(span / 4));
    chart()->setTitle(QString::fromStdString(calibration.data.quantity));
    forget();
    for (QXYSeries* series : std::initializer_list<QXYSeries*>{measured_, before_, fitted_}) {
        const auto words = [series, unit = user.unit](const QPointF& at) {
            const auto text = [](double number) { return shownNumber(number, decimals_for(number, 3)); };
            return tr("%1: %2 %3 at %4 s").arg(series->name(), text(at.y()), unit, text(at.x()));
        };
        tell(series, series == measured_ ? Told::points : Told::curve, words);
    }
}

void FitChart::applyPalette()
{
    const bool dark = isDark(palette());
    const QColor ink = palette().color(QPalette::WindowText);
    QColor grid = ink;
    grid.setAlphaF(0.12F);
    chart()->setBackgroundBrush(palette().color(QPalette::Window));
    chart()->legend()->setLabelColor(ink);
    chart()->setTitleBrush(ink);
    for (QValueAxis* axis : {time_, value_}) {
        axis->setLabelsColor(ink);
        axis->setTitleBrush(ink);
        axis->setGridLineColor(grid);
        axis->setLinePen(QPen(grid, 1));
    }
    measured_->setColor(QColor(dark ? "#c79be0" : "#7a3f98"));
    measured_->setBorderColor(palette().color(QPalette::Window));
    before_->setPen(QPen(QColor(dark ? "#a8b2bb" : "#5b6570"), 2, Qt::DashLine));
    fitted_->setPen(QPen(QColor(dark ? "#5ab0e8" : "#0b6aa8"), 2));
}

void FitChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && measured_) { applyPalette(); }
    PointedChartView::changeEvent(event);
}

} // namespace hygroloom
