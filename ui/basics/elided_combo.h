// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A choice whose text ends in "…" where there is no room for it; Qt cuts it through a letter.
#pragma once

#include <QComboBox>
#include <QStylePainter>

namespace hygroloom {

class ElidedCombo : public QComboBox {
public:
    using QComboBox::QComboBox;

    /// The text as it is drawn.
    QString shownText() const
    {
        QStyleOptionComboBox option;
        initStyleOption(&option);
        const int icon = option.currentIcon.isNull() ? 0 : option.iconSize.width() + 4;
        const int room = style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this).width() - icon - 2;
        return fontMetrics().elidedText(option.currentText, Qt::ElideRight, room);
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QStylePainter painter(this);
        painter.setPen(palette().color(QPalette::Text));
        QStyleOptionComboBox option;
        initStyleOption(&option);
        painter.drawComplexControl(QStyle::CC_ComboBox, option);
        option.currentText = shownText();
        painter.drawControl(QStyle::CE_ComboBoxLabel, option);
    }
};

} // namespace hygroloom
