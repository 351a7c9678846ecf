// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/fingerprint_view.h"

#include "ui/compare/chart_style.h"
#include "ui/results/curve_legend.h"
#include "ui/results/pointed_chart_view.h"

#include <QCategoryAxis>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineSeries>
#include <QPolarChart>
#include <QValueAxis>

#include <cmath>

namespace hygroloom {

namespace {

constexpr qsizetype fewest_spokes = 3;
constexpr double smallest_rim = 60; // pixels from the middle, in the smallest view

} // namespace

FingerprintView::FingerprintView(QWidget* parent)
    : QWidget(parent), chart_(new QPolarChart), view_(new PointedChartView(chart_)), legend_(new CurveLegend),
      note_(makeNote(tr("What the fingerprint shows")))
{
    view_->setRenderHint(QPainter::Antialiasing);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setAccessibleName(tr("Fingerprint of the ticked runs"));
    view_->setMinimumSize(200, 120);
    auto* middle = new QHBoxLayout;
    middle->setContentsMargins(0, 0, 8, 0);
    middle->addWidget(view_, 1);
    middle->addWidget(legend_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(middle, 1);
    layout->addWidget(note_);
}

void FingerprintView::setCandidates(const Comparison& comparison, const std::vector<std::string>& names)
{
    shown_ = fingerprintOf(comparison, names);
    candidates_ = comparison.candidates.size();
    titles_.clear();
    for (const std::string& name : names) { titles_ << QString::fromStdString(name); }
    draw();
}

/// New ones each time: Qt keeps the categories of an axis that it has drawn.
void FingerprintView::addAxes()
{
    for (QAbstractAxis* axis : chart_->axes()) {
        chart_->removeAxis(axis);
        delete axis;
    }
    auto* spokes = new QCategoryAxis;
    spokes->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
    spokes->setRange(0, static_cast<double>(shown_.spokes.size()));
    for (qsizetype i = 0; i < shown_.spokes.size(); ++i) { spokes->append(shown_.spokes[i], static_cast<double>(i)); }
    auto* rim = new QValueAxis;
    rim->setRange(0, shown_.most);
    rim->setTickCount(shown_.grades ? 6 : 3);
    rim->setLabelFormat(shown_.grades ? "%.0f" : "%g");
    chart_->addAxis(spokes, QPolarChart::PolarOrientationAngular);
    chart_->addAxis(rim, QPolarChart::PolarOrientationRadial);
}

void FingerprintView::draw()
{
    view_->forget();
    chart_->removeAllSeries();
    const qsizetype spokes = shown_.spokes.size();
    const bool drawn = !shown_.runs.empty() && spokes >= fewest_spokes;
    view_->setVisible(drawn);
    std::vector<CurveLegend::Entry> entries;
    if (drawn) {
        addAxes();
        const std::vector<int> later = laterOn(shown_, strokeOf(0, palette()).widthF() / smallest_rim);
        for (std::size_t i = 0; i < shown_.runs.size(); ++i) {
            auto* line = new QLineSeries;
            for (qsizetype k = 0; k <= spokes; ++k) {
                const double value = shown_.runs[i][static_cast<std::size_t>(k % spokes)];
                if (value >= 0) { line->append(static_cast<double>(k), value); }
            }
            QPen pen = strokeOf(i, palette());
            pen.setWidthF(pen.widthF() * (1 + later[i])); // what lies on it leaves its edges free
            pen.setCapStyle(Qt::FlatCap);
            line->setPen(pen);
            line->setPointsVisible(true);
            chart_->addSeries(line);
            for (QAbstractAxis* axis : chart_->axes()) { line->attachAxis(axis); }
            view_->tell(line, PointedChartView::Told::points, [this, i](const QPointF& at) {
                const auto spoke = static_cast<qsizetype>(std::lround(at.x())) % shown_.spokes.size();
                return QString("%1\n%2: %3").arg(titles_.value(static_cast<qsizetype>(i)), shown_.spokes[spoke], shown_.numbers[i][spoke]);
            });
            entries.push_back({titles_.value(static_cast<qsizetype>(i)), line->pen()});
        }
        styleChart(*chart_, *this);
    }
    legend_->setEntries(entries);
    if (shown_.runs.empty()) {
        note_->setText(tr("Tick two to four fabrics above to see their fingerprints."));
    } else if (!drawn) {
        note_->setText(tr("A fingerprint needs three numbers or more; this experiment has %1. See Scatter.").arg(spokes));
    } else if (shown_.grades) {
        note_->setText(tr("Grades of AATCC 195 of each cloth as given: 1 poor (inside) to 5 excellent (rim)."));
    } else {
        note_->setText(tr("Each number from the worst (middle) to the best (rim) of the %1 candidates in the table. Differences are drawn "
                          "however small they are: the table says which are real.")
                           .arg(candidates_));
    }
}

void FingerprintView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && note_) { draw(); }
    QWidget::changeEvent(event);
}

} // namespace hygroloom
