// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Curves of several runs over each other, each with the band of its numerical error.
#pragma once

#include "ui/compare/chart_data.h"
#include "ui/results/run_history.h"

#include <QWidget>

class QChart;
class QChartView;
class QComboBox;
class QLabel;
class QValueAxis;

namespace hygroloom {

class CurveLegend;

class CurvesView : public QWidget {
    Q_OBJECT
public:
    explicit CurvesView(QWidget* parent = nullptr);

    /// Of the same experiment, with their titles.
    void setRuns(const std::vector<KeptRun>& runs, const QStringList& titles);
    int lines() const { return lines_; }
    int bands() const { return bands_; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void draw();
    void addRun(std::size_t run, const CurveChoice& choice);

    std::vector<KeptRun> runs_;
    QStringList titles_;
    std::vector<CurveChoice> choices_;
    QComboBox* curve_;
    QLabel* value_;
    QChart* chart_;
    QChartView* view_;
    QValueAxis* time_;
    QValueAxis* axis_;
    CurveLegend* legend_;
    QLabel* note_;
    int lines_ = 0, bands_ = 0;
    double lowest_ = 0, highest_ = 0;
};

} // namespace hygroloom
