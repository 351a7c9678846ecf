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

namespace hygroloom {

namespace {

constexpr std::size_t most_factors = 16;

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
        drawEffect(painter, area, *factors[static_cast<std::size_t>(i)]);
    }
}

void EffectsChart::drawEffect(QPainter& painter, const QRectF& area, const StudyAxis& factor)
{
    const StudyAxis& up = *metric_; // the same for all factors, so that their effects can be compared
    drawAxes(painter, area, factor, up, palette());
    const auto at = [&](double along, double value) {
        return QPointF(area.left() + factor.placeOf(along) * area.width(), area.bottom() - up.placeOf(value) * area.height());
    };
    const QColor ink = strokeOf(0, palette()).color();
    QColor faint = ink, dots = palette().color(QPalette::Text);
    faint.setAlphaF(0.25F);
    dots.setAlphaF(data_->table.rows() > 500 ? 0.25F : 0.5F);
    painter.save();
    painter.setClipRect(area.adjusted(-4, -4, 4, 4)); // the band of a mean may pass all rows
    QPolygonF rows;
    for (std::size_t row = 0; row < up.numbers.size(); ++row) {
        if (std::isfinite(up.numbers[row]) && std::isfinite(factor.numbers[row])) { rows << at(factor.numbers[row], up.numbers[row]); }
    }
    painter.setPen(QPen(dots, 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawPoints(rows);
    const EffectCurve effect = effectCurve(factor, up);
    if (effect.smooth) {
        QPolygonF band, line;
        for (const EffectPoint& point : effect.points) {
            band << at(point.at, point.mean + point.off);
            line << at(point.at, point.mean);
        }
        for (auto point = effect.points.rbegin(); point != effect.points.rend(); ++point) {
            band << at(point->at, point->mean - point->off);
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(faint);
        painter.drawPolygon(band);
        painter.setPen(QPen(ink, 2));
        painter.drawPolyline(line);
    } else {
        painter.setBrush(ink);
        for (const EffectPoint& point : effect.points) {
            painter.setPen(QPen(ink, 2));
            if (std::isfinite(point.off)) { painter.drawLine(at(point.at, point.mean - point.off), at(point.at, point.mean + point.off)); }
            painter.drawEllipse(at(point.at, point.mean), 4, 4);
        }
    }
    painter.setBrush(Qt::NoBrush);
    painter.restore();
    for (const EffectPoint& point : effect.points) {
        const QString mean =
            std::isfinite(point.off)
                ? tr("%1 %2: mean %3 ± %4 of %5, %6 rows").arg(factor.title, factor.text(point.at), up.text(point.mean), up.text(point.off))
                : tr("%1 %2: %3 of %4, %5 row").arg(factor.title, factor.text(point.at), up.text(point.mean));
        told_.emplace_back(at(point.at, point.mean), mean.arg(metric_->title).arg(point.rows));
    }
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
        tr("Points: the rows. Line, or large points where a factor has a few values: their mean, whatever the other factors are. Band and "
           "bars: where that mean lies, with 90 %."));
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
