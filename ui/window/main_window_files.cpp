// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Opening, saving, recent files, dropped files, closing.
#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "ui/basics/examples.h"
#include "ui/export/export_dialog.h"
#include "ui/panels/candidates_panel.h"
#include "ui/results/plan_dialog.h"
#include "ui/weave/import_dialog.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDir>
#include <QDragEnterEvent>
#include <QEventLoop>
#include <QFileDialog>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSaveFile>
#include <QScopedValueRollback>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int most_recent_files = 8;

bool isRecording(const QString& path) { return path.endsWith(".hygrorec", Qt::CaseInsensitive); }

bool isDraft(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    return QStringList{"wif", "txt", "png", "bmp"}.contains(ending);
}

QString readablePath(const QMimeData* data)
{
    for (const QUrl& url : data->urls()) {
        const QString path = url.toLocalFile();
        if (path.endsWith(".hygro", Qt::CaseInsensitive) || isRecording(path) || isDraft(path)) { return path; }
    }
    return {};
}

/// What was there stays until the copy is complete. Why it could not be made, or nothing.
QString copyOver(const QString& from, const QString& to)
{
    try {
        write_file_with(to.toStdString(), [&from](const std::filesystem::path& temporary) {
            std::error_code error;
            if (!std::filesystem::copy_file(from.toStdString(), temporary, std::filesystem::copy_options::overwrite_existing, error)) {
                throw Error(error.message());
            }
        });
        return {};
    } catch (const std::exception& error) {
        return QString::fromStdString(error.what());
    }
}

QString withEnding(const QString& path, const QString& ending) { return path.endsWith(ending, Qt::CaseInsensitive) ? path : path + ending; }

} // namespace

bool MainWindow::openFile(const QString& path)
{
    if (isDraft(path)) { return importDraft(path); }
    if (isRecording(path)) {
        if (run_.running() && !mayStopRun()) { return false; }
        opening_ = QFileInfo(path).absoluteFilePath();
        openRecording(opening_);
        return true;
    }
    if (!mayDiscard() || !document_.open(path)) { return false; }
    if (!run_.running()) { playback_.clear(); }
    addRecentFile(document_.path());
    return true;
}

/// Another run of this window; the project stays.
void MainWindow::showRun(const QString& recording)
{
    if (!run_.running() || mayStopRun()) {
        opening_.clear();
        openRecording(recording);
    }
}

/// A run that was stopped is handled first, so that it is kept.
void MainWindow::openRecording(const QString& path)
{
    if (run_.running()) {
        next_ = path;
    } else {
        playback_.open(path);
    }
}

void MainWindow::openShippedExample()
{
    if (const QString path = shippedExample(); !path.isEmpty()) { document_.openExample(path); }
}

void MainWindow::offerLeftOver()
{
    for (const LeftOver& left : recovery_.leftOver()) { offer(left); }
}

void MainWindow::offer(const LeftOver& left)
{
    const QString name = left.title.isEmpty() ? tr("Untitled") : left.title;
    QMessageBox box(QMessageBox::Question, tr("Unsaved work was kept"),
                    tr("Hygroloom ended before “%1” was saved. Open what was kept of it?").arg(name), QMessageBox::NoButton, this);
    box.setTextFormat(Qt::PlainText);
    const QString when = tr("Last changed on %1.").arg(QLocale().toString(left.when, QLocale::ShortFormat));
    const QString later = tr("The file %1 was saved later; what was kept opens beside it, and saving asks for a name.").arg(left.path);
    box.setInformativeText(left.outdated ? when + " " + later : when);
    QPushButton* open = box.addButton(tr("&Open"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    box.addButton(tr("&Ask Again Later"), QMessageBox::RejectRole);
    box.setDefaultButton(open);
    box.exec();
    if (box.clickedButton() == open && mayDiscard()) {
        recovery_.open(left);
    } else if (box.clickedButton() == discard) {
        Recovery::discard(left);
    }
}

void MainWindow::newProject()
{
    if (mayDiscard()) {
        Design design;
        design.experiments.push_back(Experiment{});
        design.experiments.front().name = tr("one drop").toStdString();
        document_.take(design, {});
        candidates_->addFabric();
        document_.history()->clear();
        if (!run_.running()) { playback_.clear(); }
    }
}

void MainWindow::chooseFile()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Open"), QFileInfo(document_.path()).absolutePath(),
                                                      tr("Projects and recordings (*.hygro *.hygrorec);;All files (*)"));
    if (!path.isEmpty()) { openFile(path); }
}

bool MainWindow::save()
{
    takeTypedValue();
    return document_.path().isEmpty() ? saveAs() : document_.save();
}

