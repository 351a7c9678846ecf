// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Recordings that are opened, listed and saved elsewhere, and reports.
#include "core/base/error.h"
#include "ui/document/run_folder.h"
#include "ui/document/sources.h"
#include "ui/results/project_runs.h"
#include "ui/results/report_file.h"
#include "ui/window/command.h"
#include "ui/window/file_names.h"
#include "ui/window/run_workspace.h"

#include <QDir>
#include <QFileDialog>
#include <QMainWindow>
#include <QScopedValueRollback>

#include <algorithm>

namespace hygroloom {

void RunWorkspace::fillFileMenu(QMenu* menu)
{
    actions_.save_recording = addCommand(menu, {}, tr("Save Re&cording As…"), {}, tr("Save the run that is shown."));
    connect(actions_.save_recording, &QAction::triggered, this, [this] { askToSaveRecording(current().shown().path()); });
    actions_.save_report = addCommand(menu, {}, tr("Save Repor&t…"), {},
                                      tr("Save the results of the run that is shown, with maps and charts, as PDF or web page."));
    connect(actions_.save_report, &QAction::triggered, this, &RunWorkspace::saveReport);
    sample_.fillFileMenu(menu);
}

void RunWorkspace::clearResults()
{
    if (run_.running() || taking_) { return; }
    sample_.playback().clear();
    garment_.playback().clear();
}

Subject RunWorkspace::subjectOf(const QString& recording) const
{
    const KeptRun* kept = history_.find(recording);
    const bool worn = kept && kept->problem.isEmpty() ? kept->worn : isGarmentRecording(recording);
    return worn ? Subject::garment : Subject::sample;
}

/// Asks where what is on screen of the subject is being computed.
bool RunWorkspace::mayReplace(const RunSubject& subject)
{
    if (&subject != running_) { return true; }
    if (!agreesToStopRun()) { return false; }
    stopRun();
    return true;
}

bool RunWorkspace::openRecording(const QString& path)
{
    RunSubject& subject = of(subjectOf(path));
    if (!mayReplace(subject)) { return false; }
    const QFileInfo info(path);
    opening_ = QDir(oneSpelling(info.absolutePath())).filePath(info.fileName());
    subject.shown().open(opening_);
    return true;
}

void RunWorkspace::showEarlierRun(const QString& recording)
{
    RunSubject& subject = of(subjectOf(recording));
    if (!mayReplace(subject)) { return; }
    opening_.clear();
    subject.shown().open(recording);
}

/// A project with changes or runs stays: nobody asked to close it.
bool RunWorkspace::mayTakeDesign() const
{
    const auto& runs = history_.runs();
    return !document_.modified() && !runs_.recording() &&
           std::none_of(runs.begin(), runs.end(), [](const KeptRun& run) { return run.own; });
}

void RunWorkspace::takeOpened(Subject subject, const QString& path)
{
    if (!runs_.owns(path)) { Q_EMIT recordingUsed(path); }
    const bool takes = path == opening_ && mayTakeDesign();
    Q_EMIT wanted(subject);
    if (takes) {
        takeDesignOf(of(subject));
    } else if (path != opening_) {
        of(subject).chooseWhatRan();
    }
}

void RunWorkspace::takeDesignOf(RunSubject& subject)
{
    if (!subject.shown().design()) { return; }
    const QScopedValueRollback taking(taking_, true);
    document_.take(subject.recordedDesign(), tr("Design of %1").arg(QFileInfo(subject.shown().path()).fileName()));
    subject.chooseWhatRan();
}

/// Adds the run on screen to the history once it is complete.
void RunWorkspace::keepRun(RunSubject& subject)
{
    std::optional<KeptRun> kept = subject.listed();
    if (!kept || !QFileInfo::exists(kept->path)) { return; }
    kept->own = runs_.owns(kept->path);
    kept->saved = !kept->own || runs_.isFiled(kept->path);
    kept->number = kept->own ? runNumber(kept->path) : 0;
    history_.keep(*kept);
}

void RunWorkspace::askToSaveRecording(const QString& from)
{
    if (copier_.busy()) {
        Q_EMIT problemFound(tr("Another recording is still being saved. Save this one when that is done."));
        return;
    }
    const KeptRun* kept = history_.find(from);
    const QString name = kept ? QString::fromStdString(kept->run->fabric + ", " + kept->run->experiment) : QFileInfo(from).baseName();
    const QString chosen = QFileDialog::getSaveFileName(
        &window_, tr("Save Recording"), QDir(folderOf(document_)).filePath(name + ".hygrorec"), tr("Recordings (*.hygrorec)"));
    if (!chosen.isEmpty()) { saveRecording(from, withEnding(chosen, ".hygrorec")); }
}

/// In the background: recordings may be large.
void RunWorkspace::saveRecording(const QString& from, const QString& to)
{
    if (QFileInfo(from) == QFileInfo(to)) { return; }
    const KeptRun* kept = history_.find(from);
    copier_.run([this, from, to, run = kept && kept->worn ? kept->run : nullptr](const NewestJob::Turn& turn) {
        QString why;
        QStringList left;
        try {
            makeOneFile(from);
            copyRecording(from, to, [&](double share) {
                const int percent = static_cast<int>(100 * share);
                turn.deliver([this, to, percent] { Q_EMIT messageShown(tr("Saving %1: %2 %").arg(to).arg(percent), 4000); });
                return !turn.outdated();
            });
            if (run) { left = copySources(run->design, folderOfSources(run->design, from), QFileInfo(to).absolutePath()); }
        } catch (const std::exception& error) {
            why = QString::fromStdString(error.what());
        }
        turn.deliver([this, from, to, why, left] {
            if (!left.isEmpty()) {
                Q_EMIT problemFound(tr("%1 is saved. Files of its garment could not be copied beside it: %2. Its design needs them there.")
                                        .arg(to, left.join(", ")));
            }
            if (why.isEmpty()) {
                history_.markCopied(from, to);
                history_.forget(to); // an older recording at that place
                Q_EMIT recordingUsed(to);
                Q_EMIT messageShown(tr("Saved %1.").arg(to), 4000);
            } else {
                Q_EMIT problemFound(tr("The recording cannot be written to %1: %2").arg(to, why));
            }
        });
    });
}

void RunWorkspace::saveReport()
{
    const QString file = askForReportFile(&window_, folderOf(document_), current().shown().title());
    if (!file.isEmpty()) { current().saveReport(file); }
}

} // namespace hygroloom
