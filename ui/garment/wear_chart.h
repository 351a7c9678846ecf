// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Curves over time: of the whole garment, or of the pinned cell; of A too where one is kept. A click shows that time.
#pragma once

#include "ui/garment/wear_playback.h"

#include <QWidget>

class QChart;
class QLineSeries;
class QValueAxis;

namespace hygroloom {

class CurveLegend;
class TimeChartView;

class WearChart : public QWidget {
    Q_OBJECT
public:
    explicit WearChart(WearPlayback& playback, QWidget* parent = nullptr);

    QString title() const;
    /// Of the newest run.
    QList<QPointF> points() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    QList<QPointF> curveOf(const WornRun& run) const;
    void refresh();
    void applyPalette();

    WearPlayback& playback_;
    QChart* chart_;
    TimeChartView* view_;
    CurveLegend* legend_;
    QValueAxis* time_;
    QValueAxis* value_;
    QLineSeries* newest_;
    QLineSeries* kept_;
};

} // namespace hygroloom