bool MainWindow::saveAs()
{
    takeTypedValue();
    QString start = document_.path();
    if (start.isEmpty()) {
        const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        start = QDir(folder).filePath(document_.fabric() ? QString::fromStdString(document_.fabric()->name) + ".hygro" : "project.hygro");
    }
    const QString path = QFileDialog::getSaveFileName(this, tr("Save Project"), start, tr("Projects (*.hygro)"));
    if (path.isEmpty() || !document_.saveAs(withEnding(path, ".hygro"))) { return false; }
    addRecentFile(document_.path());
    statusBar()->showMessage(tr("Saved %1.").arg(document_.path()), 4000);
    return true;
}

void MainWindow::saveRecordingAs()
{
    if (!playback_.run() || playback_.live()) { return; }
    if (copier_.busy()) {
        tellProblem(tr("Another recording is still being saved. Save this one when that is done."));
        return;
    }
    const QString folder = document_.path().isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                                      : QFileInfo(document_.path()).absolutePath();
    const QString name = QString::fromStdString(playback_.run()->fabric + ", " + playback_.run()->experiment) + ".hygrorec";
    const QString chosen =
        QFileDialog::getSaveFileName(this, tr("Save Recording"), QDir(folder).filePath(name), tr("Recordings (*.hygrorec)"));
    if (chosen.isEmpty()) { return; }
    const QString from = playback_.path(), to = withEnding(chosen, ".hygrorec");
    if (QFileInfo(from) == QFileInfo(to)) { return; }
    // Recordings may be large.
    copier_.run([this, from, to](const NewestJob::Turn& turn) {
        const QString why = copyOver(from, to);
        turn.deliver([this, from, to, why] {
            if (why.isEmpty()) {
                history_.markSaved(from);
                history_.forget(to); // what was there before
                addRecentFile(to);
                statusBar()->showMessage(tr("Saved %1.").arg(to), 4000);
            } else {
                tellProblem(tr("The recording cannot be written to %1: %2").arg(to, why));
            }
        });
    });
}

void MainWindow::saveScreenshot()
{
    const QImage picture = viewport_->picture();
    if (picture.isNull()) {
        tellProblem(tr("This display cannot draw the fabric, so there is no picture to save."));
        return;
    }
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    const QString name = (document_.fabric() ? QString::fromStdString(document_.fabric()->name) : QString("fabric")) + ".png";
    const QString chosen = QFileDialog::getSaveFileName(this, tr("Save Picture"), QDir(folder).filePath(name), tr("Pictures (*.png)"));
    if (chosen.isEmpty()) { return; }
    const QString path = withEnding(chosen, ".png");
    QSaveFile file(path); // an older picture stays until this one is complete
    if (file.open(QIODevice::WriteOnly) && picture.save(&file, "PNG") && file.commit()) {
        statusBar()->showMessage(tr("Saved %1.").arg(path), 4000);
    } else {
        tellProblem(tr("The picture cannot be written to %1.").arg(path));
    }
}

void MainWindow::chooseDraft()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Import Draft"), QFileInfo(document_.path()).absolutePath(),
                                                      tr("Drafts, text grids and pictures (*.wif *.txt *.png *.bmp);;All files (*)"));
    if (!path.isEmpty()) { importDraft(path); }
}

bool MainWindow::importDraft(const QString& path)
{
    try {
        ImportDialog dialog(import_draft(path.toStdString(), *document_.design()), this);
        if (dialog.exec() != QDialog::Accepted) { return false; }
        candidates_->addFabric(tr("import of %1").arg(QFileInfo(path).fileName()), dialog.fabric());
    } catch (const Error& error) {
        tellProblem(QString::fromStdString(error.what()));
        return false;
    }
    setWorkspace(Workspace::design);
    return true;
}

void MainWindow::exportDraft()
{
    takeTypedValue();
    if (!document_.fabric()) { return; }
    if (document_.fabricHasError()) {
        tellProblem(tr("The fabric has an error, so its draft cannot be exported; the Issues panel says which."));
        return;
    }
    const QString folder = document_.path().isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                                      : QFileInfo(document_.path()).absolutePath();
    const QString name = QString::fromStdString(document_.fabric()->name) + ".wif";
    const QString chosen = QFileDialog::getSaveFileName(this, tr("Export Draft"), QDir(folder).filePath(name), tr("Drafts (*.wif)"));
    if (chosen.isEmpty()) { return; }
    const QString path = withEnding(chosen, ".wif");
    try {
        write_wif(*document_.design(), *document_.fabric(), path.toStdString());
        statusBar()->showMessage(tr("Saved %1.").arg(path), 4000);
    } catch (const Error& error) {
        tellProblem(QString::fromStdString(error.what()));
    }
}

