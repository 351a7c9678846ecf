// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/parallel_view.h"

#include "ui/compare/chart_style.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <map>

namespace hygroloom {

namespace {

constexpr std::size_t most_axes = 14, many_rows = 3000;
constexpr int cells = 72;   // of an axis, where there are many rows
constexpr double click = 4; // pixels

} // namespace

ParallelChart::ParallelChart(QWidget* parent) : StudyChart(parent)
{
    setAccessibleName(tr("Parallel coordinates"));
    setAccessibleDescription(
        tr("Left and Right choose an axis, Up and Down move its range, with Shift they widen it, Escape keeps all rows."));
}

void ParallelChart::setStudy(std::shared_ptr<const StudyData> study)
{
    shown_.clear();
    brushes_.clear();
    drag_.reset();
    color_ = nullptr;
    at_ = 0;
    for (std::size_t i = 0; study && i < study->axes.size(); ++i) {
        if (!study->axes[i].empty && shown_.size() < most_axes) { shown_.push_back(i); }
    }
    StudyChart::setStudy(std::move(study));
}

void ParallelChart::setColor(const StudyAxis* axis)
{
    color_ = axis;
    redraw();
}

void ParallelChart::brush(const AxisBrush& brush)
{
    std::erase_if(brushes_, [&brush](const AxisBrush& other) { return other.axis == brush.axis; });
    brushes_.push_back(brush);
    update();
    Q_EMIT brushed();
}

void ParallelChart::clearBrush(std::size_t axis)
{
    if (std::erase_if(brushes_, [axis](const AxisBrush& other) { return other.axis == axis; }) == 0) { return; }
    update();
    Q_EMIT brushed();
}

void ParallelChart::clearBrushes()
{
    if (brushes_.empty()) { return; }
    brushes_.clear();
    update();
    Q_EMIT brushed();
}

QRectF ParallelChart::area() const
{
    const double line = QFontMetricsF(font()).height();
    return QRectF(rect()).adjusted(76, 3 * line + 10, -76, -line - 12);
}

double ParallelChart::xOf(std::size_t shown) const
{
    const QRectF on = area();
    if (shown_.size() < 2) { return on.center().x(); }
    return on.left() + static_cast<double>(shown) * on.width() / static_cast<double>(shown_.size() - 1);
}

std::size_t ParallelChart::shownAt(double x) const
{
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < shown_.size(); ++i) {
        if (std::abs(xOf(i) - x) < std::abs(xOf(nearest) - x)) { nearest = i; }
    }
    return nearest;
}

QPointF ParallelChart::placeOf(std::size_t axis, double number) const
{
    const auto found = std::find(shown_.begin(), shown_.end(), axis);
    return {xOf(static_cast<std::size_t>(found - shown_.begin())), yOf(data_->axes[axis].placeOf(number))};
}

double ParallelChart::numberAt(std::size_t shown, double y) const
{
    const QRectF on = area();
    return data_->axes[shown_[shown]].numberAt((on.bottom() - y) / on.height());
}

/// Of the nearest axis the number at that height.
QString ParallelChart::tipAt(const QPointF& position) const
{
    if (shown_.empty() || position.y() < area().top() || position.y() > area().bottom()) { return {}; }
    const std::size_t shown = shownAt(position.x());
    const StudyAxis& axis = data_->axes[shown_[shown]];
    return QString("%1: %2").arg(axis.title, axis.text(numberAt(shown, position.y())));
}

void ParallelChart::drawPicture(QPainter& painter)
{
    const bool many = data_->table.rows() > many_rows;
    for (const bool kept : {false, true}) { // what a brush keeps lies on top
        if (!kept && kept_.empty()) { continue; }
        if (many) {
            drawBinned(painter, kept);
        } else {
            drawEach(painter, kept);
        }
    }
    for (std::size_t i = 0; i < shown_.size(); ++i) { drawAxis(painter, i); }
}

