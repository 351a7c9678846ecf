// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/curve_legend.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int swatch = 34, gap = 6, margin = 4; // pixels; two periods of the longest dashes of a pen 2 wide

} // namespace

CurveLegend::CurveLegend(QWidget* parent) : QWidget(parent) { setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred); }

void CurveLegend::setEntries(const std::vector<Entry>& entries)
{
    if (entries == entries_) { return; }
    entries_ = entries;
    QStringList names;
    for (const Entry& entry : entries_) { names << entry.name; }
    setAccessibleName(tr("Curves: %1").arg(names.join(", ")));
    updateGeometry();
    update();
}

QSize CurveLegend::sizeHint() const
{
    int widest = 0;
    for (const Entry& entry : entries_) { widest = std::max(widest, fontMetrics().horizontalAdvance(entry.name)); }
    return {margin + swatch + gap + widest + margin, static_cast<int>(entries_.size()) * fontMetrics().lineSpacing()};
}

void CurveLegend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int line = fontMetrics().lineSpacing();
    double top = 0.5 * (height() - static_cast<double>(entries_.size()) * line);
    for (const Entry& entry : entries_) {
        const double middle = top + 0.5 * line;
        QPen pen = entry.pen;
        pen.setCapStyle(Qt::FlatCap);
        painter.setPen(pen);
        painter.drawLine(QPointF(margin, middle), QPointF(margin + swatch, middle));
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QRectF(margin + swatch + gap, top, width(), line), Qt::AlignLeft | Qt::AlignVCenter, entry.name);
        top += line;
    }
}

void CurveLegend::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::FontChange) { updateGeometry(); }
    QWidget::changeEvent(event);
}

} // namespace hygroloom
