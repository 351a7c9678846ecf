// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a lesson leaves behind: recordings of its cloths and films of its table, which are whole before it closes.
#include "ui/basics/ask.h"
#include "ui/basics/film_end.h"
#include "ui/lesson/lesson_scene.h"
#include "ui/lesson/lesson_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QFile>
#include <QFileDialog>
#include <QMenu>

#include <utility>

namespace hygroloom {

void LessonWindow::fillSaveMenu()
{
    save_menu_->clear();
    if (!table_) { return; }
    for (int k = 0; k < table_->cloths(); ++k) {
        const QString title = QString::fromStdString(lesson_.cloths[static_cast<std::size_t>(k)].title).replace('&', "&&");
        QAction* action = save_menu_->addAction(tr("Recording of %1…").arg(title));
        action->setEnabled(table_->view(k) != nullptr);
        connect(action, &QAction::triggered, this, [this, k] { saveRecording(k); });
    }
    save_menu_->addSeparator();
    if (film_.runs()) {
        connect(save_menu_->addAction(tr("End Film")), &QAction::triggered, this, &LessonWindow::endFilm);
        return;
    }
    if (film_.busy()) {
        save_menu_->addAction(tr("The film is being written…"))->setEnabled(false);
        return;
    }
    connect(save_menu_->addAction(tr("Film as Pictures (PNG)…")), &QAction::triggered, this, [this] { saveFilm(false); });
    connect(save_menu_->addAction(tr("Film (MP4)…")), &QAction::triggered, this, [this] { saveFilm(true); });
}

/// Empty: cancelled.
QString LessonWindow::askForFile(const QString& title, const QString& name, const QString& kind, const QString& ending)
{
    QFileDialog dialog(this, title, {}, kind);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending); // the dialog asks before it replaces a file of the whole name
    dialog.selectFile(name);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) { return {}; }
    const QString chosen = dialog.selectedFiles().front();
    if (chosen.endsWith('.' + ending, Qt::CaseInsensitive)) { return chosen; }
    const QString path = chosen + '.' + ending; // of a name with another ending
    const bool may = !QFile::exists(path) || confirm(this, title, tr("%1 is there already. Replace it?").arg(path),
                                                     tr("What is in that file is lost."), tr("&Replace"));
    return may ? path : QString();
}

void LessonWindow::saveRecording(int cloth)
{
    const QString path = askForFile(tr("Save Recording"), "lesson.hygrorec", tr("Recordings (*.hygrorec)"), "hygrorec");
    if (path.isEmpty() || !table_) { return; }
    table_->record(cloth, [this, path](const RecordedCloth& recorded) { // in a thread that ends before this window
        QString sentence = tr("Saved %1.").arg(path);
        bool failed = false;
        try {
            write_recording(recorded, QFile::encodeName(path).toStdString());
        } catch (const std::exception& error) {
            sentence = QString::fromStdString(error.what());
            failed = true;
        }
        QMetaObject::invokeMethod(
            this, [this, sentence, failed] { recordingEnded(sentence, failed); }, Qt::QueuedConnection);
    });
}

void LessonWindow::recordingEnded(const QString& sentence, bool failed)
{
    if (failed) { not_saved_ = sentence; }
    say(sentence);
}

void LessonWindow::saveFilm(bool movie)
{
    bool runs = false;
    if (movie) {
        if (!Film::whyNoMovie().isEmpty()) { // said before a name is asked for
            film_.startMovie({});
            return;
        }
        const QString path = askForFile(tr("Save Film"), "lesson.mp4", tr("Films (*.mp4)"), "mp4");
        runs = !path.isEmpty() && film_.startMovie(path);
    } else {
        const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the Pictures"));
        runs = !folder.isEmpty() && film_.startPictures(folder);
    }
    if (!runs) { return; }
    pictures_.start();
    say(tr("The table is being filmed. Save ▸ End Film ends it."));
}

void LessonWindow::endFilm()
{
    pictures_.stop();
    film_.finish();
    if (film_.busy()) { say(tr("The film is being written…")); }
}

void LessonWindow::leaveFilm(bool keep)
{
    pictures_.stop();
    closing_ = false; // who ends the film closes what is to be closed
    if (keep) {
        endInDialog(film_, this);
    } else {
        film_.cancel();
    }
}

void LessonWindow::filmEnded(const QString& sentence)
{
    pictures_.stop();
    say(sentence);
    // What is open over the lesson is not taken away.
    if (std::exchange(closing_, false) && !QApplication::activeModalWidget() && !QApplication::activePopupWidget()) { close(); }
}

/// A film that runs is kept: the lesson stays until it is written, or until the user leaves without it. Recordings are waited for.
void LessonWindow::closeEvent(QCloseEvent* event)
{
    const bool waits = std::exchange(closing_, false);
    endFilm();
    if (film_.busy() && !waits) {
        closing_ = true;
        say(tr("The film is being written; then the lesson ends."));
        event->ignore();
        return;
    }
    if (film_.busy() &&
        !confirm(this, tr("The film is being written"), tr("Leave without the film?"), tr("What was filmed is lost."), tr("&Leave"))) {
        closing_ = film_.busy();
        event->ignore();
        return;
    }
    film_.cancel();
    scene_->setTable(nullptr, {});
    not_saved_.clear();
    table_.reset();
    QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    if (!not_saved_.isEmpty() && parentWidget()) { tell(parentWidget(), not_saved_); }
    QWidget::closeEvent(event);
}

} // namespace hygroloom
