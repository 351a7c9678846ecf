// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Water over cloth from above: a drop that stands, a drop that falls.
#pragma once

#include <QPointF>

class QPainter;

namespace hygroloom {

/// All in pixels. steepness: height of the drop over the radius of its base.
void drawStanding(QPainter& painter, const QPointF& at, double base, double steepness);
/// height: of its lowest point over the cloth.
void drawFalling(QPainter& painter, const QPointF& at, double radius, double height);

} // namespace hygroloom
