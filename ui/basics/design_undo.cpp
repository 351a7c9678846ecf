// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/design_undo.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>

namespace hygroloom {

DesignUndo::DesignUndo(QLineEdit* field) : QObject(field), field_(field) { field->installEventFilter(this); }

DesignUndo::DesignUndo(QAbstractSpinBox* box) : QObject(box), field_(box->findChild<QLineEdit*>())
{
    box->installEventFilter(this); // the focus is the box's
    connect(box, &QAbstractSpinBox::editingFinished, field_, [this] { field_->setModified(false); });
}

DesignUndo::DesignUndo(QComboBox* choice) : QObject(choice), field_(choice->lineEdit())
{
    choice->installEventFilter(this); // the focus is the choice's
}

bool DesignUndo::eventFilter(QObject* watched, QEvent* event)
{
    // A field accepts the override of every key it would handle itself; one that is swallowed unaccepted goes to the shortcuts.
    if (event->type() == QEvent::ShortcutOverride && !field_->isModified()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace hygroloom
