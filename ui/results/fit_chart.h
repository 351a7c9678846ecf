// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Measured points with the simulated curves before and after a calibration.
#pragma once

#include "core/analysis/calibration.h"

#include "ui/results/pointed_chart_view.h"

class QLineSeries;
class QScatterSeries;
class QValueAxis;

namespace hygroloom {

class FitChart : public PointedChartView {
    Q_OBJECT
public:
    explicit FitChart(QWidget* parent = nullptr);

    /// Of a curve; without runs only what was measured. Of metrics it is empty.
    void show(const Calibration& calibration);

protected:
    void changeEvent(QEvent* event) override;

private:
    void applyPalette();

    QScatterSeries* measured_;
    QLineSeries* before_;
    QLineSeries* fitted_;
    QValueAxis* time_;
    QValueAxis* value_;
};

} // namespace hygroloom
