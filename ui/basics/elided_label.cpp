// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/elided_label.h"

#include <QPainter>
#include <QStyle>

namespace hygroloom {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void ElidedLabel::setFullText(const QString& text)
{
    setText(text);
    setToolTip(text);
}

QString ElidedLabel::shownText() const { return fontMetrics().elidedText(text(), mode_, room().width()); }

QRect ElidedLabel::room() const { return contentsRect().adjusted(margin(), margin(), -margin(), -margin()); }

void ElidedLabel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    style()->drawItemText(&painter, room(), static_cast<int>(alignment() | Qt::AlignVCenter), palette(), isEnabled(), shownText(),
                          foregroundRole());
}

} // namespace hygroloom
