// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the eight colours stand for, in numbers; or those of a difference.
#pragma once

#include <QWidget>

namespace hygroloom {

class StepLegend : public QWidget {
    Q_OBJECT
public:
    explicit StepLegend(QWidget* parent = nullptr);

    /// most: at the scale's end. exceeded: some cell has more.
    void setSteps(const QString& title, double most, bool percent, bool exceeded);
    void setDifference(const QString& title, double most, bool percent, bool exceeded);
    /// From the highest step to the lowest.
    QStringList texts() const;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void set(const QString& title, double most, bool percent, bool exceeded, bool difference);

    QString title_;
    double most_ = 1;
    bool percent_ = false, exceeded_ = false, difference_ = false;
};

/// Where a step of a difference lies, of -1 to 1, and its colour; steps from 0 to 7.
double differenceStep(double share);

} // namespace hygroloom
