// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Two numbers of all candidates against each other, with their intervals, and the candidates that no other beats in both.
#pragma once

#include "ui/compare/chart_data.h"

#include <QPointF>
#include <QWidget>

class QChart;
class QComboBox;
class QLabel;
class QValueAxis;
class QScatterSeries;
class QXYSeries;

namespace hygroloom {

class PointedChartView;

/// A candidate with its intervals.
struct ScatterPoint {
    QPointF low, at, high;
    QString name;
    QString words; ///< name, and both numbers with their intervals and units
};

class ScatterView : public QWidget {
    Q_OBJECT
public:
    explicit ScatterView(QWidget* parent = nullptr);

    /// Judged.
    void setComparison(const Comparison& comparison);
    /// Names of the candidates on the front, from left to right.
    QStringList front() const { return front_; }
    /// Of the markers, those that are seen.
    QStringList labels() const;
    void choose(int x, int y);
    PointedChartView* view() { return view_; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void draw();
    void placeLabels();
    void addPoint(const ScatterPoint& point, const QString& label, bool on_front);
    void add(QXYSeries* series);
    static void setRange(QValueAxis* axis, double low, double high);

    Comparison comparison_;
    bool proposing_ = true; ///< until the user chooses
    QStringList front_;
    struct Label {
        QScatterSeries* marker;
        QString text;
        bool on_front;
    };
    std::vector<Label> labels_;
    QComboBox* x_;
    QComboBox* y_;
    QLabel* value_;
    QChart* chart_;
    PointedChartView* view_;
    QValueAxis* across_;
    QValueAxis* up_;
    QLabel* note_;
};

} // namespace hygroloom
