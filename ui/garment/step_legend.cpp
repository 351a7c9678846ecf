// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/step_legend.h"

#include "core/wear/wear_map.h"
#include "ui/basics/color_map.h"
#include "ui/basics/quantity.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int steps = 8;
constexpr int box = 22;

} // namespace

double differenceStep(double share)
{
    const int step = std::clamp(static_cast<int>(std::floor((0.5 + 0.5 * share) * steps)), 0, steps - 1);
    return 2 * (step + 0.5) / steps - 1;
}

StepLegend::StepLegend(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Legend of the colours"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
}

void StepLegend::setSteps(const QString& title, double most, bool percent, bool exceeded) { set(title, most, percent, exceeded, false); }

void StepLegend::setDifference(const QString& title, double most, bool percent, bool exceeded)
{
    set(title, most, percent, exceeded, true);
}

void StepLegend::set(const QString& title, double most, bool percent, bool exceeded, bool difference)
{
    title_ = title;
    most_ = most;
    percent_ = percent;
    exceeded_ = exceeded;
    difference_ = difference;
    setAccessibleDescription(title + ": " + texts().join("; "));
    updateGeometry();
    update();
}

QStringList StepLegend::texts() const
{
    const double end = percent_ ? 100 * most_ : most_;
    const double width = (difference_ ? 2 : 1) * end / steps;
    int decimals = width >= 10 ? 0 : width >= 1 ? 1 : 2; // more where a step is no such number: 12.5
    for (double scale = std::pow(10, decimals); decimals < 4 && std::abs(std::round(width * scale) - width * scale) > 1e-3 * width * scale;
         scale *= 10) {
        ++decimals;
    }
    const auto number = [&](double value) {
        const QString sign = difference_ && value > 0 ? "+" : value < 0 ? QString(QChar(0x2212)) : QString();
        return sign + shownNumber(std::abs(value), decimals);
    };
    QStringList all;
    for (int step = steps - 1; step >= 0; --step) {
        const double from = (difference_ ? -end : 0) + width * step;
        const double to = step + 1 == steps ? end : from + width;
        if (exceeded_ && step + 1 == steps) {
            all << tr("%1 and more").arg(number(from));
        } else if (exceeded_ && difference_ && step == 0) {
            all << tr("%1 and less").arg(number(to));
        } else {
            all << tr("%1 to %2").arg(number(from), number(to));
        }
    }
    return all;
}

/// Wide enough for any numbers, so that views beside it keep their place.
QSize StepLegend::sizeHint() const
{
    const QFontMetrics metrics(font());
    const int words =
        std::max(metrics.horizontalAdvance(tr("Difference B − A, g/m²")), box + 8 + metrics.horizontalAdvance(tr("−1000.5 and more")));
    return {words + 16, steps * box + 2 * metrics.height() + 24};
}

void StepLegend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QColor ink = palette().color(QPalette::WindowText);
    painter.setPen(ink);
    const int line = painter.fontMetrics().height();
    painter.drawText(QRect(8, 8, width() - 16, line), Qt::AlignLeft | Qt::AlignVCenter, title_);
    const QStringList words = texts();
    for (int row = 0; row < steps; ++row) {
        const double share = (steps - 1 - row + 0.5) / steps;
        const auto step = step_colour(share);
        const QRect square(8, 8 + line + 8 + row * box, box, box);
        painter.fillRect(square, difference_ ? differenceColor(2 * share - 1) : QColor(step[0], step[1], step[2]));
        painter.setPen(QColor("#707880"));
        painter.drawRect(square);
        painter.setPen(ink);
        painter.drawText(QRect(square.right() + 8, square.top(), width() - square.right() - 8, box), Qt::AlignLeft | Qt::AlignVCenter,
                         words[row]);
    }
}

} // namespace hygroloom
