// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/scatter_view.h"

#include "core/analysis/comparative.h"
#include "core/base/text.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity.h"
#include "ui/compare/chart_style.h"
#include "ui/results/pointed_chart_view.h"
#include "ui/results/report_file.h"

#include <QChart>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineSeries>
#include <QScatterSeries>
#include <QSignalBlocker>
#include <QValueAxis>

#include <algorithm>
#include <limits>
#include <string_view>

namespace hygroloom {

namespace {

QString titleOf(const OutcomeInfo& info)
{
    QString title = coreTitle(info.title, info.part);
    title = title.left(1).toUpper() + title.mid(1);
    const QString unit = userUnit(QString::fromStdString(shown(info, 0.0).unit)).unit;
    return unit.isEmpty() ? title : QString("%1 (%2)").arg(title, unit);
}

QString directionOf(const OutcomeInfo& info)
{
    if (info.better == Better::neither) { return {}; }
    const std::string_view word = comparative(info, info.better == Better::more);
    if (word == "shorter") { return ScatterView::tr("shorter is better"); }
    if (word == "longer") { return ScatterView::tr("longer is better"); }
    if (word == "smaller") { return ScatterView::tr("smaller is better"); }
    if (word == "larger") { return ScatterView::tr("larger is better"); }
    return word == "lower" ? ScatterView::tr("lower is better") : ScatterView::tr("higher is better");
}

/// "Wetted radius, top: 3.25 ± 0.04 mm"
QString numberOf(const OutcomeInfo& info, const Interval& interval)
{
    const QString title = coreTitle(info.title, info.part);
    const ReaderUnits units = unitsOfReader();
    const std::string number = with_interval(info, interval, units) + " " + units(shown(info, interval).unit).unit;
    return QString("%1: %2").arg(title.left(1).toUpper() + title.mid(1), QString::fromStdString(number).trimmed());
}

std::vector<ScatterPoint> pointsOf(const Comparison& comparison, std::size_t x, std::size_t y)
{
    const OutcomeInfo &one = comparison.criteria[x], &other = comparison.criteria[y];
    const ReaderUnits units = unitsOfReader();
    std::vector<ScatterPoint> points;
    for (const Candidate& each : comparison.candidates) {
        const auto a = each.intervals.find(one.key), b = each.intervals.find(other.key);
        if (a == each.intervals.end() || b == each.intervals.end()) { continue; }
        const auto at = [&](double Interval::*part) {
            const ShownValue across = shown(one, a->second.*part), up = shown(other, b->second.*part);
            return QPointF(units(across.unit).of(across.value), units(up.unit).of(up.value));
        };
        const QString name = QString::fromStdString(each.fabric);
        points.push_back({at(&Interval::low), at(&Interval::centre), at(&Interval::high), name,
                          QString("%1\n%2\n%3").arg(name, numberOf(one, a->second), numberOf(other, b->second))});
    }
    return points;
}

/// The names of all at its place, beside the first of them.
QString labelOf(const std::vector<ScatterPoint>& points, std::size_t of)
{
    QStringList names;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].at != points[of].at) { continue; }
        if (i < of) { return {}; }
        names << points[i].name;
    }
    return names.join(", ");
}

/// The last number in which candidates differ.
int secondOf(const Comparison& comparison)
{
    for (int i = static_cast<int>(comparison.criteria.size()) - 1; i > 0; --i) {
        std::optional<double> first;
        for (const Candidate& each : comparison.candidates) {
            const auto found = each.intervals.find(comparison.criteria[static_cast<std::size_t>(i)].key);
            if (found == each.intervals.end()) { continue; }
            if (first && *first != found->second.centre) { return i; }
            first = found->second.centre;
        }
    }
    return 0;
}

} // namespace