void MainWindow::exportMesh()
{
    takeTypedValue();
    if (!export_) {
        export_ = new ExportDialog(document_, playback_, this);
        export_->setAttribute(Qt::WA_DeleteOnClose);
        connect(export_, &ExportDialog::written, this, [this](const QString& sentence) { statusBar()->showMessage(sentence, 4000); });
    }
    export_->show();
    export_->raise();
    export_->activateWindow();
}

bool MainWindow::mayDiscard()
{
    takeTypedValue();
    if (!document_.modified()) { return true; }
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), tr("Save the changes to “%1”?").arg(document_.title()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(tr("They are lost otherwise."));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

bool MainWindow::mayStop(const QString& what, const QString& question, const QString& consequence, const QString& button)
{
    QMessageBox box(QMessageBox::Question, what, question, QMessageBox::Cancel, this);
    box.setInformativeText(consequence);
    box.addButton(button, QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() != box.button(QMessageBox::Cancel);
}

bool MainWindow::mayStopRun()
{
    if (run_.running()) {
        if (!mayStop(tr("A run is in progress"), tr("Stop the run?"),
                     tr("What it has simulated so far stays only if you save the recording."), tr("Stop the Run"))) {
            return false;
        }
        run_.cancel();
    }
    return true;
}

/// Runs that took a while are not dropped without a question.
bool MainWindow::mayDropRuns()
{
    constexpr double a_while = 30; // s
    double longest = 0;
    for (const KeptRun& run : history_.unsaved()) { longest = std::max({longest, run.elapsed, run.run->wall}); }
    return longest < a_while ||
           mayStop(
               tr("Runs are not saved"), tr("Close without saving the recordings?"),
               tr("The longest run took %1 and is lost then. File ▸ Save Recording As keeps the run that is shown; Compare lists them all.")
                   .arg(roughDuration(longest)),
               tr("Close Without Saving"));
}

bool MainWindow::mayStopExport()
{
    if (export_ && export_->writing()) {
        if (!mayStop(tr("An export is in progress"), tr("Stop the export?"), tr("No file is written then."), tr("Stop the Export"))) {
            return false;
        }
        if (export_ && export_->writing()) { // it may have ended meanwhile
            export_->cancel();
            // Some formats are written in one go that takes seconds; until then the window is drawn, and nothing can be changed any more.
            QEventLoop end;
            connect(export_, &ExportDialog::ended, &end, &QEventLoop::quit);
            end.exec(QEventLoop::ExcludeUserInputEvents);
        }
    }
    return true;
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (closing_) {
        event->ignore();
        return;
    }
    const QScopedValueRollback asking(closing_, true);
    if (!mayDiscard() || !mayStopRun() || !mayDropRuns() || !mayStopExport()) {
        event->ignore();
        return;
    }
    if (export_) {
        export_->close(); // keeps its choice
    }
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    states_[static_cast<int>(workspace_)] = saveState(layout_version);
    settings.setValue("window/design", states_[0]);
    settings.setValue("window/simulate", states_[1]);
    settings.setValue("window/compare", states_[2]);
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!readablePath(event->mimeData()).isEmpty()) { event->acceptProposedAction(); }
}

void MainWindow::dropEvent(QDropEvent* event)
{
    if (const QString path = readablePath(event->mimeData()); !path.isEmpty()) {
        event->acceptProposedAction();
        openFile(path);
    }
}

void MainWindow::addRecentFile(const QString& path)
{
    QSettings settings;
    QStringList files = settings.value("recent").toStringList();
    files.removeAll(path);
    files.prepend(path);
    settings.setValue("recent", files.mid(0, most_recent_files));
    refreshRecentFiles();
}

void MainWindow::refreshRecentFiles()
{
    recent_->clear();
    const QStringList files = QSettings().value("recent").toStringList();
    for (const QString& path : files) {
        QAction* action = recent_->addAction(QFileInfo(path).fileName());
        action->setToolTip("<p>" + path.toHtmlEscaped() + "</p>");
        action->setStatusTip(path);
        connect(action, &QAction::triggered, this, [this, path] { openFile(path); });
    }
    if (!files.isEmpty()) {
        recent_->addSeparator();
        connect(recent_->addAction(tr("&Clear List")), &QAction::triggered, this, [this] {
            QSettings().remove("recent");
            refreshRecentFiles();
        });
    }
    recent_->setEnabled(!files.isEmpty());
}

} // namespace hygroloom
