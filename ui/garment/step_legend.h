// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the eight colours stand for, in numbers; or those of a difference.
#pragma once

#include "core/wear/wear_map.h"

#include <QWidget>

namespace hygroloom {

class StepLegend : public QWidget {
    Q_OBJECT
public:
    explicit StepLegend(QWidget* parent = nullptr);

    /// exceeded: some cell has more than the last step's end.
    void setSteps(const QString& title, const WearSteps& steps, bool percent, bool exceeded);
    /// Even steps from −most to most.
    void setDifference(const QString& title, double most, bool percent, bool exceeded);
    /// From the highest step to the lowest.
    QStringList texts() const;
    const WearSteps& ends() const { return ends_; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void setAll(const QString& title, bool percent, bool exceeded, bool difference);

    QString title_;
    WearSteps ends_ = even_steps(1);
    double begin_ = 0; ///< of the lowest step
    bool percent_ = false, exceeded_ = false, difference_ = false;
};

/// Where a step of a difference lies, of -1 to 1, and its colour; steps from 0 to 7.
double differenceStep(double share);

} // namespace hygroloom
