// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Curves of a run over time, with the shown moment as an upright line.
#pragma once

#include "ui/results/playback.h"

#include <QWidget>

class QChart;
class QLineSeries;
class QValueAxis;

namespace hygroloom {

class CurveLegend;
class TimeChartView;
struct PlotContent;

/// Where the water is on the left, what the type of experiment is about on the right. A click shows that moment.
class Chart : public QWidget {
    Q_OBJECT
public:
    explicit Chart(Playback& playback, QWidget* parent = nullptr);

    /// Points of the curve of free water, for those who want to know that there are any.
    int points() const;
    /// Names of the curves in the plot on the left.
    QStringList waterCurves() const;
    /// Of the plot on the right: "Wetted radius, mm".
    QString title() const;

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Plot {
        TimeChartView* view = nullptr;
        CurveLegend* legend = nullptr;
        QChart* chart = nullptr;
        QValueAxis* time = nullptr;
        QValueAxis* value = nullptr;
        std::vector<QLineSeries*> lines;
    };
    Plot addPlot();
    void refresh();
    void fill(Plot& plot, const PlotContent& content);
    static void refreshLegend(Plot& plot);
    void applyPalette();

    Playback& playback_;
    Plot water_;
    Plot subject_;
};

} // namespace hygroloom
