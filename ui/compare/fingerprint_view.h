// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A radar chart of all numbers of several runs: grades where the experiment has them, else from worst to best.
#pragma once

#include "ui/compare/chart_data.h"

#include <QWidget>

class QLabel;
class QPolarChart;

namespace hygroloom {

class CurveLegend;
class PointedChartView;

class FingerprintView : public QWidget {
    Q_OBJECT
public:
    explicit FingerprintView(QWidget* parent = nullptr);

    /// The candidates of these names, as they stand in the comparison.
    void setCandidates(const Comparison& comparison, const std::vector<std::string>& names);
    const Fingerprint& fingerprint() const { return shown_; }
    PointedChartView* view() { return view_; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void draw();
    void addAxes();

    Fingerprint shown_;
    QStringList titles_;
    std::size_t candidates_ = 0;
    QPolarChart* chart_;
    PointedChartView* view_;
    CurveLegend* legend_;
    QLabel* note_;
};

} // namespace hygroloom
