// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Draws a contribution: its number, and below a bar from 0 with its interval.
#pragma once

#include <QStyledItemDelegate>

namespace hygroloom {

class WhyDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// zero_role, value_role, low_role, high_role: from 0 to 1 on the scale of all; absent: no bar.
    enum Role { zero_role = Qt::UserRole + 1, value_role, low_role, high_role, tone_role };
    enum Tone { none, better, worse };

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace hygroloom
