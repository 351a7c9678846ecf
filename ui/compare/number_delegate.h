// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Draws a number of the table of candidates: its text, and below its interval on the scale of its column; or a button to run it.
#pragma once

#include <QStyledItemDelegate>

namespace hygroloom {

class NumberDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// low_role, value_role, high_role: from 0 to 1 on the column's scale; absent: no bar. button_role: whether a button stands in it.
    enum Role { low_role = Qt::UserRole + 1, value_role, high_role, button_role };

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option, const QModelIndex& index) override;

Q_SIGNALS:
    void pressed(int row, int column);

private:
    static QRect buttonIn(const QStyleOptionViewItem& option, const QModelIndex& index);

    QPersistentModelIndex down_;
};

} // namespace hygroloom
