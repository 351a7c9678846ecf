// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Parallel coordinates: each row is a line through its numbers. A drag on an axis keeps the rows in that range.
#pragma once

#include "ui/study/study_chart.h"

namespace hygroloom {

class ParallelChart : public StudyChart {
    Q_OBJECT
public:
    explicit ParallelChart(QWidget* parent = nullptr);

    void setStudy(std::shared_ptr<const StudyData> study) override;
    /// By which lines are coloured; nullptr: none.
    void setColor(const StudyAxis* axis);
    const std::vector<AxisBrush>& brushes() const { return brushes_; }
    /// Replaces the brush of its axis.
    void brush(const AxisBrush& brush);
    void clearBrush(std::size_t axis);
    void clearBrushes();
    /// In the widget: of a number on an axis of the data.
    QPointF placeOf(std::size_t axis, double number) const;
    QString tipAt(const QPointF& position) const override;

Q_SIGNALS:
    void brushed();

protected:
    void drawPicture(QPainter& painter) override;
    void drawMarks(QPainter& painter) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF area() const;
    double xOf(std::size_t shown) const;
    double yOf(double place) const { return area().bottom() - place * area().height(); }
    std::size_t shownAt(double x) const;
    double numberAt(std::size_t shown, double y) const;
    void drawEach(QPainter& painter, bool kept) const;
    void drawBinned(QPainter& painter, bool kept) const;
    void drawAxis(QPainter& painter, std::size_t shown) const;
    void brushByKeys(int key, bool widen);

    std::vector<std::size_t> shown_; ///< the axes of the data that are drawn, from left to right
    std::vector<AxisBrush> brushes_;
    const StudyAxis* color_ = nullptr;
    std::size_t at_ = 0; ///< the axis that keys change
    struct Drag {
        std::size_t shown;
        double from, to; ///< y
    };
    std::optional<Drag> drag_;
};

class ParallelView : public QWidget {
    Q_OBJECT
public:
    explicit ParallelView(QWidget* parent = nullptr);
    void setStudy(const std::shared_ptr<const StudyData>& study);
    ParallelChart& chart() { return *chart_; }

private:
    std::shared_ptr<const StudyData> data_;
    QComboBox* color_;
    ParallelChart* chart_;
};

} // namespace hygroloom
