// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/why_delegate.h"

#include "ui/basics/appearance.h"

#include <QApplication>
#include <QPainter>

namespace hygroloom {

namespace {

constexpr int side_margin = 6, own_bar_height = 10; // pixels

QColor colorOf(int tone, const QPalette& palette)
{
    const bool dark = isDark(palette);
    if (tone == WhyDelegate::better) { return dark ? "#5ab0e8" : "#0b6aa8"; }
    if (tone == WhyDelegate::worse) { return dark ? "#e0a94a" : "#9a5b00"; }
    return dark ? "#7c7c7c" : "#a8a8a8";
}

} // namespace

void WhyDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
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
    const QRect room = own.rect.adjusted(side_margin, 3, -side_margin, -3);
    painter->setPen(ink);
    painter->setFont(own.font);
    painter->drawText(QRect(room.left(), room.top(), room.width(), own.fontMetrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                      own.fontMetrics.elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideRight, room.width()));
    if (index.data(value_role).isValid()) {
        const double y = own.rect.bottom() - 4 - own_bar_height / 2.0;
        const auto at = [&](Role role) { return room.left() + 4 + index.data(role).toDouble() * (room.width() - 8); };
        const double zero = at(zero_role), value = at(value_role);
        const QColor fill = selected ? ink : colorOf(index.data(tone_role).toInt(), own.palette);
        painter->fillRect(QRectF(std::min(zero, value), y - own_bar_height / 2.0, std::abs(value - zero), own_bar_height), fill);
        QColor line = ink;
        line.setAlphaF(0.35F);
        painter->setPen(QPen(line, 1));
        painter->drawLine(QPointF(zero, own.rect.top()), QPointF(zero, own.rect.bottom()));
        painter->setPen(QPen(selected ? own.palette.color(QPalette::Highlight).darker(160) : ink, 1.5));
        painter->drawLine(QPointF(at(low_role), y), QPointF(at(high_role), y));
        for (const Role end : {low_role, high_role}) { painter->drawLine(QPointF(at(end), y - 4), QPointF(at(end), y + 4)); }
    }
    painter->restore();
}

QSize WhyDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    return {option.fontMetrics.horizontalAdvance(index.data(Qt::DisplayRole).toString()) + 2 * side_margin + 4,
            option.fontMetrics.height() + own_bar_height + 10};
}

} // namespace hygroloom
