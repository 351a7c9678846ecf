// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/chart_style.h"

#include "ui/basics/appearance.h"

#include <QAbstractAxis>
#include <QChart>
#include <QLabel>
#include <QLegend>
#include <QWidget>

namespace hygroloom {

namespace {

struct Stroke {
    const char* light;
    const char* dark;
    Qt::PenStyle style;
};

constexpr Stroke strokes[] = {{"#0b6aa8", "#5ab0e8", Qt::SolidLine},
                              {"#9a5b00", "#e0a94a", Qt::DashLine},
                              {"#7a3f98", "#c79be0", Qt::DashDotLine},
                              {"#2f6b36", "#86c98e", Qt::DotLine}};

} // namespace

QPen strokeOf(std::size_t run, const QPalette& palette)
{
    const Stroke& stroke = strokes[run % std::size(strokes)];
    return QPen(QColor(isDark(palette) ? stroke.dark : stroke.light), 2, stroke.style);
}

void styleChart(QChart& chart, const QWidget& widget)
{
    const QPalette& palette = widget.palette();
    const QColor ink = palette.color(QPalette::WindowText);
    QColor grid = ink;
    grid.setAlphaF(0.15F);
    chart.setMargins(QMargins(4, 4, 8, 0));
    chart.setBackgroundRoundness(0);
    chart.setBackgroundBrush(palette.color(QPalette::Window));
    chart.legend()->hide(); // its pieces of the lines are too short for dashes
    for (QAbstractAxis* axis : chart.axes()) {
        axis->setLabelsColor(ink);
        axis->setLabelsFont(widget.font());
        axis->setTitleBrush(ink);
        axis->setTitleFont(widget.font());
        axis->setGridLineColor(grid);
        axis->setLinePen(QPen(grid, 1));
    }
}

QLabel* makeNote(const QString& accessible_name)
{
    auto* note = new QLabel;
    note->setAccessibleName(accessible_name);
    note->setWordWrap(true);
    note->setTextFormat(Qt::PlainText);
    note->setForegroundRole(QPalette::PlaceholderText);
    note->setContentsMargins(8, 0, 8, 4);
    return note;
}

} // namespace hygroloom
