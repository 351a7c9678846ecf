// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/study_chart.h"

#include "ui/basics/appearance.h"
#include "ui/basics/color_map.h"

#include <QComboBox>
#include <QHelpEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolTip>

#include <algorithm>

namespace hygroloom {

StudyChart::StudyChart(QWidget* parent) : QWidget(parent) { setFocusPolicy(Qt::StrongFocus); }

void StudyChart::setStudy(std::shared_ptr<const StudyData> study)
{
    data_ = std::move(study);
    kept_.clear();
    chosen_.reset();
    redraw();
}

void StudyChart::setKept(const KeptPoints& kept)
{
    kept_ = kept;
    redraw();
}

void StudyChart::setChosen(std::optional<std::size_t> row)
{
    chosen_ = row;
    update();
}

void StudyChart::redraw()
{
    picture_ = {};
    update();
}

void StudyChart::paintEvent(QPaintEvent*)
{
    const QSize pixels = size() * devicePixelRatioF();
    if (picture_.size() != pixels) {
        picture_ = QPixmap(pixels);
        picture_.setDevicePixelRatio(devicePixelRatioF());
        picture_.fill(palette().color(QPalette::Base));
        QPainter painter(&picture_);
        painter.setFont(font());
        if (hasRows()) {
            drawPicture(painter);
        } else {
            painter.setPen(quietText(palette()));
            painter.drawText(rect(), Qt::AlignCenter, tr("Run a study, or open the results of one."));
        }
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, picture_);
    if (!hasRows()) { return; }
    painter.setRenderHint(QPainter::Antialiasing);
    drawMarks(painter);
}

bool StudyChart::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip && hasRows()) {
        auto* help = static_cast<QHelpEvent*>(event);
        const QString tip = tipAt(help->pos());
        QToolTip::showText(help->globalPos(), tip.isEmpty() ? tip : "<p>" + tip.toHtmlEscaped() + "</p>", this);
        return true;
    }
    return QWidget::event(event);
}

void StudyChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) { redraw(); }
    QWidget::changeEvent(event);
}

void fillAxes(QComboBox& box, const StudyData* data, bool factors, bool metrics, std::size_t otherwise)
{
    const QSignalBlocker quiet(box);
    const QString before = box.currentText();
    box.clear();
    for (std::size_t i = 0; data && i < data->axes.size(); ++i) {
        const StudyAxis& axis = data->axes[i];
        if (!axis.empty && (axis.is_factor ? factors : metrics)) { box.addItem(axis.title, static_cast<int>(i)); }
    }
    const int known = box.findText(before);
    box.setCurrentIndex(known >= 0 ? known : std::min(static_cast<int>(otherwise), box.count() - 1));
    box.setEnabled(box.count() > 1);
}

const StudyAxis* chosenAxis(const QComboBox& box, const StudyData* data)
{
    const QVariant at = box.currentData();
    return data && at.isValid() && at.toUInt() < data->axes.size() ? &data->axes[at.toUInt()] : nullptr;
}

QColor gridColor(const QPalette& palette)
{
    QColor grid = palette.color(QPalette::WindowText);
    grid.setAlphaF(0.15F);
    return grid;
}

QColor studyColor(double share, const QPalette& palette)
{
    return waterColor(isDark(palette) ? 0.78 * (1 - share) : 1 - 0.85 * share, WaterColors::cividis);
}

std::vector<TickLabel> tickLabels(const QRectF& area, const StudyAxis& across, const QFontMetricsF& metrics)
{
    constexpr double widest = 120, gap = 6, beyond = 16; // pixels; beyond: to the area's right, where the next chart begins
    const std::vector<double> ticks = across.ticks(std::max(3, static_cast<int>(area.width() / 50)));
    const auto at = [&](double tick) { return area.left() + across.placeOf(tick) * area.width(); };
    const bool words = !across.words.empty();
    const double room = words && ticks.size() > 1 ? std::clamp(at(ticks[1]) - at(ticks[0]) - gap, 1.0, widest) : widest;
    double free_from = area.left() - widest / 2;
    std::vector<TickLabel> labels;
    for (const double tick : ticks) {
        TickLabel label{at(tick), 0, 0, {}};
        const double right = words ? area.right() + beyond : label.at + widest;
        label.text = metrics.elidedText(across.text(tick), Qt::ElideRight, std::min(room, right - free_from));
        label.width = metrics.horizontalAdvance(label.text);
        label.left = std::min(label.at - label.width / 2, right - label.width);
        if (label.left < free_from) { label.text.clear(); }
        if (!label.text.isEmpty()) { free_from = label.left + label.width + gap; }
        labels.push_back(label);
    }
    return labels;
}

void drawAxes(QPainter& painter, const QRectF& area, const StudyAxis& across, const StudyAxis& up, const QPalette& palette)
{
    const QFontMetricsF metrics(painter.font());
    const QColor ink = palette.color(QPalette::Text), grid = gridColor(palette);
    for (const TickLabel& label : tickLabels(area, across, metrics)) {
        painter.setPen(grid);
        painter.drawLine(QPointF(label.at, area.top()), QPointF(label.at, area.bottom()));
        painter.setPen(ink);
        painter.drawText(QRectF(label.left, area.bottom() + 2, label.width + 1, metrics.height()), Qt::AlignLeft, label.text);
    }
    for (const double tick : up.ticks(std::max(2, static_cast<int>(area.height() / 40)))) {
        const double y = area.bottom() - up.placeOf(tick) * area.height();
        painter.setPen(grid);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(ink);
        painter.drawText(QRectF(area.left() - 60, y - metrics.height() / 2, 56, metrics.height()), Qt::AlignRight | Qt::AlignVCenter,
                         metrics.elidedText(up.text(tick), Qt::ElideRight, 56));
    }
}

} // namespace hygroloom