void ParallelChart::drawEach(QPainter& painter, bool kept) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor plain = strokeOf(0, palette()).color();
    const double strength = std::clamp(60.0 / std::sqrt(static_cast<double>(data_->table.rows())) / 5, 0.25, 0.9);
    for (std::size_t row = 0; row < data_->table.rows(); ++row) {
        if (isKept(row) != kept) { continue; }
        const double number = color_ ? color_->numbers[row] : NAN;
        QColor color = std::isfinite(number) ? studyColor(color_->placeOf(number), palette()) : plain;
        color.setAlphaF(static_cast<float>(strength));
        painter.setPen(QPen(kept ? color : gridColor(palette()), kept ? 1.3 : 1));
        for (std::size_t i = 0; i + 1 < shown_.size(); ++i) {
            const StudyAxis &one = data_->axes[shown_[i]], &next = data_->axes[shown_[i + 1]];
            const double from = one.placeOf(one.numbers[row]), to = next.placeOf(next.numbers[row]);
            if (std::isfinite(from) && std::isfinite(to)) { painter.drawLine(QPointF(xOf(i), yOf(from)), QPointF(xOf(i + 1), yOf(to))); }
        }
    }
}

/// Between two axes one line for all rows that go from one cell to another, the stronger the more they are, in their mean colour.
void ParallelChart::drawBinned(QPainter& painter, bool kept) const
{
    painter.setRenderHint(QPainter::Antialiasing, false);
    const QColor plain = strokeOf(0, palette()).color();
    struct Bundle {
        double count = 0, color = 0, colored = 0;
    };
    std::vector<Bundle> bundles(cells * cells);
    const auto cellOf = [](double place) { return std::clamp(static_cast<int>(place * cells), 0, cells - 1); };
    for (std::size_t i = 0; i + 1 < shown_.size(); ++i) {
        const StudyAxis &one = data_->axes[shown_[i]], &next = data_->axes[shown_[i + 1]];
        std::fill(bundles.begin(), bundles.end(), Bundle{});
        double most = 0;
        for (std::size_t row = 0; row < data_->table.rows(); ++row) {
            if (isKept(row) != kept) { continue; }
            const double from = one.placeOf(one.numbers[row]), to = next.placeOf(next.numbers[row]);
            if (!std::isfinite(from) || !std::isfinite(to)) { continue; }
            Bundle& bundle = bundles[static_cast<std::size_t>(cellOf(from) * cells + cellOf(to))];
            most = std::max(most, ++bundle.count);
            const double number = color_ ? color_->numbers[row] : NAN;
            if (!std::isfinite(number)) { continue; }
            bundle.color += color_->placeOf(number);
            ++bundle.colored;
        }
        for (int k = 0; k < cells * cells; ++k) {
            const Bundle& bundle = bundles[static_cast<std::size_t>(k)];
            if (bundle.count == 0) { continue; }
            QColor color = !kept ? gridColor(palette()) : bundle.colored > 0 ? studyColor(bundle.color / bundle.colored, palette()) : plain;
            color.setAlphaF(static_cast<float>((kept ? 0.6 : 0.1) * std::sqrt(bundle.count / most)));
            painter.setPen(color);
            painter.drawLine(QPointF(xOf(i), yOf((k / cells + 0.5) / cells)), QPointF(xOf(i + 1), yOf((k % cells + 0.5) / cells)));
        }
    }
}

void ParallelChart::drawAxis(QPainter& painter, std::size_t shown) const
{
    const StudyAxis& axis = data_->axes[shown_[shown]];
    const QRectF on = area();
    const QFontMetricsF metrics(painter.font());
    const double x = xOf(shown), line = metrics.height();
    const QColor ink = palette().color(QPalette::Text), base = palette().color(QPalette::Base);
    painter.setPen(QPen(ink, 1.2));
    painter.drawLine(QPointF(x, on.top()), QPointF(x, on.bottom()));
    const double room = shown_.size() < 2 ? on.width() : on.width() / static_cast<double>(shown_.size() - 1);
    const double wide = std::min(room - 8, 148.0);
    double left = std::clamp(x - wide / 2, 2.0, std::max(2.0, width() - wide - 2));
    painter.drawText(QRectF(left, 4, wide, 3 * line), Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, axis.title);
    for (const double tick : axis.ticks(std::max(2, static_cast<int>(on.height() / 60)))) {
        const double y = yOf(axis.placeOf(tick));
        const QString text = metrics.elidedText(axis.text(tick), Qt::ElideRight, std::max(30.0, room - 14));
        const QRectF box(x + 5, y - line / 2, metrics.horizontalAdvance(text) + 2, line);
        QColor behind = base;
        behind.setAlphaF(0.75F);
        painter.fillRect(box, behind);
        painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, text);
        painter.drawLine(QPointF(x, y), QPointF(x + 3, y));
    }
}

