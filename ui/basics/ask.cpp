// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/ask.h"

#include "ui/basics/appearance.h"

#include <QApplication>
#include <QColorDialog>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int icon_size = 40;

/// The text is plain: it has names of files and fabrics.
void dress(QMessageBox& box, const QString& icon, const QString& title, const QString& text, const QString& under)
{
    box.setWindowTitle(title);
    box.setIconPixmap(themedIcon(icon).pixmap(icon_size, icon_size));
    box.setTextFormat(Qt::PlainText);
    box.setText(text);
    box.setInformativeText(under);
}

QMessageBox::StandardButton standardOf(Reply answer)
{
    switch (answer) {
    case Reply::cancel: return QMessageBox::Cancel;
    case Reply::save: return QMessageBox::Save;
    case Reply::lose: return QMessageBox::Discard;
    case Reply::act: break;
    }
    return QMessageBox::Ok;
}

} // namespace

Reply ask(QWidget* parent, const Question& question)
{
    QMessageBox box(parent);
    const auto loses = [](const Choice& choice) { return choice.answer == Reply::lose; };
    const bool dangerous = std::any_of(question.choices.begin(), question.choices.end(), loses);
    dress(box, dangerous ? "warning" : "note", question.title, question.text, question.consequence);
    for (const Choice& choice : question.choices) {
        QPushButton* button = box.addButton(standardOf(choice.answer));
        button->setText(choice.button);
        button->setIcon({});
        if (choice.answer == question.preset) { box.setDefaultButton(button); }
        if (choice.answer == Reply::cancel) { box.setEscapeButton(button); }
    }
    const int pressed = box.exec();
    for (const Choice& choice : question.choices) {
        if (pressed == standardOf(choice.answer)) { return choice.answer; }
    }
    return Reply::cancel;
}

bool confirm(QWidget* parent, const QString& title, const QString& question, const QString& consequence, const QString& button)
{
    const QString cancel = QCoreApplication::translate("hygroloom", "Cancel");
    return ask(parent, {title, question, consequence, {{Reply::act, button}, {Reply::cancel, cancel}}}) == Reply::act;
}

void tell(QWidget* parent, const QString& sentence)
{
    for (const QMessageBox* open : parent->findChildren<QMessageBox*>()) {
        if (open->text() == sentence) { return; } // what fails at each edit is said once
    }
    auto* box = new QMessageBox(parent);
    dress(*box, "warning", QCoreApplication::translate("hygroloom", "Hygroloom"), sentence, {});
    box->setStandardButtons(QMessageBox::Ok);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void tellInFull(QWidget* parent, const QString& title, const QString& sentence, const QString& more, const QString& all)
{
    QMessageBox box(parent);
    dress(box, "note", title, sentence, more);
    box.setDetailedText(all);
    box.setStandardButtons(QMessageBox::Close);
    box.exec();
}

std::optional<QColor> askColor(QWidget* parent, const QString& title, const QColor& now)
{
    const QColor chosen = QColorDialog::getColor(now, parent, title, QColorDialog::DontUseNativeDialog);
    return chosen.isValid() ? std::optional(chosen) : std::nullopt;
}

} // namespace hygroloom
