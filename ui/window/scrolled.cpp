// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Qt's own resizing of the content would give one with wrapped sentences the height that it likes best, and scroll without need.
#include "ui/window/scrolled.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace hygroloom {

Scrolled::Scrolled(QWidget* content)
{
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setWidget(content);
}

int Scrolled::leastHeight(int width) const
{
    const int least = asked().height();
    const QLayout* layout = widget()->layout();
    return layout && layout->hasHeightForWidth() ? std::max(least, layout->minimumHeightForWidth(width)) : least;
}

QSize Scrolled::asked() const { return widget()->minimumSizeHint().expandedTo(widget()->minimumSize()); }

void Scrolled::setShares(double width, double height)
{
    width_ = width;
    height_ = height;
    updateGeometry(); // also where they are as before: the content may ask for more
}

QSize Scrolled::minimumSizeHint() const
{
    constexpr QSize least{120, 60};
    const QSize all = asked();
    const QSize share(static_cast<int>(std::lround(width_ * all.width())), static_cast<int>(std::lround(height_ * all.height())));
    return share.expandedTo(least).boundedTo(all);
}

/// The content fills this, or has its least size and is scrolled.
void Scrolled::place()
{
    QSize room = maximumViewportSize();
    const int least = asked().width();
    const bool across = least > room.width();
    if (across) { room.rheight() -= horizontalScrollBar()->sizeHint().height(); }
    if (leastHeight(std::max(room.width(), least)) > room.height()) {
        room.rwidth() -= verticalScrollBar()->sizeHint().width();
        if (!across && least > room.width()) { room.rheight() -= horizontalScrollBar()->sizeHint().height(); }
    }
    const int width = std::max(room.width(), least);
    widget()->resize(width, std::max(room.height(), leastHeight(width)));
}

bool Scrolled::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
        updateGeometry();
        place();
    }
    return QScrollArea::eventFilter(watched, event);
}

void Scrolled::resizeEvent(QResizeEvent* event)
{
    place();
    QScrollArea::resizeEvent(event);
}

} // namespace hygroloom