ScatterView::ScatterView(QWidget* parent)
    : QWidget(parent), x_(new QComboBox), y_(new QComboBox), value_(new QLabel), chart_(new QChart), view_(new PointedChartView(chart_)),
      across_(new QValueAxis), up_(new QValueAxis), note_(makeNote(tr("What the scatter shows")))
{
    view_->setRenderHint(QPainter::Antialiasing);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setAccessibleName(tr("Two numbers of all candidates"));
    view_->setMinimumSize(200, 120);
    x_->setAccessibleName(tr("Number across"));
    y_->setAccessibleName(tr("Number upwards"));
    value_->setAccessibleName(tr("Candidate under the pointer"));
    value_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long name does not widen the window
    chart_->addAxis(across_, Qt::AlignBottom);
    chart_->addAxis(up_, Qt::AlignLeft);
    for (QValueAxis* axis : {across_, up_}) { axis->setLabelFormat("%g"); }
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 6, 8, 0);
    head->addWidget(new QLabel(tr("Across:")));
    head->addWidget(x_);
    head->addSpacing(8);
    head->addWidget(new QLabel(tr("Upwards:")));
    head->addWidget(y_);
    head->addSpacing(12);
    head->addWidget(value_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(head);
    layout->addWidget(view_, 1);
    layout->addWidget(note_);
    connect(view_, &PointedChartView::pointed, this, [this](QString words) { value_->setText(words.replace('\n', ", ")); });
    connect(chart_, &QChart::plotAreaChanged, this, &ScatterView::placeLabels);
    connect(x_, &QComboBox::currentIndexChanged, this, &ScatterView::draw);
    connect(y_, &QComboBox::currentIndexChanged, this, &ScatterView::draw);
    for (QComboBox* box : {x_, y_}) {
        connect(box, &QComboBox::activated, this, [this] { proposing_ = false; });
    }
}

void ScatterView::setComparison(const Comparison& comparison)
{
    comparison_ = comparison;
    QStringList titles;
    for (const OutcomeInfo& info : comparison_.criteria) { titles << titleOf(info); }
    const auto fill = [this, &titles](QComboBox* box, int first) {
        const QSignalBlocker quiet(box);
        const QString at = box->currentText();
        box->clear();
        box->addItems(titles);
        const int known = proposing_ ? -1 : box->findText(at); // what the user has chosen stays
        box->setCurrentIndex(known >= 0 ? known : std::min(first, static_cast<int>(titles.size()) - 1));
        box->setEnabled(titles.size() > 1);
    };
    fill(x_, 0);
    fill(y_, secondOf(comparison_));
    draw();
}

void ScatterView::choose(int x, int y)
{
    x_->setCurrentIndex(x);
    y_->setCurrentIndex(y);
}

void ScatterView::add(QXYSeries* series)
{
    chart_->addSeries(series);
    series->attachAxis(across_);
    series->attachAxis(up_);
}

void ScatterView::addPoint(const ScatterPoint& point, const QString& label, bool on_front)
{
    const QColor ink = strokeOf(0, palette()).color();
    QColor faint = ink;
    faint.setAlphaF(0.55F);
    for (const auto& [from, to] : {std::pair(QPointF(point.low.x(), point.at.y()), QPointF(point.high.x(), point.at.y())),
                                   std::pair(QPointF(point.at.x(), point.low.y()), QPointF(point.at.x(), point.high.y()))}) {
        auto* bar = new QLineSeries;
        bar->append(from);
        bar->append(to);
        bar->setPen(QPen(faint, 1.5));
        add(bar);
    }
    auto* marker = new QScatterSeries;
    marker->append(point.at);
    marker->setMarkerSize(on_front ? 12 : 9);
    marker->setColor(on_front ? ink : palette().color(QPalette::Window));
    marker->setBorderColor(ink);
    marker->setPen(QPen(ink, 1.5));
    marker->setPointLabelsFormat(QString(label).remove('@')); // which begins a number in it
    marker->setPointLabelsColor(palette().color(QPalette::WindowText));
    marker->setPointLabelsClipping(false);
    add(marker);
    if (!label.isEmpty()) { labels_.push_back({marker, label, on_front}); }
    view_->tell(marker, PointedChartView::Told::points, [words = point.words](const QPointF&) { return words; });
}

