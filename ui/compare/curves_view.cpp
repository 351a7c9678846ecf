// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/curves_view.h"

#include "core/base/text.h"
#include "ui/basics/quantity.h"
#include "ui/compare/chart_style.h"
#include "ui/results/curve_legend.h"

#include <QAreaSeries>
#include <QChart>
#include <QChartView>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineSeries>
#include <QSignalBlocker>
#include <QValueAxis>

#include <algorithm>
#include <limits>

namespace hygroloom {

CurvesView::CurvesView(QWidget* parent)
    : QWidget(parent), curve_(new QComboBox), value_(new QLabel), chart_(new QChart), view_(new QChartView(chart_)), time_(new QValueAxis),
      axis_(new QValueAxis), legend_(new CurveLegend), note_(makeNote(tr("What the bands are")))
{
    curve_->setAccessibleName(tr("Curve"));
    value_->setAccessibleName(tr("Value under the pointer"));
    view_->setRenderHint(QPainter::Antialiasing);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setAccessibleName(tr("Curves of the ticked runs"));
    view_->setMinimumSize(200, 120);
    time_->setLabelFormat("%g");
    time_->setTitleText(tr("Time (s)"));
    axis_->setLabelFormat("%g");
    chart_->addAxis(time_, Qt::AlignBottom);
    chart_->addAxis(axis_, Qt::AlignLeft);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 6, 8, 0);
    head->addWidget(curve_);
    head->addSpacing(12);
    head->addWidget(value_, 1);
    auto* middle = new QHBoxLayout;
    middle->setContentsMargins(0, 0, 8, 0);
    middle->addWidget(view_, 1);
    middle->addWidget(legend_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(head);
    layout->addLayout(middle, 1);
    layout->addWidget(note_);
    connect(curve_, &QComboBox::currentIndexChanged, this, &CurvesView::draw);
}

void CurvesView::setRuns(const std::vector<KeptRun>& runs, const QStringList& titles)
{
    runs_ = runs;
    titles_ = titles;
    choices_.clear();
    if (!runs.empty()) {
        std::vector<std::shared_ptr<const Metrics>> metrics;
        for (const KeptRun& run : runs) { metrics.push_back(run.metrics); }
        const Experiment* experiment = find_experiment(runs.front().run->design, runs.front().run->experiment);
        choices_ = curvesOf(experiment ? experiment->type : ExperimentType::droplet, metrics);
    }
    {
        const QSignalBlocker quiet(curve_);
        const QString at = curve_->currentText();
        curve_->clear();
        for (const CurveChoice& choice : choices_) { curve_->addItem(choice.title); }
        curve_->setCurrentIndex(std::max(choices_.empty() ? -1 : 0, curve_->findText(at)));
        curve_->setEnabled(!choices_.empty());
    }
    draw();
}

void CurvesView::addRun(std::size_t run, const CurveChoice& choice)
{
    const CurvePoints points = pointsOf(*runs_[run].run, *runs_[run].metrics, choice);
    const QPen pen = strokeOf(run, palette());
    auto* line = new QLineSeries;
    auto* low = new QLineSeries;
    auto* high = new QLineSeries;
    for (std::size_t i = 0; i < points.values.size(); ++i) {
        const QPointF& at = points.values[i];
        const double half = points.half.empty() ? 0 : points.half[i];
        line->append(at);
        low->append(at.x(), at.y() - half);
        high->append(at.x(), at.y() + half);
        lowest_ = std::min(lowest_, at.y() - half);
        highest_ = std::max(highest_, at.y() + half);
    }
    line->setPen(pen);
    std::vector<QAbstractSeries*> made;
    if (points.half.empty()) {
        delete low;
        delete high;
    } else {
        auto* band = new QAreaSeries(high, low);
        low->setParent(band);
        high->setParent(band);
        QColor fill = pen.color();
        fill.setAlphaF(0.18F);
        band->setBrush(fill);
        band->setPen(Qt::NoPen);
        made.push_back(band);
        ++bands_;
    }
    made.push_back(line);
    ++lines_;
    for (QAbstractSeries* series : made) {
        chart_->addSeries(series);
        series->attachAxis(time_);
        series->attachAxis(axis_);
    }
    connect(line, &QLineSeries::hovered, this,
            [this, title = titles_[static_cast<qsizetype>(run)], unit = choice.plot->unit](QPointF at, bool on) {
                value_->setText(
                    on ? tr("%1: %2 %3 at %4 s")
                             .arg(title, shownNumber(at.y(), decimals_for(at.y(), 3)), unit, shownNumber(at.x(), decimals_for(at.x(), 3)))
                       : QString());
            });
}

void CurvesView::draw()
{
    chart_->removeAllSeries();
    lines_ = bands_ = 0;
    value_->clear();
    const int at = curve_->currentIndex();
    std::vector<CurveLegend::Entry> entries;
    lowest_ = std::numeric_limits<double>::infinity();
    highest_ = -lowest_;
    double end = 0;
    if (at >= 0) {
        const CurveChoice& choice = choices_[static_cast<std::size_t>(at)];
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            addRun(i, choice);
            entries.push_back({titles_[static_cast<qsizetype>(i)], strokeOf(i, palette())});
            const auto& time = runs_[i].metrics->series.time;
            if (!time.empty()) { end = std::max(end, time.back()); }
        }
        axis_->setTitleText(choice.title);
        if (choice.plot->from_zero) { lowest_ = 0; }
        const QString of = bandText(choice);
        note_->setText(bands_ > 0
                           ? tr("Band: the numerical error of %1, as measured on runs of this kind. Replicates keep no curves.").arg(of)
                           : tr("No numerical error of this curve is known, so there is no band."));
    } else {
        note_->setText(tr("Tick two to four fabrics above to see their curves over each other."));
    }
    view_->setVisible(at >= 0);
    legend_->setEntries(entries);
    time_->setRange(0, end > 0 ? end : 1);
    const double room = highest_ > lowest_ ? 0.06 * (highest_ - lowest_) : 1;
    if (lowest_ <= highest_) {
        axis_->setRange(lowest_ == 0 ? 0 : lowest_ - room, highest_ + room);
        axis_->applyNiceNumbers();
    }
    styleChart(*chart_, *this);
}

void CurvesView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && note_) { draw(); }
    QWidget::changeEvent(event);
}

} // namespace hygroloom
