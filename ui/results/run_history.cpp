// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/run_history.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <iterator>

namespace hygroloom {

namespace {

/// An experiment and its liquid, whatever it is called.
Design conditionsOf(const RunRecord& run)
{
    Design part;
    if (const Experiment* experiment = find_experiment(run.design, run.experiment)) {
        part.experiments.push_back(*experiment);
        part.experiments.front().name = "experiment";
        if (const Liquid* liquid = find_liquid(run.design, experiment->liquid)) { part.liquids.push_back(*liquid); }
    }
    return part;
}

} // namespace

RunHistory::RunHistory(QObject* parent) : QObject(parent) {}

void RunHistory::keep(const KeptRun& run)
{
    const auto same = std::find_if(runs_.begin(), runs_.end(), [&run](const KeptRun& known) { return known.path == run.path; });
    if (same == runs_.end()) {
        runs_.push_back(run);
        runs_.back().number = ++count_;
    } else {
        const KeptRun known = *same;
        *same = run;
        same->saved = known.saved || run.saved;
        same->elapsed = std::max(known.elapsed, run.elapsed);
        same->number = known.number;
    }
    Q_EMIT changed();
}

void RunHistory::markSaved(const QString& path)
{
    for (KeptRun& run : runs_) { run.saved = run.saved || run.path == path; }
    Q_EMIT changed();
}

void RunHistory::forget(const QString& path)
{
    const auto gone =
        std::remove_if(runs_.begin(), runs_.end(), [&path](const KeptRun& run) { return QFileInfo(run.path) == QFileInfo(path); });
    if (gone != runs_.end()) {
        runs_.erase(gone, runs_.end());
        Q_EMIT changed();
    }
}

/// end() where none may go.
std::vector<KeptRun>::iterator RunHistory::nextToDrop()
{
    if (runs_.empty()) { return runs_.end(); }
    const auto newest = std::prev(runs_.end());
    const auto spare = std::find_if(runs_.begin(), newest, [](const KeptRun& run) { return run.own && run.saved; });
    if (spare != newest) { return spare; }
    const auto oldest = std::find_if(runs_.begin(), newest, [](const KeptRun& run) { return run.own; });
    return oldest != newest ? oldest : runs_.end();
}

int RunHistory::dropOldest(double most_bytes)
{
    const auto bytes_of = [](const KeptRun& run) { return run.own ? static_cast<double>(QFileInfo(run.path).size()) : 0.0; };
    double bytes = 0;
    for (const KeptRun& run : runs_) { bytes += bytes_of(run); }
    int lost = 0;
    for (auto run = nextToDrop(); bytes > most_bytes && run != runs_.end(); run = nextToDrop()) {
        bytes -= bytes_of(*run);
        lost += run->saved ? 0 : 1;
        QFile::remove(run->path);
        runs_.erase(run);
    }
    Q_EMIT changed();
    return lost;
}

std::vector<KeptRun> RunHistory::unsaved() const
{
    std::vector<KeptRun> found;
    std::copy_if(runs_.begin(), runs_.end(), std::back_inserter(found), [](const KeptRun& run) { return !run.saved; });
    return found;
}

QString whyNotCompared(const KeptRun& one, const KeptRun& other)
{
    if (!one.complete() || !other.complete()) { return RunHistory::tr("Only completed runs can be compared."); }
    if (conditionsOf(*one.run) != conditionsOf(*other.run)) {
        return RunHistory::tr("This run is of another experiment. Only runs of the same experiment can be compared.");
    }
    return {};
}

} // namespace hygroloom
