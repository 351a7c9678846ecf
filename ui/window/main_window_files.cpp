// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Opening, saving, recent files, dropped files, closing.
#include "core/base/error.h"
#include "ui/basics/ask.h"
#include "ui/basics/language.h"
#include "ui/basics/typed_value.h"
#include "ui/compare/compare_view.h"
#include "ui/document/run_folder.h"
#include "ui/export/card_dialog.h"
#include "ui/export/export_dialog.h"
#include "ui/garment/garment_view.h"
#include "ui/lesson/lesson_window.h"
#include "ui/panels/candidates_panel.h"
#include "ui/panels/experiment_panel.h"
#include "ui/study/study_page.h"
#include "ui/weave/import_dialog.h"
#include "ui/window/design_workspace.h"
#include "ui/window/examples.h"
#include "ui/window/file_names.h"
#include "ui/window/main_window.h"
#include "ui/window/recent_files.h"
#include "ui/window/run_film.h"

#include <QCloseEvent>
#include <QDir>
#include <QDragEnterEvent>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QProgressDialog>
#include <QSaveFile>
#include <QScopedValueRollback>
#include <QSettings>

namespace hygroloom {

namespace {

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

} // namespace

bool MainWindow::openFile(const QString& path)
{
    if (isDraft(path)) { return importDraft(path); }
    if (isRecording(path)) { return run_->openRecording(path); }
    const bool example = isInstalled(path);
    if (!mayLeave() || !(example ? document_.openExample(path) : document_.open(path))) {
        compare_->project().stay();
        return false;
    }
    recent_->add(example ? QFileInfo(path).absoluteFilePath() : document_.path());
    return true;
}

void MainWindow::openShippedExample()
{
    if (const QString path = shippedExample(); !path.isEmpty()) { document_.openExample(path); }
}

void MainWindow::openExample(const QString& path)
{
    if (mayLeave()) { document_.openExample(path); }
}

bool MainWindow::offerLeftOver()
{
    bool opened = false;
    for (const LeftOver& left : recovery_.leftOver()) { opened = offer(left) || opened; }
    return opened;
}

bool MainWindow::offer(const LeftOver& left)
{
    const QString name = left.title.isEmpty() ? tr("Untitled") : left.title;
    const QString when = tr("Last changed on %1.").arg(shortMoment(left.when));
    const QString later =
        tr("The file %1 was changed since. The recovered copy opens separately and asks for a name when you save it.").arg(left.path);
    const auto runs = recordingsIn(left.runs).size();
    const QString with = runs == 0 ? QString() : runs == 1 ? tr("1 run belongs to it.") : tr("%1 runs belong to it.").arg(runs);
    const Reply answer = ask(this, {tr("Unsaved work found"),
                                    tr("Hygroloom ended before “%1” was saved. Open the recovered copy?").arg(name),
                                    QStringList{when, left.outdated ? later : QString(), with}.join(' ').simplified(),
                                    {{Reply::act, tr("&Open")}, {Reply::lose, tr("&Discard")}, {Reply::cancel, tr("&Ask Again Later")}},
                                    Reply::act});
    const bool opened = answer == Reply::act && mayLeave() && recovery_.open(left);
    if (opened) {
        compare_->project().takeFrom(left.runs);
    } else if (answer == Reply::lose) {
        Recovery::discard(left);
    }
    compare_->project().stay();
    return opened;
}

/// Without a fabric as yet.
bool MainWindow::takeNewProject()
{
    if (!mayLeave()) { return false; }
    Design design;
    design.experiments.push_back(freshExperiment(ExperimentType::droplet));
    design.experiments.front().name = tr("one drop").toStdString();
    document_.take(design, {});
    return true;
}

void MainWindow::newProject()
{
    if (!takeNewProject()) { return; }
    design_->candidates().addFabric();
    document_.history()->clear();
}

void MainWindow::newProjectOf(int preset)
{
    if (!takeNewProject()) { return; }
    design_->candidates().addShipped(preset);
    document_.history()->clear();
}

void MainWindow::chooseFile()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Open"), QFileInfo(document_.path()).absolutePath(),
                                                      tr("Projects and recordings (*.hygro *.hygrorec);;All files (*)"));
    if (!path.isEmpty()) { openFile(path); }
}

bool MainWindow::save()
{
    commitTypedValue(*this);
    if (document_.path().isEmpty()) { return saveAs(); }
    const Reply answer = document_.changedOnDisk() ? askAboutChangedFile() : Reply::act;
    if (answer == Reply::lose) { document_.open(document_.path()); } // and nothing is saved
    return answer == Reply::save ? saveAs() : answer == Reply::act && document_.save();
}

Reply MainWindow::askAboutChangedFile()
{
    const QString name = QFileInfo(document_.path()).fileName();
    return ask(this, {tr("The file was changed"),
                      tr("Replace %1, which another program changed after it was opened here?").arg(name),
                      tr("The other program's version is then in %1~, until the project is saved again. Opening it loses what was "
                         "changed here.")
                          .arg(name),
                      {{Reply::act, tr("&Replace the File")},
                       {Reply::lose, tr("&Open the Other Version")},
                       {Reply::save, tr("Save &As…")},
                       {Reply::cancel, tr("Cancel")}},
                      Reply::save});
}

