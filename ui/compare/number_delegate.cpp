// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/number_delegate.h"

#include "ui/basics/appearance.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

namespace hygroloom {

namespace {

constexpr int margin = 6, bar_height = 10; // pixels

/// on_selected: the colour on a selected cell; else invalid.
void drawBar(QPainter& painter, const QRectF& room, double low, double value, double high, const QPalette& palette,
             const QColor& on_selected)
{
    const double y = room.center().y();
    const auto at = [&room](double share) { return room.left() + share * room.width(); };
    QColor line = palette.color(QPalette::Text);
    line.setAlphaF(0.2F);
    painter.setPen(QPen(line, 1));
    painter.drawLine(QPointF(room.left(), y), QPointF(room.right(), y));
    const QColor ink = on_selected.isValid() ? on_selected : isDark(palette) ? QColor("#5ab0e8") : QColor("#0b6aa8");
    painter.setPen(QPen(ink, 3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(at(low), y), QPointF(std::max(at(high), at(low) + 1), y));
    painter.setPen(QPen(ink, 1));
    for (const double end : {low, high}) { painter.drawLine(QPointF(at(end), y - 4), QPointF(at(end), y + 4)); }
    painter.setBrush(palette.color(QPalette::Base));
    painter.drawEllipse(QPointF(at(value), y), 3, 3);
}

} // namespace

QRect NumberDelegate::buttonIn(const QStyleOptionViewItem& option, const QModelIndex& index)
{
    const int width = option.fontMetrics.horizontalAdvance(tr("Run")) + 24, height = option.fontMetrics.height() + 8;
    const QRect room = option.rect.adjusted(margin, 2, -margin, -2);
    return {room.left() + option.fontMetrics.horizontalAdvance(index.data(Qt::DisplayRole).toString()) + 10, room.center().y() - height / 2,
            width, height};
}

void NumberDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem own = option;
    initStyleOption(&own, index);
    own.text.clear();
    QStyle& style = own.widget ? *own.widget->style() : *QApplication::style();
    style.drawControl(QStyle::CE_ItemViewItem, &own, painter, own.widget);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool selected = own.state & QStyle::State_Selected;
    const QColor ink = own.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
    const QColor quiet = selected ? ink : quietText(own.palette);
    const QStringList lines = index.data(Qt::DisplayRole).toString().split('\n');
    const bool number = index.data(value_role).isValid();
    QRect room = own.rect.adjusted(margin, 4, -margin, -4);
    const int line = own.fontMetrics.height();
    if (!number) { room.setTop(room.center().y() - static_cast<int>(lines.size()) * line / 2); }
    for (qsizetype i = 0; i < lines.size(); ++i) {
        painter->setPen(i == 0 && number ? ink : quiet);
        const QRect row(room.left(), room.top() + static_cast<int>(i) * line, room.width(), line);
        painter->drawText(row, Qt::AlignLeft | Qt::AlignVCenter, own.fontMetrics.elidedText(lines[i], Qt::ElideRight, row.width()));
    }
    if (index.data(low_role).isValid()) {
        drawBar(*painter, QRectF(room.left() + 4, own.rect.bottom() - 3 - bar_height, room.width() - 8, bar_height),
                index.data(low_role).toDouble(), index.data(value_role).toDouble(), index.data(high_role).toDouble(), own.palette,
                selected ? ink : QColor());
    }
    if (index.data(button_role).toBool()) {
        QStyleOptionButton button;
        button.rect = buttonIn(own, index);
        button.palette = own.palette;
        button.fontMetrics = own.fontMetrics;
        button.text = tr("Run");
        button.state = QStyle::State_Enabled | (down_ == index ? QStyle::State_Sunken : QStyle::State_Raised);
        style.drawControl(QStyle::CE_PushButton, &button, painter, own.widget);
    }
    painter->restore();
}

QSize NumberDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    int width = 0;
    for (const QString& line : index.data(Qt::DisplayRole).toString().split('\n')) {
        width = std::max(width, option.fontMetrics.horizontalAdvance(line));
    }
    if (index.data(button_role).toBool()) { width = buttonIn(option, index).right() - option.rect.left(); }
    return {width + 2 * margin + 4, 2 * option.fontMetrics.height() + bar_height + 10};
}

bool NumberDelegate::editorEvent(QEvent* event, QAbstractItemModel*, const QStyleOptionViewItem& option, const QModelIndex& index)
{
    if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseButtonRelease) { return false; }
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton || !index.data(button_role).toBool()) { return false; }
    const bool inside = buttonIn(option, index).contains(mouse->position().toPoint());
    const bool was_down = down_ == index;
    down_ = inside && event->type() == QEvent::MouseButtonPress ? QPersistentModelIndex(index) : QPersistentModelIndex();
    if (event->type() == QEvent::MouseButtonRelease && inside && was_down) { Q_EMIT pressed(index.row(), index.column()); }
    return inside;
}

} // namespace hygroloom
