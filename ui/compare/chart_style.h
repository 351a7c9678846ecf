// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How the charts of the compare workspace look: one stroke for each run, and axes in the palette's colours.
#pragma once

#include <QPen>

class QAbstractAxis;
class QChart;
class QLabel;
class QWidget;

namespace hygroloom {

/// Runs differ by dash as well as by colour.
QPen strokeOf(std::size_t run, const QPalette& palette);
/// The chart's background, and its axes.
void styleChart(QChart& chart, const QWidget& widget);
/// A line of quiet text under a chart, which says what it draws.
QLabel* makeNote(const QString& accessible_name);

} // namespace hygroloom
