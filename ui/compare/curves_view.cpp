// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/curves_view.h"

#include "core/base/text.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity.h"
#include "ui/compare/chart_style.h"
#include "ui/results/curve_legend.h"
#include "ui/results/pointed_chart_view.h"
#include "ui/results/water_map.h"

#include <QAreaSeries>
#include <QChart>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineSeries>
#include <QSignalBlocker>
#include <QValueAxis>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

namespace {

constexpr double band_height = 10; // pixels, in the legend

QColor bandOf(const QPen& pen)
{
    QColor fill = pen.color();
    fill.setAlphaF(0.18F);
    return fill;
}

/// "Cotton: 5.2 mm at 3.1 s (4.8 to 5.9)"
QString wordsAt(const QString& title, const QString& unit, const CurvePoints& points, const QPointF& at)
{
    const auto text = [](double number) { return shownNumber(number, decimals_for(number, 3)); };
    const QString words = CurvesView::tr("%1: %2 %3 at %4 s").arg(title, text(at.y()), unit, text(at.x()));
    const auto after =
        std::lower_bound(points.values.begin(), points.values.end(), at.x(), [](const QPointF& point, double x) { return point.x() < x; });
    if (points.low.empty() || after == points.values.end()) { return words; }
    const auto i = static_cast<std::size_t>(after - points.values.begin());
    const auto between = [&](const std::vector<double>& edge) {
        if (i == 0) { return edge[0]; }
        const double from = points.values[i - 1].x(), to = points.values[i].x();
        return to > from ? edge[i - 1] + (at.x() - from) / (to - from) * (edge[i] - edge[i - 1]) : edge[i];
    };
    const QString band = points.replicates > 0 ? replicateRange(points.replicates) : CurvesView::tr("numerical error");
    return CurvesView::tr("%1 (%2: %3 to %4)").arg(words, band, text(between(points.low)), text(between(points.high)));
}

} // namespace

CurvesView::CurvesView(QWidget* parent)
    : QWidget(parent), curve_(new QComboBox), value_(new QLabel), chart_(new QChart), view_(new PointedChartView(chart_)),
      time_(new QValueAxis), axis_(new QValueAxis), legend_(new CurveLegend), note_(makeNote(tr("What the bands are")))
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
    connect(view_, &PointedChartView::pointed, value_, &QLabel::setText);
}

QString CurvesView::note() const { return note_->text(); }

const Candidate* CurvesView::candidateOf(std::size_t run) const
{
    const std::string name = titles_[static_cast<qsizetype>(run)].toStdString();
    const auto found = std::find_if(comparison_.candidates.begin(), comparison_.candidates.end(),
                                    [&name](const Candidate& each) { return each.fabric == name; });
    return found == comparison_.candidates.end() ? nullptr : &*found;
}

