// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Curves of a run over time, with the shown time as a vertical line.
#pragma once

#include "ui/results/shown_run.h"

#include <QWidget>

class QChart;
class QLineSeries;
class QValueAxis;

namespace hygroloom {

class CurveLegend;
class TimeChartView;

/// The plots of a run side by side: of a sample where the water is, and what the type of experiment measures. A click shows that time.
class Chart : public QWidget {
    Q_OBJECT
public:
    explicit Chart(ShownRun& shown, QWidget* parent = nullptr);

    /// Of the first curve.
    QList<QPointF> points() const;
    /// Names of the curves in the plot on the left.
    QStringList curves() const;
    /// Of the last plot: "Wetted radius, mm".
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
    static void fill(PlotView& view, const TimePlot& plot);
    void setRanges(PlotView& view, const TimePlot& plot) const;
    static void refreshLegend(PlotView& plot);
    void applyPalette();

    ShownRun& shown_;
    std::vector<PlotView> plots_;
};

} // namespace hygroloom
