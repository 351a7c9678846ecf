// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/typed_value.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPointer>

namespace hygroloom {

namespace {

/// Follows parents across windows: a floating panel is part of the window it came from.
bool isPartOf(const QObject* part, const QObject* whole)
{
    while (part && part != whole) { part = part->parent(); }
    return part;
}

} // namespace

void commitTypedValue(QWidget& window)
{
    QWidget* focus = QApplication::focusWidget();
    const QPointer<QWidget> field = isPartOf(focus, &window) ? focus : window.focusWidget();
    if (!qobject_cast<QLineEdit*>(field) && !qobject_cast<QAbstractSpinBox*>(field) && !qobject_cast<QComboBox*>(field)) { return; }
    field->clearFocus();
    if (field && field->isVisible()) { // the editor of a name in a list is deleted by now
        field->setFocus();
    }
}

} // namespace hygroloom
