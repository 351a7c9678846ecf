// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Curves of several runs over each other: the middle of a cloth's replicates with their band, of a run alone its curve with the band of its
// numerical error.
#pragma once

#include "ui/compare/chart_data.h"
#include "ui/results/run_history.h"

#include <QWidget>

class QChart;
class QComboBox;
class QLabel;
class QValueAxis;

namespace hygroloom {

class CurveLegend;
class PointedChartView;

class CurvesView : public QWidget {
    Q_OBJECT
public:
    explicit CurvesView(QWidget* parent = nullptr);

    /// Of the same experiment, with their titles; those whose titles are names of candidates have their replicates. part: of garments.
    void setRuns(const std::vector<KeptRun>& runs, const QStringList& titles, const Comparison& comparison = {},
                 const WearPartName& part = {});
    int lines() const { return lines_; }
    int bands() const { return bands_; }
    /// What the legend says of the bands, and the line below it.
    QStringList bandNames() const { return band_names_; }
    QString note() const;
    PointedChartView* view() { return view_; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void draw();
    /// What its band is of: a number of replicates, 0: the numerical error; none: it has no band.
    CurvePoints pointsOfRun(std::size_t run, const CurveChoice& choice) const;
    std::optional<int> addRun(std::size_t run, const CurveChoice& choice);
    QString noteOf(const CurveChoice& choice, const std::vector<std::optional<int>>& bands) const;
    const Candidate* candidateOf(std::size_t run) const;

    std::vector<KeptRun> runs_;
    QStringList titles_;
    Comparison comparison_;
    std::vector<CurveChoice> choices_;
    QComboBox* curve_;
    QLabel* value_;
    QChart* chart_;
    PointedChartView* view_;
    QValueAxis* time_;
    QValueAxis* axis_;
    CurveLegend* legend_;
    QLabel* note_;
    QStringList band_names_;
    int lines_ = 0, bands_ = 0;
    double lowest_ = 0, highest_ = 0, end_ = 0;
};

} // namespace hygroloom
