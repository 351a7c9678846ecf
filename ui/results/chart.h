// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Curves of a run over time, with the shown time as a vertical line.
#pragma once

#include "ui/results/playback.h"

#include <QWidget>

class QChart;
class QLineSeries;
class QValueAxis;

namespace hygroloom {

class CurveLegend;
class TimeChartView;
struct UserUnit;
struct Plot;

/// Where the water is on the left, what the type of experiment measures on the right. A click shows that time.
class Chart : public QWidget {
    Q_OBJECT
public:
    explicit Chart(Playback& playback, QWidget* parent = nullptr);

    /// Points of the first curve.
    int points() const;
    /// Names of the curves in the plot on the left.
    QStringList waterCurves() const;
    /// Of the plot on the right: "Wetted radius, mm".
    QString title() const;

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct PlotView {
        TimeChartView* view = nullptr;
        CurveLegend* legend = nullptr;
        QChart* chart = nullptr;
        QValueAxis* time = nullptr;
        QValueAxis* value = nullptr;
        std::vector<QLineSeries*> lines;
    };
    PlotView addPlot();
    void refresh();
    void fill(PlotView& view, const Plot& plot);
    void setRanges(PlotView& view, bool fromZero, double lowest, double highest, const UserUnit& user) const;
    static void refreshLegend(PlotView& plot);
    void applyPalette();

    Playback& playback_;
    PlotView water_;
    PlotView subject_;
};

} // namespace hygroloom
