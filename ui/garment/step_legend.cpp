// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/step_legend.h"

#include "ui/basics/color_map.h"
#include "ui/basics/quantity.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace hygroloom {

namespace {

constexpr int steps = std::tuple_size_v<WearSteps>;
constexpr int box = 22, edge = 8;

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

void StepLegend::setSteps(const QString& title, const WearSteps& ends, bool percent, bool exceeded)
{
    ends_ = ends;
    begin_ = 0;
    setAll(title, percent, exceeded, false);
}

void StepLegend::setDifference(const QString& title, double most, bool percent, bool exceeded)
{
    ends_ = even_steps(2 * most);
    for (double& end : ends_) { end -= most; }
    ends_[steps / 2 - 1] = 0;
    begin_ = -most;
    setAll(title, percent, exceeded, true);
}

void StepLegend::setAll(const QString& title, bool percent, bool exceeded, bool difference)
{
    title_ = title;
    percent_ = percent;
    exceeded_ = exceeded;
    difference_ = difference;
    setAccessibleDescription(title + ": " + texts().join("; "));
    updateGeometry();
    update();
}

QStringList StepLegend::texts() const
{
    std::array<double, steps + 1> limits{};
    double width = std::numeric_limits<double>::max(); // of the narrowest step
    for (std::size_t k = 0; k < limits.size(); ++k) {
        limits[k] = (percent_ ? 100 : 1) * (k > 0 ? ends_[k - 1] : begin_);
        if (k > 0) { width = std::min(width, limits[k] - limits[k - 1]); }
    }
    int decimals = width >= 10 ? 0 : width >= 1 ? 1 : 2; // more where a step is no such number: 12.5
    const auto rounds = [&](double limit) {
        const double scale = std::pow(10, decimals);
        return std::abs(std::round(limit * scale) - limit * scale) <= 1e-3 * width * scale;
    };
    while (decimals < 4 && !std::all_of(limits.begin(), limits.end(), rounds)) { ++decimals; }
    const auto number = [&](double value) {
        const QString sign = difference_ && value > 0 ? "+" : value < 0 ? QString(QChar(0x2212)) : QString();
        return sign + shownNumber(std::abs(value), decimals);
    };
    QStringList all;
    for (int step = steps - 1; step >= 0; --step) {
        const double from = limits[static_cast<std::size_t>(step)], to = limits[static_cast<std::size_t>(step) + 1];
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
    return {words + 2 * edge, steps * box + metrics.height() + 3 * edge};
}

/// As low as its words are, where two legends share a low window.
QSize StepLegend::minimumSizeHint() const
{
    const int line = QFontMetrics(font()).height();
    return {sizeHint().width(), (steps + 1) * line + 3 * edge};
}

void StepLegend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QColor ink = palette().color(QPalette::WindowText);
    painter.setPen(ink);
    const int line = painter.fontMetrics().height();
    painter.drawText(QRect(edge, edge, width() - 2 * edge, line), Qt::AlignLeft | Qt::AlignVCenter, title_);
    const int high = std::min(box, (height() - line - 3 * edge) / steps);
    const QStringList words = texts();
    for (int row = 0; row < steps; ++row) {
        const double share = (steps - 1 - row + 0.5) / steps;
        const auto step = step_colour(static_cast<std::size_t>(steps - 1 - row));
        const QRect square(edge, edge + line + edge + row * high, box, high);
        painter.fillRect(square, difference_ ? differenceColor(2 * share - 1) : QColor(step[0], step[1], step[2]));
        painter.setPen(QColor("#707880"));
        painter.drawRect(square);
        painter.setPen(ink);
        painter.drawText(QRect(square.right() + edge, square.top(), width() - square.right() - edge, high),
                         Qt::AlignLeft | Qt::AlignVCenter, words[row]);
    }
}

} // namespace hygroloom