bool MainWindow::saveAs()
{
    commitTypedValue(*this);
    QString start = document_.path();
    if (start.isEmpty()) {
        const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        const QString name = document_.fabric() ? QString::fromStdString(document_.fabric()->name).replace('/', '-') : "project";
        start = QDir(folder).filePath(name + ".hygro");
    }
    const QString path = QFileDialog::getSaveFileName(this, tr("Save Project"), start, tr("Projects (*.hygro)"));
    if (path.isEmpty() || !copiesAreDone() || !document_.saveAs(withEnding(path, ".hygro"))) { return false; }
    recent_->add(document_.path());
    showMessage(tr("Saved %1.").arg(document_.path()));
    return true;
}

void MainWindow::saveScreenshot()
{
    const bool compares = workspace_ == Workspace::compare, worn = workspace_ == Workspace::garment,
               studies = workspace_ == Workspace::study;
    const QImage picture = studies    ? study_->picture()
                           : compares ? compare_->view().picture()
                           : worn     ? run_->garment().view().picture()
                                      : viewport_->picture();
    if (picture.isNull()) {
        showProblem(worn       ? tr("There is no garment to save a picture of. Add one.")
                    : compares ? tr("No runs are compared, so there is no picture to save. Tick the runs in the list.")
                               : tr("This display cannot draw the fabric, so there is no picture to save."));
        return;
    }
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    const QString fabric = document_.fabric() ? QString::fromStdString(document_.fabric()->name) : QString("fabric");
    const QString name = (studies ? tr("study") : compares ? tr("comparison") : worn ? tr("garment") : fabric) + ".png";
    const QString chosen = QFileDialog::getSaveFileName(this, tr("Save Picture"), QDir(folder).filePath(name), tr("Pictures (*.png)"));
    if (chosen.isEmpty()) { return; }
    const QString path = withEnding(chosen, ".png");
    QSaveFile file(path); // an older picture stays until this one is complete
    if (file.open(QIODevice::WriteOnly) && picture.save(&file, "PNG") && file.commit()) {
        showMessage(tr("Saved %1.").arg(path));
    } else {
        showProblem(tr("The picture cannot be written to %1.").arg(path));
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
        design_->candidates().addFabric(tr("import of %1").arg(QFileInfo(path).fileName()), dialog.fabric());
    } catch (const Error& error) {
        showProblem(QString::fromStdString(error.what()));
        return false;
    }
    setWorkspace(Workspace::design);
    return true;
}

void MainWindow::exportDraft()
{
    commitTypedValue(*this);
    if (!document_.fabric()) { return; }
    if (document_.fabricHasError()) {
        showProblem(tr("This fabric has an error and its draft cannot be exported. See the Issues panel."));
        return;
    }
    const QString name = QString::fromStdString(document_.fabric()->name) + ".wif";
    const QString chosen =
        QFileDialog::getSaveFileName(this, tr("Export Draft"), QDir(folderOf(document_)).filePath(name), tr("Drafts (*.wif)"));
    if (chosen.isEmpty()) { return; }
    const QString path = withEnding(chosen, ".wif");
    try {
        write_wif(*document_.design(), *document_.fabric(), path.toStdString());
        showMessage(tr("Saved %1.").arg(path));
    } catch (const Error& error) {
        showProblem(QString::fromStdString(error.what()));
    }
}

void MainWindow::exportMesh()
{
    commitTypedValue(*this);
    if (!export_) {
        export_ = new ExportDialog(document_, run_->sample().playback(), this);
        export_->setAttribute(Qt::WA_DeleteOnClose);
        connect(export_, &ExportDialog::written, this, [this](const QString& sentence) { showMessage(sentence); });
    }
    export_->show();
    export_->raise();
    export_->activateWindow();
}

bool MainWindow::mayLeave()
{
    if (!agreesToLeave()) { return false; }
    run_->stopRun();
    compare_->stopRuns();
    study_->stopRun();
    card_->numbers().cancel();
    return copiesAreDone();
}

/// Nothing is stopped before every question is answered.
bool MainWindow::agreesToLeave()
{
    compare_->project().stay();
    return copiesAreDone() && run_->agreesToStopRun() && compare_->agreesToStopRuns(this) && study_->agreesToLeave() &&
           card_->agreesToStopTests(this) && mayDiscard() && mayDropRuns();
}

