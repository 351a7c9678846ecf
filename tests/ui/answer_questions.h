// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Answers the questions of widgets that stand in no window of the program.
#pragma once

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <memory>

namespace hygroloom {

/// Presses the button of that text in each question, as long as it lives.
inline std::unique_ptr<QTimer> answerQuestions(const QString& text)
{
    auto timer = std::make_unique<QTimer>();
    QObject::connect(timer.get(), &QTimer::timeout, [text] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        for (QAbstractButton* button : box ? box->buttons() : QList<QAbstractButton*>()) {
            if (button->text().remove('&') == text) { button->click(); }
        }
    });
    timer->start(50);
    return timer;
}

} // namespace hygroloom
