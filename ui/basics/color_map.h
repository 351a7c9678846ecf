// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Colours for numbers: one sequential map for water, the same in three dimensions, on maps and in legends.
#pragma once

#include <QColor>
#include <QImage>
#include <QRectF>
#include <QString>

class QPainter;
class QPalette;

namespace hygroloom {

/// natural: wet cloth is darker, in three dimensions; maps stay blue. warmth is for temperatures: pale is cool, dark red is warm.
enum class WaterColors { blue, cividis, natural, warmth };

/// 0..1, clamped; light is little, dark is much.
QColor waterColor(double share, WaterColors colors = WaterColors::blue);
/// One row of 256, for a texture.
QImage waterRamp(WaterColors colors = WaterColors::blue);

/// -1..1, clamped: brown is less, blue is more, the middle is pale. Told apart with every kind of colour vision.
QColor differenceColor(double share);
/// What a difference map shows where there is no difference to speak of.
QColor noDifferenceColor();

/// A bar from zero to maximum with its unit; right of the bar the numbers.
void drawLegend(QPainter& painter, const QRectF& area, const QString& title, double maximum, const QString& unit, WaterColors colors);
/// The same from another number than zero.
void drawLegend(QPainter& painter, const QRectF& area, const QString& title, double minimum, double maximum, const QString& unit,
                WaterColors colors);
/// A bar from -maximum to maximum, with 0 in the middle and its unit.
void drawDifferenceLegend(QPainter& painter, const QRectF& area, const QString& title, double maximum, const QString& unit);
/// How many pixels drawScaleBar() takes.
double scaleBarLength(double millimetrePerPixel, double availablePixels);
/// A bar with its length, as near to a third of available pixels as a round length allows. With a valid colour behind it, it stands on
/// that.
void drawScaleBar(QPainter& painter, const QPointF& lowerLeft, double millimetrePerPixel, double availablePixels, const QColor& color,
                  const QColor& behind = {});

} // namespace hygroloom
