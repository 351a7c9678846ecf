// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How the program asks and tells: buttons name what they do, and what would be lost stands under the question.
#pragma once

#include <QColor>
#include <QList>
#include <QString>

#include <optional>

class QMessageBox;
class QWidget;

namespace hygroloom {

/// What pressing a button comes to; lose: something is lost for good.
enum class Reply { cancel, act, save, lose };

struct Choice {
    Reply answer = Reply::act;
    QString button; ///< names the act: "Stop the Export"
};

/// Each answer at most once. Closing the window cancels.
struct Question {
    QString title;
    QString text;
    QString consequence; ///< what follows, in a sentence; what would be lost
    QList<Choice> choices;
    Reply preset = Reply::cancel; ///< of Enter
};

Reply ask(QWidget* parent, const Question& question);

/// True when the user presses the button instead of Cancel, which is the default. consequence: what pressing it does, in a sentence.
bool confirm(QWidget* parent, const QString& title, const QString& question, const QString& consequence, const QString& button);

/// A sentence that asks nothing, in a window that lets the program go on. One that is open already is not opened twice.
void tell(QWidget* parent, const QString& sentence);
/// The same, until it is closed. more: a few lines under it; all: the whole list, shown on request.
void tellInFull(QWidget* parent, const QString& title, const QString& sentence, const QString& more, const QString& all = {});

/// In the look of the program, whatever the desktop has. None: cancelled.
std::optional<QColor> askColor(QWidget* parent, const QString& title, const QColor& now);

} // namespace hygroloom
