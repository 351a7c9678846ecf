// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/lesson/magnifier.h"

#include "core/base/units.h"
#include "ui/basics/quantity.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

const QColor paper("#fbf7ef"), ink("#1d2327"), water("#2f7fd1"), dry_fibre("#e9d9b4"), soaked_fibre("#2b7a78"), vapour("#c2410c");
constexpr double much_regain = 0.30; // at which a fibre has its darkest colour
constexpr double much_leaving = 400; // g/(m2 h), of which arrows are longest
constexpr double swatch = 11;        // pixels

QColor between(const QColor& a, const QColor& b, double share)
{
    const double s = std::clamp(share, 0.0, 1.0);
    return QColor::fromRgbF(static_cast<float>(a.redF() + s * (b.redF() - a.redF())),
                            static_cast<float>(a.greenF() + s * (b.greenF() - a.greenF())),
                            static_cast<float>(a.blueF() + s * (b.blueF() - a.blueF())));
}

/// Places of fibres in a hexagonal pattern within an ellipse.
std::vector<QPointF> fibrePlaces(const QSizeF& half, double pitch)
{
    std::vector<QPointF> places;
    const double row = pitch * std::sqrt(3.0) / 2;
    const int rows = static_cast<int>(half.height() / row), columns = static_cast<int>(half.width() / pitch) + 1;
    for (int r = -rows; r <= rows; ++r) {
        for (int c = -columns; c <= columns; ++c) {
            const QPointF at((c + (r % 2 != 0 ? 0.5 : 0.0)) * pitch, r * row);
            const double x = at.x() / (half.width() - 0.4 * pitch), y = at.y() / (half.height() - 0.4 * pitch);
            if (x * x + y * y <= 1) { places.push_back(at); }
        }
    }
    return places;
}

void drawArrow(QPainter& painter, const QPointF& from, double length, bool up)
{
    const QPointF top = from - QPointF(0, length);
    const QPointF tip = up ? top : from, back(0, up ? 5 : -5);
    painter.drawLine(from, top);
    painter.drawLine(tip, tip + back + QPointF(4, 0));
    painter.drawLine(tip, tip + back - QPointF(4, 0));
}

void drawYarn(QPainter& painter, const QPointF& at, const QSizeF& half, const YarnLook& yarn)
{
    painter.setPen(QPen(ink, 1, Qt::DotLine));
    painter.setBrush(Qt::white);
    painter.drawEllipse(at, half.width(), half.height());
    if (yarn.saturation > 0) { // from the middle outwards, by area
        const double filled = std::sqrt(std::min(1.0, yarn.saturation));
        painter.setPen(Qt::NoPen);
        painter.setBrush(water);
        painter.drawEllipse(at, filled * half.width(), filled * half.height());
    }
    constexpr double pitch = 21;
    // As many fibres fill this share of a hexagon of the pitch.
    const double radius = std::min(0.5, std::sqrt(yarn.packing * std::sqrt(3.0) / (2 * pi)) * yarn.growth) * pitch;
    painter.setPen(QPen(ink, 0.8));
    painter.setBrush(between(dry_fibre, soaked_fibre, yarn.regain / much_regain));
    for (const QPointF& place : fibrePlaces(half, pitch)) { painter.drawEllipse(at + place, radius, radius); }
}

void drawVapour(QPainter& painter, const QPointF& at, const QSizeF& half, double leaving)
{
    const double share = std::min(1.0, std::abs(leaving) / much_leaving);
    if (share < 0.005) { return; }
    const int arrows = 1 + static_cast<int>(std::lround(4 * share));
    painter.setPen(QPen(vapour, 2));
    for (int k = 0; k < arrows; ++k) {
        const double x = (k - 0.5 * (arrows - 1)) * 24;
        const double y = half.height() * std::sqrt(std::max(0.0, 1 - x * x / (half.width() * half.width())));
        drawArrow(painter, at + QPointF(x, -y - 4), 10 + 16 * share, leaving > 0);
    }
}

} // namespace

