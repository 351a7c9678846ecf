// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One line of plain text that loses a part where there is no room for it; the tool tip has all of it.
#pragma once

#include <QLabel>

namespace hygroloom {

class ElidedLabel : public QLabel {
public:
    explicit ElidedLabel(QWidget* parent = nullptr);

    /// text() is all of it.
    void setFullText(const QString& text);
    /// Which part is left out; the middle unless another is set.
    void setElideMode(Qt::TextElideMode mode) { mode_ = mode; }
    /// What there is room for.
    QString shownText() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRect room() const;

    Qt::TextElideMode mode_ = Qt::ElideMiddle;
};

} // namespace hygroloom
