// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whose undo Ctrl+Z is while a text field or a number box has the focus.
#pragma once

#include <QLineEdit>

class QAbstractSpinBox;
class QComboBox;

namespace hygroloom {

/// Leaves undo and redo to the window while the field holds nothing that was typed and not committed.
class DesignUndo : public QObject {
    Q_OBJECT
public:
    explicit DesignUndo(QLineEdit* field);
    explicit DesignUndo(QAbstractSpinBox* box);
    /// One that is editable.
    explicit DesignUndo(QComboBox* choice);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLineEdit* field_;
};

} // namespace hygroloom