void CurvesView::setRuns(const std::vector<KeptRun>& runs, const QStringList& titles, const Comparison& comparison,
                         const WearPartName& part)
{
    comparison_ = comparison;
    runs_ = runs;
    titles_ = titles;
    choices_.clear();
    if (!runs.empty() && runs.front().worn) {
        choices_ = curvesOf(part);
    } else if (!runs.empty()) {
        std::vector<std::shared_ptr<const Metrics>> metrics;
        metrics.reserve(runs.size());
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

CurvePoints CurvesView::pointsOfRun(std::size_t run, const CurveChoice& choice) const
{
    const Candidate* candidate = candidateOf(run);
    if (runs_[run].worn) { return pointsOf(candidate ? *candidate : *runs_[run].numbers, choice); }
    return pointsOf(*runs_[run].run, *runs_[run].metrics, choice, candidate);
}

std::optional<int> CurvesView::addRun(std::size_t run, const CurveChoice& choice)
{
    const CurvePoints points = pointsOfRun(run, choice);
    if (!points.values.empty()) { end_ = std::max(end_, points.values.back().x()); }
    const bool banded = !points.low.empty();
    const QPen pen = strokeOf(run, palette());
    auto* line = new QLineSeries;
    auto* low = new QLineSeries;
    auto* high = new QLineSeries;
    for (std::size_t i = 0; i < points.values.size(); ++i) {
        const QPointF& at = points.values[i];
        const double least = banded ? points.low[i] : at.y(), most = banded ? points.high[i] : at.y();
        line->append(at);
        low->append(at.x(), least);
        high->append(at.x(), most);
        lowest_ = std::min(lowest_, least);
        highest_ = std::max(highest_, most);
    }
    line->setPen(pen);
    std::vector<QAbstractSeries*> made;
    if (!banded) {
        delete low;
        delete high;
    } else {
        auto* band = new QAreaSeries(high, low);
        low->setParent(band);
        high->setParent(band);
        band->setBrush(bandOf(pen));
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
    view_->tell(line, PointedChartView::Told::curve,
                [title = titles_[static_cast<qsizetype>(run)], unit = coreWord(choice.unit.unit), points](const QPointF& at) {
                    return wordsAt(title, unit, points, at);
                });
    return banded ? std::optional(points.replicates) : std::nullopt;
}

QString CurvesView::noteOf(const CurveChoice& choice, const std::vector<std::optional<int>>& bands) const
{
    QStringList sentences;
    const auto by_replicates = [](const std::optional<int>& band) { return band.value_or(0) > 0; };
    if (std::any_of(bands.begin(), bands.end(), by_replicates)) {
        sentences
            << tr("With replicates the line is their middle, and the band goes from the least to the most of them; of %1 and more, from "
                  "the 5th to the 95th percentile.")
                   .arg(fewest_for_percentiles);
    }
    QStringList alone, incomplete;
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const QString title = titles_[static_cast<qsizetype>(i)];
        const Candidate* candidate = candidateOf(i);
        const auto there = [](const std::optional<ReplicateRun>& run) { return run.has_value(); };
        const auto runs = candidate ? std::count_if(candidate->replicates.begin(), candidate->replicates.end(), there) : 0;
        if (bands[i].value_or(0) == 0) { alone << title; }
        if (runs > 1 && runs > bands[i].value_or(0)) { incomplete << title; }
    }
    if (alone.size() == static_cast<qsizetype>(bands.size())) {
        const QString of = bandText(choice);
        sentences << (bands_ > 0 ? tr("Band: the numerical error of %1, as measured on runs of this kind.").arg(of)
                                 : tr("No numerical error of this curve is known, so there is no band."));
    } else if (!alone.isEmpty()) {
        sentences << tr("Of %1 the cloth as given is drawn, with its numerical error where that is known.").arg(alone.join(", "));
    }
    if (!incomplete.isEmpty()) {
        sentences << tr("Of %1 some replicates were computed by a version that kept no curves, or are too old: they are not in the band.")
                         .arg(incomplete.join(", "));
    }
    return sentences.join(' ');
}

void CurvesView::draw()
{
    view_->forget();
    chart_->removeAllSeries();
    lines_ = bands_ = 0;
    band_names_.clear();
    value_->clear();
    const int at = curve_->currentIndex();
    std::vector<CurveLegend::Entry> entries;
    lowest_ = std::numeric_limits<double>::infinity();
    highest_ = -lowest_;
    end_ = 0;
    if (at >= 0) {
        const CurveChoice& choice = choices_[static_cast<std::size_t>(at)];
        std::vector<std::optional<int>> bands;
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            bands.push_back(addRun(i, choice));
            const QPen pen = strokeOf(i, palette());
            entries.push_back({titles_[static_cast<qsizetype>(i)], pen});
            if (bands.back()) {
                band_names_ << (*bands.back() > 0 ? replicateRange(*bands.back()) : tr("numerical error"));
                entries.push_back({band_names_.back(), QPen(bandOf(pen), band_height)});
            }
        }
        axis_->setTitleText(choice.title);
        const bool rounding = std::abs(lowest_) < 1e-6 * highest_; // less than nothing by a rounding is nothing
        if (choice.fromZero() || rounding) { lowest_ = 0; }
        note_->setText(noteOf(choice, bands));
    } else {
        note_->setText(tr("Tick two to four fabrics above to see their curves over each other."));
    }
    view_->setVisible(at >= 0);
    legend_->setEntries(entries);
    time_->setRange(0, end_ > 0 ? end_ : 1);
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
