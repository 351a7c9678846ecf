// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/lesson/water_disc.h"

#include <QPainter>
#include <QRadialGradient>

#include <algorithm>

namespace hygroloom {

namespace {

/// Light from the upper left: dark towards it, bright at the far rim, where it is focused, and one mirrored spot.
void drawGlossy(QPainter& painter, const QPointF& at, double radius, double steepness)
{
    const double deep = std::clamp(steepness, 0.1, 1.0);
    QRadialGradient body(at, radius, at + QPointF(0.45, 0.45) * radius * deep);
    body.setColorAt(0, QColor(190, 222, 250, static_cast<int>(40 + 120 * deep)));
    body.setColorAt(0.75, QColor(40, 78, 120, static_cast<int>(60 + 70 * deep)));
    body.setColorAt(1, QColor(14, 30, 52, static_cast<int>(90 + 90 * deep)));
    painter.setPen(QPen(QColor(235, 246, 255, 120), 1));
    painter.setBrush(body);
    painter.drawEllipse(at, radius, radius);
    const QPointF spot = at - QPointF(0.38, 0.38) * radius;
    const double size = 0.26 * radius;
    QRadialGradient shine(spot, size);
    shine.setColorAt(0, QColor(255, 255, 255, 235));
    shine.setColorAt(1, QColor(255, 255, 255, 0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(shine);
    painter.drawEllipse(spot, size, size);
}

} // namespace

void drawStanding(QPainter& painter, const QPointF& at, double base, double steepness)
{
    if (base < 0.5) { return; }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    drawGlossy(painter, at, base, steepness);
    painter.restore();
}

void drawFalling(QPainter& painter, const QPointF& at, double radius, double height)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double away = 0.4 * height;
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 90));
    painter.drawEllipse(at + QPointF(0.3, 0.3) * away, radius, radius);
    drawGlossy(painter, at - QPointF(0, 0.35) * away, std::max(2.0, radius) * (1 + 0.15 * std::min(1.0, away / 40)), 1);
    painter.restore();
}

} // namespace hygroloom
