// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a panel, or the middle, holds: it scrolls where the window has no room for all that the content asks for.
#pragma once

#include <QScrollArea>

namespace hygroloom {

class Scrolled : public QScrollArea {
    Q_OBJECT
public:
    explicit Scrolled(QWidget* content);

    /// What the content asks for at least, whatever room it has.
    QSize asked() const;
    /// How much of that this asks for, as shares of its width and height; never less than what is of any use.
    void setShares(double width, double height);
    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    int leastHeight(int width) const;
    void place();

    double width_ = 1, height_ = 1;
};

} // namespace hygroloom