void ParallelChart::drawMarks(QPainter& painter)
{
    QColor fill = palette().color(QPalette::Highlight);
    const auto drawRange = [&](double x, double top, double bottom) {
        fill.setAlphaF(0.35F);
        painter.setBrush(fill);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
        painter.drawRect(QRectF(x - 7, top, 14, bottom - top));
    };
    for (const AxisBrush& brush : brushes_) {
        const QPointF high = placeOf(brush.axis, brush.high), low = placeOf(brush.axis, brush.low);
        drawRange(high.x(), high.y(), low.y());
    }
    if (drag_) { drawRange(xOf(drag_->shown), std::min(drag_->from, drag_->to), std::max(drag_->from, drag_->to)); }
    if (hasFocus() && at_ < shown_.size()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5, Qt::DotLine));
        painter.drawRect(QRectF(xOf(at_) - 10, area().top() - 4, 20, area().height() + 8));
    }
    if (!chosen_) { return; }
    QPolygonF line;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        const StudyAxis& axis = data_->axes[shown_[i]];
        if (const double place = axis.placeOf(axis.numbers[*chosen_]); std::isfinite(place)) { line << QPointF(xOf(i), yOf(place)); }
    }
    painter.setPen(QPen(palette().color(QPalette::Base), 5));
    painter.drawPolyline(line);
    painter.setPen(QPen(palette().color(QPalette::Text), 2));
    painter.drawPolyline(line);
}

void ParallelChart::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !hasRows() || shown_.empty()) { return; }
    const std::size_t near = shownAt(event->position().x());
    if (std::abs(xOf(near) - event->position().x()) > 24) { return; }
    at_ = near;
    drag_ = {near, event->position().y(), event->position().y()};
}

void ParallelChart::mouseMoveEvent(QMouseEvent* event)
{
    if (!drag_) { return; }
    drag_->to = std::clamp(event->position().y(), area().top() - 2, area().bottom() + 2);
    update();
}

/// A click without a drag takes the axis' range away.
void ParallelChart::mouseReleaseEvent(QMouseEvent*)
{
    if (!drag_) { return; }
    const Drag drag = *std::exchange(drag_, std::nullopt);
    const std::size_t axis = shown_[drag.shown];
    if (std::abs(drag.to - drag.from) < click) {
        clearBrush(axis);
        update();
        return;
    }
    const double one = numberAt(drag.shown, drag.from), other = numberAt(drag.shown, drag.to);
    brush({axis, std::min(one, other), std::max(one, other)});
}

void ParallelChart::keyPressEvent(QKeyEvent* event)
{
    if (!hasRows() || shown_.empty()) { return StudyChart::keyPressEvent(event); }
    switch (event->key()) {
    case Qt::Key_Left: at_ = at_ > 0 ? at_ - 1 : 0; break;
    case Qt::Key_Right: at_ = std::min(at_ + 1, shown_.size() - 1); break;
    case Qt::Key_Up:
    case Qt::Key_Down: brushByKeys(event->key(), event->modifiers() & Qt::ShiftModifier); break;
    case Qt::Key_Escape: clearBrushes(); break;
    default: return StudyChart::keyPressEvent(event);
    }
    update();
}

/// In steps of a twentieth of the axis; the first makes a range of its middle third.
void ParallelChart::brushByKeys(int key, bool widen)
{
    const std::size_t axis = shown_[at_];
    const StudyAxis& of = data_->axes[axis];
    const double width = of.high - of.low, step = (key == Qt::Key_Up ? 0.05 : -0.05) * width;
    const auto found = std::find_if(brushes_.begin(), brushes_.end(), [axis](const AxisBrush& each) { return each.axis == axis; });
    AxisBrush range = found == brushes_.end() ? AxisBrush{axis, of.low + width / 3, of.high - width / 3} : *found;
    if (found != brushes_.end()) {
        range.low += widen ? -step : step;
        range.high += step;
        if (range.low > range.high) { return; }
    }
    brush(range);
}

} // namespace hygroloom
