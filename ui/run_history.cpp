// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/run_history.h"

#include "core/project/project_file.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace hygroloom {

namespace {

/// An experiment and its liquid, whatever it is called.
std::string conditionsOf(const RunRecord& run)
{
    Design part;
    if (const Experiment* experiment = find_experiment(run.design, run.experiment)) {
        part.experiments.push_back(*experiment);
        part.experiments.front().name = "experiment";
        if (const Liquid* liquid = find_liquid(run.design, experiment->liquid)) { part.liquids.push_back(*liquid); }
    }
    return format_project(part);
}

} // namespace

RunHistory::RunHistory(QObject* parent) : QObject(parent) {}

void RunHistory::keep(const KeptRun& run)
{
    const auto same = std::find_if(runs_.begin(), runs_.end(), [&run](const KeptRun& known) { return known.path == run.path; });
    if (same == runs_.end()) {
        runs_.push_back(run);
    } else {
        const bool saved = same->saved || run.saved;
        *same = run;
        same->saved = saved;
    }
    Q_EMIT changed();
}

void RunHistory::markSaved(const QString& path)
{
    for (KeptRun& run : runs_) { run.saved = run.saved || run.path == path; }
    Q_EMIT changed();
}

void RunHistory::dropOldest(double most_bytes)
{
    double bytes = 0;
    for (auto run = runs_.end(); run != runs_.begin();) {
        --run;
        if (run->saved) { continue; }
        bytes += static_cast<double>(QFileInfo(run->path).size());
        if (bytes > most_bytes) {
            QFile::remove(run->path);
            run = runs_.erase(run);
        }
    }
    Q_EMIT changed();
}

std::vector<KeptRun> RunHistory::unsaved() const
{
    std::vector<KeptRun> found;
    std::copy_if(runs_.begin(), runs_.end(), std::back_inserter(found), [](const KeptRun& run) { return !run.saved; });
    return found;
}

QString whyNotCompared(const KeptRun& one, const KeptRun& other)
{
    if (!one.complete() || !other.complete()) { return RunHistory::tr("Only runs that got to their end can be compared."); }
    if (conditionsOf(*one.run) != conditionsOf(*other.run)) {
        return RunHistory::tr("It is of another experiment; only runs of the same one can be compared.");
    }
    return {};
}

} // namespace hygroloom