void ScatterView::setRange(QValueAxis* axis, double low, double high)
{
    const double room = high > low ? 0.12 * (high - low) : std::max(0.5 * std::abs(low), 1e-3);
    axis->setRange(low - room, high + room);
    axis->applyNiceNumbers();
}

void ScatterView::draw()
{
    view_->forget();
    chart_->removeAllSeries();
    front_.clear();
    labels_.clear();
    value_->clear();
    const int x = x_->currentIndex(), y = y_->currentIndex();
    std::vector<ScatterPoint> points;
    if (x >= 0 && y >= 0) { points = pointsOf(comparison_, static_cast<std::size_t>(x), static_cast<std::size_t>(y)); }
    view_->setVisible(!points.empty());
    note_->setText(tr("There is nothing to draw yet: run the experiment on the fabrics."));
    if (points.empty()) { return; }
    const OutcomeInfo &one = comparison_.criteria[static_cast<std::size_t>(x)], &other = comparison_.criteria[static_cast<std::size_t>(y)];
    std::vector<QPointF> centres;
    centres.reserve(points.size());
    for (const ScatterPoint& point : points) { centres.push_back(point.at); }
    const std::vector<std::size_t> front = paretoFront(centres, one.better, other.better);
    auto* line = new QLineSeries;
    for (const std::size_t i : front) {
        line->append(centres[i]);
        front_ << points[i].name;
    }
    line->setPen(QPen(strokeOf(1, palette()).color(), 1.5, Qt::DashLine));
    add(line);
    QPointF low = points.front().at, high = low;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ScatterPoint& point = points[i];
        addPoint(point, labelOf(points, i), std::find(front.begin(), front.end(), i) != front.end());
        low = {std::min({low.x(), point.low.x(), point.high.x()}), std::min({low.y(), point.low.y(), point.high.y()})};
        high = {std::max({high.x(), point.low.x(), point.high.x()}), std::max({high.y(), point.low.y(), point.high.y()})};
    }
    across_->setTitleText(titleOf(one));
    up_->setTitleText(titleOf(other));
    setRange(across_, low.x(), high.x());
    setRange(up_, low.y(), high.y());
    styleChart(*chart_, *this);
    placeLabels();
    note_->setText(
        tr("Bars: the intervals of the table. Filled and connected: no other candidate is better in both numbers, by their middles "
           "(across: %1; upwards: %2).")
            .arg(directionOf(one), directionOf(other)));
}

/// Names that would lie over each other are left out, those beside the front first; under the pointer each is told.
void ScatterView::placeLabels()
{
    std::vector<QRectF> taken;
    for (const bool front : {true, false}) {
        for (const Label& label : labels_) {
            if (label.on_front != front) { continue; }
            const QFontMetricsF metrics(label.marker->pointLabelsFont());
            const QPointF at = chart_->mapToPosition(label.marker->points().front(), label.marker);
            const QSizeF size(metrics.horizontalAdvance(label.text), metrics.height());
            const QRectF room(at.x() - 0.5 * size.width(), at.y() - 0.5 * label.marker->markerSize() - size.height(), size.width(),
                              size.height());
            const bool free = std::none_of(taken.begin(), taken.end(), [&room](const QRectF& other) { return other.intersects(room); });
            if (free) { taken.push_back(room); }
            label.marker->setPointLabelsVisible(free);
        }
    }
}

QStringList ScatterView::labels() const
{
    QStringList seen;
    for (const Label& label : labels_) {
        if (label.marker->pointLabelsVisible()) { seen << label.text; }
    }
    return seen;
}

void ScatterView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && note_) { draw(); }
    QWidget::changeEvent(event);
}

} // namespace hygroloom
