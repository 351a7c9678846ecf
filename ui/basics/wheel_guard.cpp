// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace hygroloom {

void WheelGuard::guard(QWidget* panel)
{
    for (QComboBox* choice : panel->findChildren<QComboBox*>()) { watch(choice); }
    for (QAbstractSpinBox* count : panel->findChildren<QAbstractSpinBox*>()) { watch(count); }
}

void WheelGuard::guardSliders(QWidget* panel)
{
    for (QSlider* slider : panel->findChildren<QSlider*>()) { watch(slider); }
}

void WheelGuard::watch(QWidget* field)
{
    field->setFocusPolicy(Qt::StrongFocus); // the wheel gives no focus either
    field->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::Wheel) { return QObject::eventFilter(watched, event); }
    const auto* count = qobject_cast<QAbstractSpinBox*>(watched);
    if (count && count->hasFocus()) { return false; }
    event->ignore(); // so that the widget behind it scrolls
    return true;
}

} // namespace hygroloom
