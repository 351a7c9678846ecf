// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A wheel over a panel is for scrolling it, not for changing the fibre that happens to pass under the pointer.
#pragma once

#include <QObject>

namespace hygroloom {

class WheelGuard : public QObject {
    Q_OBJECT
public:
    explicit WheelGuard(QObject* parent) : QObject(parent) {}

    /// Choices within it no longer turn with the wheel, and counts do so only while they have the focus.
    void guard(QWidget* panel);
    /// Sliders within it no longer turn with the wheel, either.
    void guardSliders(QWidget* panel);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void watch(QWidget* field);
};

} // namespace hygroloom
