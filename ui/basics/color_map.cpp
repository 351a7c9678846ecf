// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/color_map.h"

#include "ui/basics/quantity.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace hygroloom {

namespace {

using Stops = std::array<std::array<double, 3>, 7>;

// Lightness falls evenly from one end to the other in both.
constexpr Stops blue_stops{{{229, 241, 250}, {186, 217, 239}, {132, 188, 224}, {80, 153, 204}, {39, 113, 178}, {15, 74, 141}, {5, 38, 92}}};
constexpr Stops warmth_stops{{{255, 243, 205}, {254, 216, 145}, {252, 175, 98}, {238, 122, 67}, {208, 70, 51}, {158, 30, 46}, {98, 8, 38}}};
constexpr Stops difference_stops{
    {{122, 66, 5}, {184, 115, 28}, {226, 183, 118}, {247, 243, 236}, {138, 187, 222}, {45, 118, 181}, {8, 54, 118}}};
constexpr Stops cividis_stops{
    {{253, 231, 85}, {217, 199, 105}, {181, 167, 119}, {146, 140, 123}, {112, 113, 118}, {70, 86, 111}, {0, 42, 95}}};

/// In the unit of the first argument.
double roundLength(double perPixel, double availablePixels)
{
    // The tiny share keeps two pictures of the same scale from rounding apart.
    const double wanted = perPixel * availablePixels / 3 * (1 + 1e-9);
    const double power = std::pow(10, std::floor(std::log10(wanted)));
    return power * (wanted >= 5 * power ? 5 : wanted >= 2 * power ? 2 : 1);
}

QColor colorAt(double share, const Stops& stops)
{
    const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    const double part = at - static_cast<double>(low);
    const auto mix = [&](std::size_t channel) {
        return static_cast<int>(std::lround(stops[low][channel] + part * (stops[low + 1][channel] - stops[low][channel])));
    };
    return {mix(0), mix(1), mix(2)};
}

/// A bar with a frame, its title above; returns where the bar stands.
QRectF drawBar(QPainter& painter, const QRectF& area, const QString& title, const std::function<QColor(double)>& color)
{
    const double line = QFontMetricsF(painter.font()).height();
    const double head = 1.5 * line + 4; // the title, and the upper half of the highest number
    const QRectF bar(area.left(), area.top() + head, 14, area.height() - head - line * 0.5);
    painter.drawText(QRectF(area.left(), area.top(), area.width(), line), Qt::AlignLeft | Qt::AlignVCenter, title);
    QImage ramp(1, 256, QImage::Format_RGB32);
    for (int i = 0; i < 256; ++i) { ramp.setPixelColor(0, 255 - i, color(i / 255.0)); }
    painter.drawImage(bar, ramp);
    const QColor ink = painter.pen().color();
    QColor line_color = ink;
    line_color.setAlphaF(0.5F);
    painter.setPen(line_color);
    painter.drawRect(bar);
    painter.setPen(ink);
    return bar;
}

/// Three numbers beside the bar, the highest with the unit.
void drawTicks(QPainter& painter, const QRectF& bar, const std::array<QString, 3>& texts)
{
    const QFontMetricsF metrics(painter.font());
    for (int tick = 0; tick <= 2; ++tick) {
        const double y = bar.bottom() - bar.height() * tick / 2;
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 3, y));
        painter.drawText(QPointF(bar.right() + 6, y + 0.35 * metrics.ascent()), texts[static_cast<std::size_t>(tick)]);
    }
}

int decimalsOf(double maximum) { return maximum >= 20 ? 0 : maximum >= 2 ? 1 : maximum >= 0.2 ? 2 : 4; }

} // namespace

QColor waterColor(double share, WaterColors colors)
{
    if (colors == WaterColors::warmth) { return colorAt(share, warmth_stops); }
    return colorAt(share, colors == WaterColors::cividis ? cividis_stops : blue_stops);
}

QColor differenceColor(double share) { return colorAt(0.5 + 0.5 * share, difference_stops); }

QColor noDifferenceColor() { return {198, 200, 202}; }

QImage waterRamp(WaterColors colors)
{
    QImage ramp(256, 1, QImage::Format_RGBA8888);
    for (int i = 0; i < 256; ++i) { ramp.setPixelColor(i, 0, waterColor(i / 255.0, colors)); }
    return ramp;
}

void drawLegend(QPainter& painter, const QRectF& area, const QString& title, double maximum, const QString& unit, WaterColors colors)
{
    drawLegend(painter, area, title, 0, maximum, unit, colors);
}

void drawLegend(QPainter& painter, const QRectF& area, const QString& title, double minimum, double maximum, const QString& unit,
                WaterColors colors)
{
    const QRectF bar = drawBar(painter, area, title, [colors](double share) { return waterColor(share, colors); });
    const int decimals = decimalsOf(maximum - minimum);
    drawTicks(painter, bar,
              {shownNumber(minimum, decimals), shownNumber(0.5 * (minimum + maximum), decimals),
               shownNumber(maximum, decimals) + QChar(0x00a0) + unit});
}

void drawDifferenceLegend(QPainter& painter, const QRectF& area, const QString& title, double maximum, const QString& unit)
{
    const QRectF bar = drawBar(painter, area, title, [](double share) { return differenceColor(2 * share - 1); });
    const QString most = shownNumber(maximum, decimalsOf(maximum));
    drawTicks(painter, bar, {QChar(0x2212) + most, shownNumber(0, 0), "+" + most + QChar(0x00a0) + unit});
}

double scaleBarLength(double millimetrePerPixel, double availablePixels)
{
    const double perPixel = millimetrePerPixel * userUnit("mm").per_one;
    return roundLength(perPixel, availablePixels) / perPixel;
}

void drawScaleBar(QPainter& painter, const QPointF& lowerLeft, double millimetrePerPixel, double availablePixels, const QColor& color,
                  const QColor& behind)
{
    if (!(millimetrePerPixel > 0) || !(availablePixels > 30)) { return; }
    const UserUnit user = userUnit("mm");
    const double perPixel = millimetrePerPixel * user.per_one;
    const double length = roundLength(perPixel, availablePixels);
    const double pixels = length / perPixel;
    const QString text = user.unit == "mm" && length < 0.1
                             ? QCoreApplication::translate("hygroloom", "%1 µm").arg(shownNumber(length * 1000, 0))
                             : shownNumber(length, 5) + QChar(0x00a0) + user.unit;
    const double height = QFontMetricsF(painter.font()).height();
    const double wide = std::max(pixels, QFontMetricsF(painter.font()).horizontalAdvance(text));
    const QPointF start = lowerLeft + QPointF(0.5 * (wide - pixels), 0); // no word begins left of it
    painter.save();
    if (behind.isValid()) {
        painter.fillRect(QRectF(start.x() + 0.5 * (pixels - wide) - 6, start.y() - height - 8, wide + 12, height + 14), behind);
    }
    painter.setPen(QPen(color, 2));
    const QPointF end = start + QPointF(pixels, 0);
    painter.drawLine(start, end);
    painter.drawLine(start + QPointF(0, -4), start + QPointF(0, 4));
    painter.drawLine(end + QPointF(0, -4), end + QPointF(0, 4));
    painter.drawText(
        QRectF(start.x() - 40, start.y() - 6 - QFontMetricsF(painter.font()).height(), pixels + 80, QFontMetricsF(painter.font()).height()),
        Qt::AlignCenter, text);
    painter.restore();
}

} // namespace hygroloom
