// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Main effects: the rows over each factor, and the mean of the metric through them.
#pragma once

#include "ui/study/effect_curve.h"
#include "ui/study/study_chart.h"

namespace hygroloom {

class EffectsChart : public StudyChart {
    Q_OBJECT
public:
    explicit EffectsChart(QWidget* parent = nullptr);
    /// Of the axes; nullptr: none.
    void setMetric(const StudyAxis* metric);
    QString tipAt(const QPointF& position) const override;

protected:
    void drawPicture(QPainter& painter) override;

private:
    void drawEffect(QPainter& painter, const QRectF& area, const StudyAxis& factor);

    const StudyAxis* metric_ = nullptr;
    std::vector<std::pair<QPointF, QString>> told_; ///< the means that are drawn, with their numbers
};

/// The chart with the choice of its metric.
class EffectsView : public QWidget {
    Q_OBJECT
public:
    explicit EffectsView(QWidget* parent = nullptr);
    void setStudy(const std::shared_ptr<const StudyData>& study);

private:
    std::shared_ptr<const StudyData> data_;
    QComboBox* metric_;
    EffectsChart* chart_;
};

} // namespace hygroloom
