// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/indices_view.h"

#include "ui/basics/appearance.h"
#include "ui/compare/chart_style.h"
#include "ui/study/study_fields.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>

namespace hygroloom {

IndicesChart::IndicesChart(QWidget* parent) : StudyChart(parent)
{
    setAccessibleName(tr("Sensitivity indices"));
    setFocusPolicy(Qt::NoFocus);
}

void IndicesChart::setIndices(const StudyIndices* indices)
{
    indices_ = indices;
    QStringList words;
    if (indices) {
        for (const auto& [factor, index] : indices->factors) {
            words << tr("%1: alone %2, with others %3").arg(factor, studyNumber(index.first), studyNumber(index.total));
        }
    }
    setAccessibleDescription(words.join(". "));
    redraw();
}

void IndicesChart::drawPicture(QPainter& painter)
{
    painter.setRenderHint(QPainter::Antialiasing);
    if (!indices_ || indices_->factors.empty()) {
        painter.setPen(quietText(palette()));
        const QString why = indices_ ? tr("Not known: too few runs have this metric, or all have the same number.")
                                     : tr("Compute shows which factors matter.");
        painter.drawText(rect(), Qt::AlignCenter, why);
        return;
    }
    const double line = QFontMetricsF(font()).height();
    const QRectF on = QRectF(rect()).adjusted(std::min(260.0, width() * 0.35), line + 18, -80, -line - 8);
    painter.setPen(palette().color(QPalette::Text));
    for (int i = 0; i <= 5; ++i) {
        const double x = on.left() + i * on.width() / 5;
        painter.setPen(gridColor(palette()));
        painter.drawLine(QPointF(x, on.top()), QPointF(x, on.bottom()));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QRectF(x - 30, on.bottom() + 3, 60, line), Qt::AlignCenter, studyNumber(i / 5.0));
    }
    double x = on.left();
    for (const auto& [stroke, text] : {std::pair(0, tr("alone")), std::pair(1, tr("with others"))}) {
        painter.fillRect(QRectF(x, 10, 12, 12), strokeOf(static_cast<std::size_t>(stroke), palette()).color());
        painter.drawText(QPointF(x + 18, 10 + 12), text);
        x += 40 + painter.fontMetrics().horizontalAdvance(text);
    }
    const double each = std::min(64.0, on.height() / static_cast<double>(indices_->factors.size()));
    double y = on.top();
    for (const auto& [factor, index] : indices_->factors) {
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QRectF(8, y, on.left() - 18, each), Qt::AlignRight | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(factor, Qt::ElideMiddle, static_cast<int>(on.left() - 18)));
        drawBar(painter, QRectF(on.left(), y + 0.12 * each, on.width(), 0.36 * each), index.first, index.first_low, index.first_high, 0);
        drawBar(painter, QRectF(on.left(), y + 0.52 * each, on.width(), 0.36 * each), index.total, index.total_low, index.total_high, 1);
        y += each;
    }
}

void IndicesChart::drawBar(QPainter& painter, const QRectF& room, double value, double low, double high, int stroke) const
{
    const auto at = [&room](double number) { return room.left() + std::clamp(number, 0.0, 1.15) * room.width(); };
    painter.fillRect(QRectF(room.left(), room.top(), at(value) - room.left(), room.height()),
                     strokeOf(static_cast<std::size_t>(stroke), palette()).color());
    const double y = room.center().y();
    painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
    painter.drawLine(QPointF(at(low), y), QPointF(at(high), y));
    for (const double end : {low, high}) { painter.drawLine(QPointF(at(end), y - 4), QPointF(at(end), y + 4)); }
    painter.drawText(QRectF(std::max(at(high), at(value)) + 6, room.top() - 4, 60, room.height() + 8), Qt::AlignLeft | Qt::AlignVCenter,
                     locale().toString(value, 'f', 2));
}

IndicesView::IndicesView(QWidget* parent)
    : QWidget(parent), metric_(new QComboBox), compute_(new QPushButton(tr("Co&mpute"))), chart_(new IndicesChart),
      note_(makeNote(tr("What the indices rest on")))
{
    metric_->setAccessibleName(tr("Metric of the indices"));
    metric_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    compute_->setToolTip(tr("Compute the indices from the study's results."));
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 6, 8, 0);
    head->addWidget(new QLabel(tr("Metric:")));
    head->addWidget(metric_);
    head->addStretch();
    head->addWidget(compute_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addWidget(chart_, 1);
    layout->addWidget(note_);
    connect(metric_, &QComboBox::currentIndexChanged, this, &IndicesView::choose);
    connect(compute_, &QPushButton::clicked, this, &IndicesView::computeRequested);
}

void IndicesView::setStudy(const std::shared_ptr<const StudyData>& study)
{
    chart_->setIndices(nullptr);
    data_ = study;
    chart_->setStudy(study);
    {
        const QSignalBlocker quiet(metric_);
        const QString before = metric_->currentText();
        metric_->clear();
        if (study) {
            for (const StudyIndices& indices : study->indices) { metric_->addItem(indices.title); }
        }
        metric_->setCurrentIndex(std::max(0, metric_->findText(before)));
        metric_->setEnabled(metric_->count() > 1);
    }
    choose();
    compute_->setEnabled(study && study->of && study->table.rows() > 0 && !study->of->study.factors.empty());
    compute_->setText(study && study->has_indices ? tr("Co&mpute Anew") : tr("Co&mpute"));
}

void IndicesView::choose()
{
    const int at = metric_->currentIndex();
    const bool is = data_ && at >= 0 && at < static_cast<int>(data_->indices.size());
    const StudyIndices* indices = is ? &data_->indices[static_cast<std::size_t>(at)] : nullptr;
    chart_->setIndices(indices);
    note_->setText(indices && !indices->factors.empty()
                       ? tr("Alone: the share of the variance that a factor makes by itself. With others: with all that it does together "
                            "with other factors. Whiskers: 95 %. Method: %1, %2 points.")
                             .arg(indices->method)
                             .arg(indices->points)
                       : QString());
}

void IndicesView::say(const QString& sentence, bool busy)
{
    compute_->setEnabled(!busy);
    note_->setText(sentence);
}

QString IndicesView::note() const { return note_->text(); }

} // namespace hygroloom
