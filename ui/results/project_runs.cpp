// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/project_runs.h"

#include "core/base/error.h"
#include "core/run/recording.h"
#include "core/run/recording_target.h"
#include "core/wear/worn_candidate.h"
#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/document/run_folder.h"
#include "ui/results/run_history.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

QString folderOf(const QString& recording) { return oneSpelling(QFileInfo(recording).absolutePath()); }

} // namespace

KeptRun listedRun(const QString& path)
{
    KeptRun kept{path, nullptr, nullptr};
    try {
        kept.worn = WearRecording::is_one(path.toStdString());
        if (kept.worn) {
            const WearRecording recording(path.toStdString());
            kept.run = runOfGarment(recording.record(), recording.wall());
        } else {
            kept.run = std::make_shared<const RunRecord>(Recording(path.toStdString()).run());
        }
    } catch (const std::exception& error) {
        RunRecord unknown;
        unknown.fabric = QFileInfo(path).completeBaseName().toStdString();
        unknown.experiment = ProjectRuns::tr("cannot be read").toStdString();
        kept.run = std::make_shared<const RunRecord>(std::move(unknown));
        kept.problem = QString::fromStdString(error.what());
    }
    kept.number = runNumber(path);
    kept.marked = isMarked(path);
    kept.own = true;
    return kept;
}

namespace {

/// Of all frames; nullptr when the job is outdated. Throws Error.
std::shared_ptr<const Metrics> readMetrics(const QString& path, const NewestJob::Turn& turn)
{
    Recording recording(path.toStdString());
    MetricsCollector collector;
    collector.start(recording.run());
    recording.read_frames([&](const Frame& frame) {
        collector.add(frame);
        return !turn.outdated();
    });
    return turn.outdated() ? nullptr : std::make_shared<const Metrics>(collector.metrics());
}

/// The same of a garment's run.
std::shared_ptr<const Candidate> readNumbers(const QString& path, const NewestJob::Turn& turn)
{
    const WearRecording recording(path.toStdString());
    WearMetrics metrics(recording.record().layout);
    for (int k = 0; k < recording.frames() && !turn.outdated(); ++k) { metrics.add(recording.frame(k)); }
    return turn.outdated() ? nullptr : std::make_shared<const Candidate>(candidate_of(recording.record(), metrics, recording.wall()));
}

bool isBeingWritten(const QString& recording)
{
    try {
        const std::string path = recording.toStdString();
        return WearRecording::is_one(path) ? WearRecording(path).is_being_written() : Recording(path).is_being_written();
    } catch (const std::exception&) { // none, or a damaged one
        return false;
    }
}

} // namespace

void makeOneFile(const QString& recording) { bring_in_left_over(recording.toStdString()); }

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
        live_ << reserveRun(folder());
    } catch (const Error& error) {
        if (folder() == recovery_.runFolder()) { throw; }
        live_ << reserveRun(recovery_.runFolder());
        Q_EMIT messageShown(QString::fromStdString(error.what()), 10000);
    }
    recovery_.follow();
    return live_.back();
}

QString ProjectRuns::settle(const QString& recording)
{
    live_.removeAll(recording);
    QString at = recording;
    releaseRun(recording);
    if (!QFileInfo::exists(recording)) {
        at.clear();
    } else if (folderOf(recording) != folder()) { // the project was saved elsewhere meanwhile
        const auto follow = connect(this, &ProjectRuns::moved, this, [&](const QString& from, const QString& to) {
            if (from == recording) { at = to; }
        });
        bring({recording});
        disconnect(follow);
    } else {
        history_.move(recording, recording, isFiled(recording));
    }
    recovery_.follow();
    if (!at.isEmpty()) { Q_EMIT grown(); }
    return at;
}

QStringList ProjectRuns::beyond(double bytes) const
{
    QStringList recordings = recordingsIn(folder()); // by number
    for (const QString& live : live_) { recordings.removeAll(live); }
    double all = 0;
    for (const QString& path : recordings) { all += static_cast<double>(QFileInfo(path).size()); }
    if (!recordings.isEmpty()) { recordings.removeLast(); } // what was just computed stays
    QStringList oldest;
    for (const QString& path : recordings) {
        if (all <= bytes) { break; }
        if (isMarked(path) || isWaiting(path)) { continue; }
        all -= static_cast<double>(QFileInfo(path).size());
        oldest << path;
    }
    return oldest;
}

bool ProjectRuns::owns(const QString& recording) const
{
    return isFiled(recording) || folderOf(recording) == recovery_.runFolder() || isWaiting(recording);
}

bool ProjectRuns::isFiled(const QString& recording) const
{
    return !document_.path().isEmpty() && folderOf(recording) == runFolderOf(document_.path());
}

/// All beside unsaved work but what settle() takes to the project.
QStringList ProjectRuns::unsaved() const
{
    QStringList found = recordingsIn(recovery_.runFolder());
    for (const QString& live : live_) { found.removeAll(live); }
    if (folder() == recovery_.runFolder()) { found << live_; }
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
    for (const QString& live : live_) { recordings.removeAll(live); } // settle() takes them
    Q_EMIT following(before);
    bring(recordings);
    read();
}

void ProjectRuns::takeFrom(const QString& folder)
{
    Q_EMIT following(folder);
    bring(recordingsIn(folder));
    read();
}

