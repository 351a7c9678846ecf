// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/effects_view.h"

#include "ui/compare/chart_style.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

namespace {

constexpr std::size_t most_factors = 16;

/// Over the bands of all factors, so that their effects can be compared.
StudyAxis commonAxis(const std::vector<std::vector<EffectBin>>& effects)
{
    StudyAxis up;
    up.low = std::numeric_limits<double>::infinity();
    up.high = -up.low;
    for (const std::vector<EffectBin>& effect : effects) {
        for (const EffectBin& bin : effect) {
            up.low = std::min(up.low, bin.mean - bin.sd);
            up.high = std::max(up.high, bin.mean + bin.sd);
        }
    }
    up.empty = !(up.low <= up.high);
    if (up.low == up.high) {
        up.low -= 0.5;
        up.high += 0.5;
    }
    return up;
}

} // namespace

EffectsChart::EffectsChart(QWidget* parent) : StudyChart(parent)
{
    setAccessibleName(tr("Main effects of the factors"));
    setFocusPolicy(Qt::NoFocus);
}

void EffectsChart::setMetric(const StudyAxis* metric)
{
    metric_ = metric;
    redraw();
}

QString EffectsChart::tipAt(const QPointF& position) const
{
    constexpr double reach = 12; // pixels
    const auto off = [&position](const auto& each) { return QLineF(each.first, position).length(); };
    const auto nearest =
        std::min_element(told_.begin(), told_.end(), [&off](const auto& one, const auto& other) { return off(one) < off(other); });
    return nearest != told_.end() && off(*nearest) <= reach ? nearest->second : QString();
}

void EffectsChart::drawPicture(QPainter& painter)
{
    painter.setRenderHint(QPainter::Antialiasing);
    told_.clear();
    if (!metric_) { return; }
    std::vector<const StudyAxis*> factors;
    for (const StudyAxis& axis : data_->axes) {
        if (axis.is_factor && !axis.empty && factors.size() < most_factors) { factors.push_back(&axis); }
    }
    std::vector<std::vector<EffectBin>> effects;
    effects.reserve(factors.size());
    for (const StudyAxis* factor : factors) { effects.push_back(effectBins(*factor, *metric_)); }
    const StudyAxis up = commonAxis(effects);
    if (up.empty) { return; }
    const int count = static_cast<int>(factors.size());
    const int columns = std::max(1, std::min(count, static_cast<int>(std::ceil(std::sqrt(count)))));
    const int rows = (count + columns - 1) / columns;
    const double line = QFontMetricsF(font()).height(), wide = double(width()) / columns, high = double(height()) / rows;
    for (int i = 0; i < count; ++i) {
        const int row = i / columns, column = i % columns;
        const QRectF cell(column * wide, row * high, wide, high);
        const QRectF area = cell.adjusted(66, line + 10, -16, -line - 10);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QRectF(area.left(), cell.top() + 4, area.width(), line), Qt::AlignCenter,
                         painter.fontMetrics().elidedText(factors[static_cast<std::size_t>(i)]->title, Qt::ElideMiddle, int(area.width())));
        drawEffect(painter, area, *factors[static_cast<std::size_t>(i)], up, effects[static_cast<std::size_t>(i)]);
    }
}

void EffectsChart::drawEffect(QPainter& painter, const QRectF& area, const StudyAxis& factor, const StudyAxis& up,
                              const std::vector<EffectBin>& effect)
{
    drawAxes(painter, area, factor, up, palette());
    const auto at = [&](const EffectBin& bin, double sds) {
        return QPointF(area.left() + factor.placeOf(bin.at) * area.width(),
                       area.bottom() - up.placeOf(bin.mean + sds * bin.sd) * area.height());
    };
    const QColor ink = strokeOf(0, palette()).color();
    QColor faint = ink;
    faint.setAlphaF(0.2F);
    if (factor.words.empty()) {
        QPolygonF band, line;
        for (const EffectBin& bin : effect) {
            band << at(bin, 1);
            line << at(bin, 0);
        }
        for (auto bin = effect.rbegin(); bin != effect.rend(); ++bin) { band << at(*bin, -1); }
        painter.setPen(Qt::NoPen);
        painter.setBrush(faint);
        painter.drawPolygon(band);
        painter.setPen(QPen(ink, 2));
        painter.drawPolyline(line);
    }
    for (const EffectBin& bin : effect) {
        painter.setPen(QPen(ink, 1.5));
        if (!factor.words.empty()) { painter.drawLine(at(bin, -1), at(bin, 1)); }
        painter.setBrush(ink);
        painter.drawEllipse(at(bin, 0), 3, 3);
        told_.emplace_back(at(bin, 0), tr("%1 %2: mean %3 of %4, standard deviation %5, %6 rows")
                                           .arg(factor.title, factor.text(bin.at), up.text(bin.mean), metric_->title, up.text(bin.sd))
                                           .arg(bin.count));
    }
    painter.setBrush(Qt::NoBrush);
}

EffectsView::EffectsView(QWidget* parent) : QWidget(parent), metric_(new QComboBox), chart_(new EffectsChart)
{
    metric_->setAccessibleName(tr("Metric of the effects"));
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 6, 8, 0);
    head->addWidget(new QLabel(tr("Metric:")));
    head->addWidget(metric_);
    head->addStretch();
    QLabel* note = makeNote(tr("What the effects show"));
    note->setText(
        tr("Line: the mean over all rows near a factor's value, whatever the others are. Band: one standard deviation of the rows "
           "either way."));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addWidget(chart_, 1);
    layout->addWidget(note);
    connect(metric_, &QComboBox::currentIndexChanged, this, [this] { chart_->setMetric(chosenAxis(*metric_, data_.get())); });
}

void EffectsView::setStudy(const std::shared_ptr<const StudyData>& study)
{
    chart_->setMetric(nullptr); // it is of the study before
    data_ = study;
    fillAxes(*metric_, study.get(), false, true, 0);
    chart_->setStudy(study);
    chart_->setMetric(chosenAxis(*metric_, study.get()));
}

} // namespace hygroloom
