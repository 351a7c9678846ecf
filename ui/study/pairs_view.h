// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any two columns of a study against each other, coloured by a third; a click chooses a row.
#pragma once

#include "ui/study/study_chart.h"

namespace hygroloom {

class PairsChart : public StudyChart {
    Q_OBJECT
public:
    explicit PairsChart(QWidget* parent = nullptr);
    /// nullptr: none.
    void setAxes(const StudyAxis* across, const StudyAxis* up, const StudyAxis* color);
    /// Where a row stands in the widget; none: it lacks a number.
    std::optional<QPointF> placeOf(std::size_t row) const;
    /// The row that is nearest, within a few pixels.
    std::optional<std::size_t> rowAt(const QPointF& position) const;
    QString tipAt(const QPointF& position) const override;

protected:
    void drawPicture(QPainter& painter) override;
    void drawMarks(QPainter& painter) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF area() const;
    void drawColors(QPainter& painter) const;

    const StudyAxis* across_ = nullptr;
    const StudyAxis* up_ = nullptr;
    const StudyAxis* color_ = nullptr;
};

class PairsView : public QWidget {
    Q_OBJECT
public:
    explicit PairsView(QWidget* parent = nullptr);
    void setStudy(const std::shared_ptr<const StudyData>& study);
    PairsChart& chart() { return *chart_; }

private:
    void choose();

    std::shared_ptr<const StudyData> data_;
    QComboBox* across_;
    QComboBox* up_;
    QComboBox* color_;
    PairsChart* chart_;
};

} // namespace hygroloom