void ProjectRuns::bring(const QStringList& recordings)
{
    QStringList problems;
    const bool idle = waiting_.empty();
    for (const QString& from : recordings) {
        const bool is_unsaved = folderOf(folderOf(from)) == folderOf(recovery_.runFolder()); // this window's, or recovered
        const Waiting one{from, folder(), is_unsaved ? Bring::move : Bring::copy};
        try {
            makeOneFile(one.from);
            if (const QString to = linkRun(one.from, one.folder, one.how); !to.isEmpty()) {
                takeMoved(from, to);
            } else {
                waiting_.push_back(one);
            }
        } catch (const Error& error) {
            problems << QString::fromStdString(error.what());
        }
    }
    if (idle && !waiting_.empty()) { copyNext(); }
    recovery_.follow();
    if (!problems.isEmpty()) { Q_EMIT failed(problems.join('\n')); }
}

void ProjectRuns::copyNext()
{
    copier_.run([this, next = waiting_.front()](const NewestJob::Turn& turn) {
        QString to, why;
        try {
            int said = -1;
            to = bringRun(next.from, next.folder, next.how, [&](double share) {
                if (const int percent = static_cast<int>(100 * share); std::exchange(said, percent) != percent) {
                    turn.deliver([this, share] { Q_EMIT copied(share); });
                }
                return !turn.outdated();
            });
        } catch (const std::exception& error) {
            why = QString::fromStdString(error.what());
        }
        turn.deliver([this, from = next.from, to, why] {
            waiting_.erase(waiting_.begin());
            if (!to.isEmpty()) { takeMoved(from, to); }
            if (!why.isEmpty()) { Q_EMIT failed(why); }
            if (!waiting_.empty()) { return copyNext(); }
            recovery_.follow();
            Q_EMIT copiesEnded();
        });
    });
}

void ProjectRuns::takeMoved(const QString& from, const QString& to)
{
    history_.move(from, to, isFiled(to));
    Q_EMIT moved(from, to);
    const KeptRun* run = history_.find(to);
    if (run && run->marked != isMarked(to)) { setMarked(to, run->marked); } // it was marked while it was copied
}

bool ProjectRuns::isWaiting(const QString& recording) const
{
    return std::any_of(waiting_.begin(), waiting_.end(), [&recording](const Waiting& each) { return each.from == recording; });
}

/// In the background, those that are not known yet as runs of the project.
void ProjectRuns::read()
{
    for (const KeptRun& run : std::vector(history_.runs())) { // opened alone before its project
        if (!run.own && owns(run.path)) { history_.forget(run.path); }
    }
    QStringList paths = recordingsIn(known_);
    if (known_ != recovery_.runFolder()) { paths << recordingsIn(recovery_.runFolder()); }
    paths.removeIf([this](const QString& path) { return live_.contains(path) || isWaiting(path) || history_.find(path); });
    if (paths.isEmpty()) {
        loader_.drop();
        history_.setListing(false);
        return readNumbers();
    }
    history_.setListing(true);
    loader_.run([this, paths](const NewestJob::Turn& turn) {
        const auto end = [&] {
            turn.deliver([this, turn] {
                if (turn.outdated()) { return; } // another project's runs are being read
                history_.setListing(false);
                readNumbers();
            });
        };
        try {
            for (const QString& path : paths) {
                const KeptRun kept = listedRun(path);
                if (turn.outdated()) { return; }
                turn.deliver([this, kept] { add(kept); });
            }
        } catch (...) {
            end();
            throw;
        }
        end();
    });
}

void ProjectRuns::add(KeptRun run)
{
    if (!owns(run.path) || !QFileInfo::exists(run.path) || history_.find(run.path)) { return; }
    run.saved = isFiled(run.path);
    history_.keep(run);
    if (!run.problem.isEmpty()) {
        Q_EMIT messageShown((run.worn ? tr("%1 cannot be read; Runs lists why.") : tr("%1 cannot be read; Compare lists why."))
                                .arg(QFileInfo(run.path).fileName()),
                            10000);
    }
}

void ProjectRuns::setCompared(bool compared)
{
    if (std::exchange(compared_, compared) == compared) { return; }
    numbers_.drop();
    readNumbers();
}

/// In the background, of the project's completed runs that have none yet, the newest first.
void ProjectRuns::readNumbers()
{
    QStringList paths;
    for (const KeptRun& run : history_.runs()) {
        if (run.own && run.problem.isEmpty() && run.complete() && !run.measured()) { paths.prepend(run.path); }
    }
    if (!compared_ || paths.isEmpty()) { return; }
    numbers_.run([this, paths](const NewestJob::Turn& turn) {
        QStringList problems;
        for (const QString& path : paths) {
            try {
                if (WearRecording::is_one(path.toStdString())) {
                    const auto numbers = hygroloom::readNumbers(path, turn);
                    if (!numbers) { return; }
                    turn.deliver([this, path, numbers] { history_.setNumbers(path, numbers); });
                } else {
                    const auto metrics = readMetrics(path, turn);
                    if (!metrics) { return; }
                    turn.deliver([this, path, metrics] { history_.setMetrics(path, metrics); });
                }
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
        if (isWaiting(recording)) {
            throw Error(tr("%1 is not deleted: it is being copied. Wait until that is done.").arg(recording).toStdString());
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
