// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/replicate_store.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "ui/document/document.h"
#include "ui/document/run_folder.h"
#include "ui/results/project_runs.h"

#include <QDir>

#include <utility>

namespace hygroloom {

namespace {

/// Beside what another window wrote there meanwhile; what belongs to nothing in the design goes. A file that cannot be read stays as
/// "replicates.json~". Returns why it failed, in a sentence; empty: it did not.
QString writeSets(const std::vector<ReplicateSet>& sets, const Design& design, const QString& folder)
{
    const std::string path = replicatesIn(folder).toStdString();
    try {
        QDir().mkpath(folder);
        const ChangeLock alone(path);
        std::vector<ReplicateSet> all;
        Previous previous = Previous::replace;
        try {
            all = read_replicates(path);
        } catch (const FileError&) {
            previous = Previous::keep_as_backup;
        }
        for (const ReplicateSet& set : sets) { merge(all, set); }
        write_file(path, format_replicates(without_leftovers(std::move(all), design)), previous);
    } catch (const Error& error) {
        return QString::fromStdString(error.what());
    }
    return {};
}

} // namespace

ReplicateStore::ReplicateStore(Document& document, ProjectRuns& runs, QObject* parent) : QObject(parent), document_(document), runs_(runs)
{
    connect(&document, &Document::pathChanged, this, &ReplicateStore::read); // also after another project was opened
    connect(&runs_, &ProjectRuns::following, this, &ReplicateStore::takeAlong);
}

ReplicateStore::~ReplicateStore() { finishSaving(); }

void ReplicateStore::read()
{
    if (const QString why = finishSaving(); !why.isEmpty()) { Q_EMIT failed(why); }
    sets_.clear();
    try {
        sets_ = read_replicates(replicatesIn(runs_.folder()).toStdString());
    } catch (const Error& error) {
        Q_EMIT failed(tr("The numbers of earlier replicates cannot be read: %1").arg(QString::fromStdString(error.what())));
    }
    Q_EMIT changed();
}

void ReplicateStore::add(const ReplicateSet& run)
{
    merge(sets_, run);
    drop_older_traces(sets_);
    save();
    Q_EMIT changed();
}

void ReplicateStore::takeAlong(const QString& from)
{
    if (const QString why = finishSaving(); !why.isEmpty()) { Q_EMIT failed(why); }
    try {
        const std::vector<ReplicateSet> sets = read_replicates(replicatesIn(from).toStdString());
        for (const ReplicateSet& set : sets) { merge(sets_, set); }
        if (!sets.empty()) { save(); }
    } catch (const Error&) { // read() has said so
    }
    Q_EMIT changed();
}

void ReplicateStore::save()
{
    unsaved_in_ = runs_.folder();
    unsaved_for_ = document_.design();
    writer_.run([this, sets = sets_, design = unsaved_for_, folder = unsaved_in_, own = ++saves_](const NewestJob::Turn& turn) {
        const QString why = writeSets(sets, *design, folder);
        turn.deliver([this, why, own] {
            if (own == saves_) { unsaved_in_.clear(); }
            if (!why.isEmpty()) { Q_EMIT failed(why); }
        });
    });
}

QString ReplicateStore::finishSaving()
{
    if (unsaved_in_.isEmpty()) { return {}; }
    writer_.drop();
    ++saves_;
    return writeSets(sets_, *unsaved_for_, std::exchange(unsaved_in_, QString()));
}

} // namespace hygroloom