/// Runs of a project that has a file stay with it.
bool MainWindow::mayDropRuns()
{
    const QStringList runs = compare_->project().unfiled();
    if (runs.isEmpty()) {
        compare_->project().agreeToLeave();
        return true;
    }
    constexpr int most = 6;
    QStringList names;
    for (const QString& path : runs.mid(0, most)) {
        const KeptRun* run = compare_->runs().find(path);
        names << (run ? runInWords(*run) : QFileInfo(path).fileName());
    }
    if (runs.size() > most) { names << tr("and %1 more").arg(runs.size() - most); }
    const Reply answer = ask(this, {tr("Runs are not saved"),
                                    tr("Save the project, so that its runs are kept beside it?"),
                                    tr("Otherwise these runs are deleted:") + "\n" + names.join('\n'),
                                    {{Reply::save, tr("&Save the Project")},
                                     {Reply::lose, runs.size() == 1 ? tr("&Delete the Run") : tr("&Delete the Runs")},
                                     {Reply::cancel, tr("Cancel")}},
                                    Reply::save});
    if (answer == Reply::save) {
        return (document_.path().isEmpty() ? save() : saveAs()) && copiesAreDone() && compare_->project().unfiled().isEmpty();
    }
    if (answer != Reply::lose) { return false; }
    compare_->project().agreeToLeave();
    return true;
}

bool MainWindow::copiesAreDone()
{
    ProjectRuns& runs = compare_->project();
    if (!runs.copying()) { return true; }
    QProgressDialog box(tr("Runs are being copied to the project."), tr("&Cancel"), 0, 1000, this);
    box.setWindowTitle(tr("Copying runs"));
    box.setWindowModality(Qt::WindowModal);
    box.setAutoReset(false);
    connect(&runs, &ProjectRuns::copied, &box, [&box](double share) { box.setValue(static_cast<int>(1000 * share)); });
    connect(&runs, &ProjectRuns::copiesEnded, &box, &QDialog::accept);
    box.exec();
    return !runs.copying();
}

bool MainWindow::mayDiscard()
{
    commitTypedValue(*this);
    if (!document_.modified()) { return true; }
    const Reply answer = ask(this, {tr("Unsaved changes"),
                                    tr("Save the changes to “%1”?").arg(document_.title()),
                                    tr("Otherwise they are lost."),
                                    {{Reply::save, tr("&Save")}, {Reply::lose, tr("&Discard the Changes")}, {Reply::cancel, tr("Cancel")}},
                                    Reply::save});
    return answer == Reply::lose || (answer == Reply::save && save());
}

bool MainWindow::agreesToStopExport()
{
    if (!export_ || !export_->writing()) { return true; }
    return confirm(this, tr("An export is in progress"), tr("Stop the export?"), tr("No file will be written."), tr("Stop the Export"));
}

void MainWindow::stopExport()
{
    if (!export_ || !export_->writing()) { return; } // it may have ended meanwhile
    export_->cancel();
    // Some formats are written in one call that takes seconds. Until it returns the window is drawn, but takes no input.
    QEventLoop end;
    connect(export_, &ExportDialog::ended, &end, &QEventLoop::quit);
    end.exec(QEventLoop::ExcludeUserInputEvents);
}

/// Of a run, or of a lesson: one at a time can be waited for by its dialog.
bool MainWindow::agreesToEndFilms()
{
    keeps_film_ = true;
    const bool of_lesson = lesson_ && lesson_->filming();
    if (!of_lesson && !findChild<RunFilm*>()) { return true; }
    const Question question{tr("A film is being written"),
                            tr("Finish the film before Hygroloom closes?"),
                            tr("Without that, what was filmed is lost."),
                            {{Reply::save, tr("&Finish the Film")}, {Reply::lose, tr("&Leave without It")}, {Reply::cancel, tr("Cancel")}},
                            Reply::save};
    const Reply answer = ask(of_lesson ? static_cast<QWidget*>(lesson_) : this, question);
    keeps_film_ = answer != Reply::lose;
    return answer == Reply::save || answer == Reply::lose;
}

/// What it waits for shows its progress, and can be cancelled.
void MainWindow::endFilms()
{
    for (RunFilm* film : findChildren<RunFilm*>()) { // they may have ended while questions were open
        if (keeps_film_) {
            QEventLoop end;
            connect(film, &QObject::destroyed, &end, &QEventLoop::quit);
            end.exec();
        } else {
            film->leave();
        }
    }
    if (lesson_) { lesson_->leaveFilm(keeps_film_); }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (closing_) {
        event->ignore();
        return;
    }
    const QScopedValueRollback asking(closing_, true);
    if (!agreesToLeave() || !agreesToStopExport() || !agreesToEndFilms()) {
        compare_->project().stay();
        event->ignore();
        return;
    }
    endFilms();
    stopExport();
    run_->stopRun();
    compare_->stopRuns();
    study_->stopRun();
    card_->numbers().cancel();
    if (!copiesAreDone()) {
        compare_->project().stay();
        event->ignore();
        return;
    }
    compare_->project().leave();
    if (export_) {
        export_->close(); // keeps its choice
    }
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    states_[stateOf(workspace_)] = saveState(layout_version);
    for (std::size_t i = 0; i < std::size(states_); ++i) { settings.setValue(stateName(i), states_[i]); }
    run_->garment().view().saveSteps(settings);
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

} // namespace hygroloom
