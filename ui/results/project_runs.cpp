// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/project_runs.h"

#include "core/base/error.h"
#include "core/run/recording.h"
#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/document/run_folder.h"
#include "ui/results/run_history.h"

#include <QFileInfo>

namespace hygroloom {

namespace {

QString folderOf(const QString& recording) { return QFileInfo(recording).absolutePath(); }

/// A recording's run with its numbers; without a run when the job is outdated. Throws Error.
KeptRun readRun(const QString& path, const NewestJob::Turn& turn)
{
    Recording recording(path.toStdString());
    KeptRun kept{path, std::make_shared<const RunRecord>(recording.run()), nullptr};
    MetricsCollector collector;
    collector.start(*kept.run);
    recording.read_frames([&](const Frame& frame) {
        collector.add(frame);
        return !turn.outdated();
    });
    kept.metrics = std::make_shared<const Metrics>(collector.metrics());
    if (turn.outdated()) { kept.run.reset(); }
    return kept;
}

bool isBeingWritten(const QString& recording)
{
    try {
        return Recording(recording.toStdString()).is_being_written();
    } catch (const FileError&) { // none, or a damaged one
        return false;
    }
}

} // namespace

ProjectRuns::ProjectRuns(Document& document, Recovery& recovery, RunHistory& history, QObject* parent)
    : QObject(parent), document_(document), recovery_(recovery), history_(history), known_(folder())
{
    connect(&document_, &Document::replaced, this, &ProjectRuns::openProject);
    connect(&document_, &Document::pathChanged, this, &ProjectRuns::followProject);
    connect(&document_, &Document::designChanged, this, [this] { history_.setDesign(document_.design()); });
}

QString ProjectRuns::folder() const { return document_.path().isEmpty() ? recovery_.runFolder() : runFolderOf(document_.path()); }

QString ProjectRuns::reserve()
{
    stay();
    try {
        live_ = reserveRun(folder());
    } catch (const Error& error) {
        if (folder() == recovery_.runFolder()) { throw; }
        live_ = reserveRun(recovery_.runFolder());
        Q_EMIT messageShown(QString::fromStdString(error.what()), 10000);
    }
    recovery_.follow();
    return live_;
}

QString ProjectRuns::settle(const QString& recording)
{
    live_.clear();
    QString at = recording;
    releaseRun(recording);
    if (!QFileInfo::exists(recording)) {
        at.clear();
    } else if (folderOf(recording) != folder()) { // the project was saved elsewhere meanwhile
        try {
            at = bringRun(recording, folder(), folderOf(recording) == recovery_.runFolder() ? Bring::move : Bring::copy);
            Q_EMIT moved(recording, at);
        } catch (const Error& error) {
            Q_EMIT failed(QString::fromStdString(error.what()));
        }
    }
    if (!at.isEmpty()) { history_.move(recording, at, isFiled(at)); }
    recovery_.follow();
    return at;
}

bool ProjectRuns::owns(const QString& recording) const { return isFiled(recording) || folderOf(recording) == recovery_.runFolder(); }

bool ProjectRuns::isFiled(const QString& recording) const
{
    return !document_.path().isEmpty() && folderOf(recording) == runFolderOf(document_.path());
}

/// All beside unsaved work but what settle() takes to the project.
QStringList ProjectRuns::unsaved() const
{
    QStringList found = recordingsIn(recovery_.runFolder());
    found.removeAll(live_);
    if (!live_.isEmpty() && folder() == recovery_.runFolder()) { found << live_; }
    return found;
}

QStringList ProjectRuns::unfiled() const
{
    QStringList found = unsaved();
    found.removeIf([this](const QString& path) {
        const KeptRun* run = history_.find(path);
        return run && isSaved(*run);
    });
    return found;
}

void ProjectRuns::agreeToLeave() { agreed_ = unsaved(); }

void ProjectRuns::leave()
{
    for (const QString& recording : std::exchange(agreed_, {})) { forget(recording); }
}

void ProjectRuns::openProject()
{
    leave();
    known_ = folder();
    history_.forgetOwn();
    read();
    recovery_.follow();
}

/// The project was saved elsewhere: its runs go along, and stay with what it was saved as before.
void ProjectRuns::followProject()
{
    const QString before = std::exchange(known_, folder());
    if (before == known_) { return; }
    QStringList recordings = recordingsIn(before);
    if (before != recovery_.runFolder()) { recordings << recordingsIn(recovery_.runFolder()); }
    recordings.removeAll(live_); // settle() takes it
    bring(recordings);
    read();
}

void ProjectRuns::takeFrom(const QString& folder)
{
    bring(recordingsIn(folder));
    read();
}

void ProjectRuns::bring(const QStringList& recordings)
{
    QStringList problems;
    for (const QString& from : recordings) {
        const bool moves = folderOf(folderOf(from)) == folderOf(recovery_.runFolder()); // it lies beside unsaved work
        try {
            const QString to = bringRun(from, known_, moves ? Bring::move : Bring::copy);
            history_.move(from, to, isFiled(to));
            Q_EMIT moved(from, to);
        } catch (const Error& error) {
            problems << QString::fromStdString(error.what());
        }
    }
    recovery_.follow();
    if (!problems.isEmpty()) { Q_EMIT failed(problems.join('\n')); }
}

/// In the background, those that are not known yet as runs of the project.
void ProjectRuns::read()
{
    for (const KeptRun& run : std::vector(history_.runs())) { // opened alone before its project
        if (!run.own && owns(run.path)) { history_.forget(run.path); }
    }
    QStringList paths = recordingsIn(known_);
    if (known_ != recovery_.runFolder()) { paths << recordingsIn(recovery_.runFolder()); }
    paths.removeIf([this](const QString& path) { return path == live_ || history_.find(path); });
    if (paths.isEmpty()) {
        loader_.drop();
        return;
    }
    loader_.run([this, paths](const NewestJob::Turn& turn) {
        QStringList problems;
        for (const QString& path : paths) {
            try {
                KeptRun kept = readRun(path, turn);
                if (turn.outdated()) { return; }
                kept.number = runNumber(path);
                kept.marked = isMarked(path);
                kept.own = true;
                turn.deliver([this, kept]() mutable {
                    if (!owns(kept.path) || !QFileInfo::exists(kept.path) || history_.find(kept.path)) { return; }
                    kept.saved = isFiled(kept.path);
                    history_.keep(kept);
                });
            } catch (const Error& error) {
                problems << QString::fromStdString(error.what());
            }
        }
        if (!problems.isEmpty()) {
            turn.deliver([this, problems] { Q_EMIT failed(tr("Runs of this project cannot be read.\n\n%1").arg(problems.join('\n'))); });
        }
    });
}

void ProjectRuns::forget(const QString& recording)
{
    try {
        const KeptRun* run = history_.find(recording);
        if (run && run->own && isAnotherNow(*run)) {
            throw Error(
                tr("%1 is not deleted: it is no longer the run that was listed. Open the project again.").arg(recording).toStdString());
        }
        if (owns(recording) && (!run || run->own)) {
            if (isBeingWritten(recording)) {
                throw Error(tr("%1 is not deleted: a run is writing it. Stop that run first.").arg(recording).toStdString());
            }
            deleteRun(recording);
        }
        history_.forget(recording);
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
    recovery_.follow();
}

void ProjectRuns::setMarked(const QString& recording, bool marked)
{
    try {
        hygroloom::setMarked(recording, marked);
        history_.setMarked(recording, marked);
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

} // namespace hygroloom
