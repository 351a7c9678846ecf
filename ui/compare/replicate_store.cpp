// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/replicate_store.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "ui/document/document.h"
#include "ui/document/run_folder.h"
#include "ui/results/project_runs.h"

#include <QDir>

namespace hygroloom {

ReplicateStore::ReplicateStore(Document& document, ProjectRuns& runs, QObject* parent) : QObject(parent), runs_(runs)
{
    connect(&document, &Document::pathChanged, this, &ReplicateStore::read); // also after another project was opened
    connect(&runs_, &ProjectRuns::following, this, &ReplicateStore::takeAlong);
}

void ReplicateStore::read()
{
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
    save({run}, runs_.folder());
    Q_EMIT changed();
}

void ReplicateStore::takeAlong(const QString& from)
{
    try {
        const std::vector<ReplicateSet> sets = read_replicates(replicatesIn(from).toStdString());
        for (const ReplicateSet& set : sets) { merge(sets_, set); }
        if (!sets.empty()) { save(sets, runs_.folder()); }
    } catch (const Error&) { // read() has said so
    }
    Q_EMIT changed();
}

/// Beside what another window wrote there meanwhile. A file that cannot be read stays as "replicates.json~".
void ReplicateStore::save(const std::vector<ReplicateSet>& sets, const QString& folder)
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
        write_file(path, format_replicates(all), previous);
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

} // namespace hygroloom
