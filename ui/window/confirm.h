// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Questions before something is stopped or lost.
#pragma once

#include <QMessageBox>
#include <QPushButton>

namespace hygroloom {

/// True when the user presses the button instead of Cancel, which is the default. consequence: what pressing it does, in a sentence.
inline bool confirm(QWidget* parent, const QString& title, const QString& question, const QString& consequence, const QString& button)
{
    QMessageBox box(QMessageBox::Question, title, question, QMessageBox::Cancel, parent);
    box.setInformativeText(consequence);
    const QPushButton* agreed = box.addButton(button, QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == agreed;
}

} // namespace hygroloom