YarnLook yarnAt(const ClothView& view, double x, double y)
{
    const Textile& textile = view.run->textile;
    const auto nearest = [](double at, double pitch, int count) {
        return std::clamp(static_cast<int>(std::lround(at / pitch + 0.5 * (count - 1))), 0, count - 1);
    };
    const int end = nearest(x, textile.warp.pitch, textile.ends()), pick = nearest(y, textile.weft.pitch, textile.picks());
    const YarnKind top = textile.warp_up(end, pick) ? YarnKind::warp : YarnKind::weft;
    const auto i = static_cast<std::size_t>(textile.segment(top, end, pick));
    const YarnType& type = textile.type(top, top == YarnKind::warp ? end : pick);
    const Frame& frame = *view.frame;
    YarnLook look;
    look.saturation = static_cast<double>(frame.saturation[i]);
    look.regain = static_cast<double>(frame.regain[i]);
    look.temperature = celsius_from_kelvin(static_cast<double>(frame.temperature[i]));
    constexpr double grams_per_hour = 3.6e6; // in a kg/s
    look.leaving = grams_per_hour * view.air.mass_transfer * (static_cast<double>(frame.vapour[i]) - view.air.vapour);
    look.packing = type.packing;
    look.flatness = type.section.width / type.section.height;
    look.growth = std::sqrt(1 + look.regain * type.fibre.density_kg_m3 / view.air.density); // water it binds adds its own volume
    return look;
}

QStringList magnifierLines(const YarnLook& yarn)
{
    const QString leaving = yarn.leaving >= 0 ? QCoreApplication::translate("hygroloom::Lesson", "Vapour out: %1 g/(m² h)")
                                              : QCoreApplication::translate("hygroloom::Lesson", "Vapour in: %1 g/(m² h)");
    return {QCoreApplication::translate("hygroloom::Lesson", "Pores: %1 % full").arg(shownNumber(100 * yarn.saturation, 0)),
            QCoreApplication::translate("hygroloom::Lesson", "Fibres: %1 % water").arg(QLocale().toString(100 * yarn.regain, 'f', 1)),
            leaving.arg(shownNumber(std::abs(yarn.leaving), 0)),
            QCoreApplication::translate("hygroloom::Lesson", "%1 °C").arg(QLocale().toString(yarn.temperature, 'f', 1))};
}

void drawMagnifier(QPainter& painter, const QPointF& middle, const YarnLook& yarn, const QFont& font)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, 3));
    painter.setBrush(paper);
    painter.drawEllipse(middle, magnifier_radius, magnifier_radius);
    QPainterPath glass;
    glass.addEllipse(middle, magnifier_radius - 2, magnifier_radius - 2);
    painter.setClipPath(glass);
    const double width = 78, height = std::clamp(width / std::max(1.0, yarn.flatness), 30.0, 52.0);
    const QPointF at = middle - QPointF(0, 30);
    drawYarn(painter, at, {width, height}, yarn);
    drawVapour(painter, at, {width, height}, yarn.leaving);
    painter.setClipping(false);
    QFont small = font;
    small.setPixelSize(11);
    painter.setFont(small);
    const QStringList lines = magnifierLines(yarn);
    const QColor marks[] = {water, between(dry_fibre, soaked_fibre, yarn.regain / much_regain), vapour};
    const double left = middle.x() - 84, step = 16;
    double y = middle.y() + 30;
    for (qsizetype k = 0; k < 3; ++k, y += step) {
        painter.setPen(QPen(ink, 0.8));
        painter.setBrush(marks[k]);
        painter.drawRect(QRectF(left, y + 2, swatch, swatch));
        painter.setPen(ink);
        painter.drawText(QRectF(left + 17, y, 170, step), Qt::AlignLeft | Qt::AlignVCenter, lines[k]);
    }
    painter.drawText(QRectF(middle.x() - 60, y, 120, step), Qt::AlignCenter, lines[3]);
    painter.restore();
}

} // namespace hygroloom
