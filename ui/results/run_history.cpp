// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/run_history.h"

#include "core/base/error.h"
#include "ui/basics/quantity.h"
#include "ui/document/run_folder.h"

#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace hygroloom {

namespace {

void lookAtFile(KeptRun& run)
{
    const QFileInfo info(run.path);
    run.bytes = static_cast<double>(info.size());
    run.written = info.lastModified();
}

/// One that cannot be read may be of any design: it is never among the older ones.
bool isCurrent(const KeptRun& run, const Design& design) { return !run.problem.isEmpty() || holdsFor(*run.run, design); }

std::string nameOf(const std::string& file) { return std::filesystem::path(file).filename().string(); }

Garment anywhere(Garment garment)
{
    garment.source = nameOf(garment.source);
    garment.wearer.zones = nameOf(garment.wearer.zones);
    return garment;
}

WearExperiment anywhere(WearExperiment wear)
{
    wear.activity_file = nameOf(wear.activity_file);
    return wear;
}

template <typename T> bool areEqual(const T* one, const T* other) { return one && other ? *one == *other : one == other; }

/// Of the fabric's yarns; what others are made of does not matter.
bool haveEqualFibres(const Design& one, const Design& other, const Fabric& fabric)
{
    const auto equal = [&](const Yarn& yarn) {
        const auto names = materials_in(yarn);
        return std::all_of(names.begin(), names.end(),
                           [&](const std::string& name) { return areEqual(find_material(one, name), find_material(other, name)); });
    };
    return equal(fabric.warp) && equal(fabric.weft) && std::all_of(fabric.extra_yarns.begin(), fabric.extra_yarns.end(), equal);
}

/// As in a comparison, where each garment is cut from one fabric.
Design cutFrom(Design design, const std::string& garment, const std::string& fabric)
{
    for (Garment& each : design.garments) {
        if (each.name == garment) { cut_all_from(each, fabric); }
    }
    return design;
}

QStringList differencesOfGarment(const Design& then, const std::string& garment, const std::string& experiment, const Design& now)
{
    QStringList words;
    const Garment *worn = find_garment(now, garment), *before = find_garment(then, garment);
    const WearExperiment *wear = find_wear(now, experiment), *wear_before = find_wear(then, experiment);
    if (!wear) {
        words << RunHistory::tr("experiment is gone");
    } else if (!wear_before || anywhere(*wear) != anywhere(*wear_before)) {
        words << RunHistory::tr("experiment");
    }
    if (wear && wear_before && !areEqual(find_liquid(now, wear->liquid), find_liquid(then, wear_before->liquid))) {
        words << RunHistory::tr("liquid");
    }
    if (!worn) {
        words << RunHistory::tr("garment is gone");
    } else if (!before || anywhere(*worn) != anywhere(*before)) {
        words << RunHistory::tr("garment");
    }
    bool gone = false, fabrics = false, fibres = false;
    for (const std::string& name : before ? fabrics_of(*before) : std::vector<std::string>()) {
        const Fabric *fabric = find_fabric(now, name), *was = find_fabric(then, name);
        gone = gone || (was && !fabric);
        fabrics = fabrics || (fabric && !areEqual(fabric, was));
        fibres = fibres || (fabric && !haveEqualFibres(now, then, *fabric));
    }
    if (gone) { words << RunHistory::tr("fabric is gone"); }
    if (fabrics) { words << RunHistory::tr("fabric"); }
    if (fibres) { words << RunHistory::tr("fibres"); }
    return words;
}

} // namespace

std::string KeptRun::cloth() const
{
    const Garment* garment = worn ? find_garment(run->design, run->fabric) : nullptr;
    return garment ? one_fabric_of(*garment) : worn ? std::string() : run->fabric;
}

RunHistory::RunHistory(QObject* parent) : QObject(parent), design_(std::make_shared<const Design>()) {}

const KeptRun* RunHistory::find(const QString& path) const
{
    const auto found = std::find_if(runs_.begin(), runs_.end(), [&path](const KeptRun& run) { return run.path == path; });
    return found == runs_.end() ? nullptr : &*found;
}

void RunHistory::keep(const KeptRun& run)
{
    KeptRun kept = run;
    if (const KeptRun* known = find(run.path)) {
        kept.number = known->number;
        kept.saved = known->saved || run.saved;
        kept.copy = known->copy;
        kept.marked = known->marked || run.marked;
        runs_.erase(runs_.begin() + (known - runs_.data()));
    }
    const bool taken = std::any_of(runs_.begin(), runs_.end(), [&kept](const KeptRun& other) { return other.number == kept.number; });
    if (kept.number <= 0 || taken) {
        kept.number = 1;
        for (const KeptRun& other : runs_) { kept.number = std::max(kept.number, other.number + 1); }
    }
    lookAtFile(kept);
    kept.current = isCurrent(kept, *design_);
    const auto after = std::find_if(runs_.begin(), runs_.end(), [&kept](const KeptRun& other) { return other.number > kept.number; });
    runs_.insert(after, kept);
    Q_EMIT changed();
}

void RunHistory::markCopied(const QString& path, const QString& copy)
{
    for (KeptRun& run : runs_) {
        if (run.path == path) {
            run.copy = copy;
        } else if (QFileInfo(run.copy) == QFileInfo(copy)) {
            run.copy.clear();
        }
    }
    Q_EMIT changed();
}

void RunHistory::setMarked(const QString& path, bool marked)
{
    for (KeptRun& run : runs_) {
        if (run.path == path) { run.marked = marked; }
    }
    Q_EMIT changed();
}

void RunHistory::setMetrics(const QString& path, const std::shared_ptr<const Metrics>& metrics)
{
    for (KeptRun& run : runs_) {
        if (run.path == path) { run.metrics = metrics; }
    }
    Q_EMIT changed();
}

void RunHistory::setNumbers(const QString& path, const std::shared_ptr<const Candidate>& numbers)
{
    for (KeptRun& run : runs_) {
        if (run.path == path) { run.numbers = numbers; }
    }
    Q_EMIT changed();
}

void RunHistory::move(const QString& from, const QString& to, bool saved)
{
    if (from != to) {
        std::erase_if(runs_, [&to](const KeptRun& run) { return run.path == to; });
    }
    for (KeptRun& run : runs_) {
        if (run.path != from) { continue; }
        run.path = to;
        run.saved = run.saved || saved;
        lookAtFile(run);
        if (run.own && runNumber(to) > 0) { renumber(run, runNumber(to)); }
    }
    std::stable_sort(runs_.begin(), runs_.end(), [](const KeptRun& a, const KeptRun& b) { return a.number < b.number; });
    Q_EMIT changed();
}

/// Who has the number gets the other's.
void RunHistory::renumber(KeptRun& run, int number)
{
    for (KeptRun& other : runs_) {
        if (&other != &run && other.number == number) { other.number = run.number; }
    }
    run.number = number;
}

void RunHistory::forget(const QString& path)
{
    if (std::erase_if(runs_, [&path](const KeptRun& run) { return QFileInfo(run.path) == QFileInfo(path); })) { Q_EMIT changed(); }
}

void RunHistory::forgetOwn()
{
    if (std::erase_if(runs_, [](const KeptRun& run) { return run.own; })) { Q_EMIT changed(); }
}

void RunHistory::setDesign(const std::shared_ptr<const Design>& design)
{
    const auto before = std::exchange(design_, design);
    const auto shows_otherwise = [&](const KeptRun& run) {
        return !run.current && differencesOf(*run.run, *before) != differencesOf(*run.run, *design_);
    };
    bool differs = false;
    for (KeptRun& run : runs_) {
        const bool was = std::exchange(run.current, isCurrent(run, *design_));
        differs = differs || was != run.current || shows_otherwise(run);
    }
    if (differs) { Q_EMIT changed(); }
}

void RunHistory::setListing(bool listing)
{
    if (std::exchange(listing_, listing) != listing) { Q_EMIT changed(); }
}

Design conditionsOf(const RunRecord& run)
{
    Design part;
    if (const Experiment* experiment = find_experiment(run.design, run.experiment)) {
        part.experiments.push_back(*experiment);
        part.experiments.front().name = "experiment";
        if (const Liquid* liquid = find_liquid(run.design, experiment->liquid)) { part.liquids.push_back(*liquid); }
    } else if (const WearExperiment* wear = find_wear(run.design, run.experiment)) {
        part.wears.push_back(*wear);
        part.wears.front().name = "experiment";
        if (const Liquid* liquid = find_liquid(run.design, wear->liquid)) { part.liquids.push_back(*liquid); }
        if (const Garment* garment = find_garment(run.design, wear->garment)) {
            part.garments.push_back(*garment);
            cut_all_from(part.garments.front(), {});
        }
    }
    return anywhere(part);
}

Design anywhere(Design design)
{
    for (Garment& garment : design.garments) { garment = anywhere(std::move(garment)); }
    for (WearExperiment& wear : design.wears) { wear = anywhere(std::move(wear)); }
    return design;
}

namespace {

QStringList differencesOfDesign(const RunRecord& run, const Design& design)
{
    QStringList words;
    if (find_wear(run.design, run.experiment)) {
        const Garment* worn = find_garment(run.design, run.fabric);
        const std::string cloth = worn ? one_fabric_of(*worn) : std::string();
        return cloth.empty() ? differencesOfGarment(run.design, run.fabric, run.experiment, design)
                             : differencesOfGarment(cutFrom(run.design, run.fabric, cloth), run.fabric, run.experiment,
                                                    cutFrom(design, run.fabric, cloth));
    }
    const Experiment *now = find_experiment(design, run.experiment), *then = find_experiment(run.design, run.experiment);
    if (!now) {
        words << RunHistory::tr("experiment is gone");
    } else if (!areEqual(now, then)) {
        Experiment alike = *now;
        if (then) { alike.sample_mm = then->sample_mm; }
        words << (areEqual<Experiment>(&alike, then) ? RunHistory::tr("sample") : RunHistory::tr("experiment"));
    }
    const auto liquids = [&](const Design& of) { return now ? find_liquid(of, now->liquid) : nullptr; };
    if (!areEqual(liquids(design), liquids(run.design))) { words << RunHistory::tr("liquid"); }
    const Fabric *fabric = find_fabric(design, run.fabric), *before = find_fabric(run.design, run.fabric);
    if (before && !fabric) {
        words << RunHistory::tr("fabric is gone");
    } else if (!areEqual(fabric, before)) {
        words << RunHistory::tr("fabric");
    }
    if (before && !haveEqualFibres(design, run.design, *before)) { words << RunHistory::tr("fibres"); }
    return words;
}

} // namespace

QStringList differencesOf(const RunRecord& run, const Design& design)
{
    QStringList words = differencesOfDesign(run, design);
    if (run.answers != answers_code) { words << RunHistory::tr("program"); }
    return words;
}

bool holdsFor(const RunRecord& run, const Design& design) { return differencesOf(run, design).isEmpty(); }

std::shared_ptr<const RunRecord> runOfGarment(const WearRecord& record, double wall)
{
    auto run = std::make_shared<RunRecord>();
    run->design = record.design;
    run->fabric = record.layout.garment;
    run->experiment = record.layout.experiment;
    try {
        run->plan.fidelity = fidelity_from_name(record.fidelity);
    } catch (const Error&) { // a recording of another version
    }
    run->backend = record.backend;
    run->device = record.device;
    run->date = record.date;
    run->answers = record.answers;
    run->wall = wall;
    return run;
}

bool garmentHoldsFor(const Design& then, const std::string& garment, const std::string& experiment, const Design& now)
{
    return find_garment(then, garment) && find_wear(then, experiment) && differencesOfGarment(then, garment, experiment, now).isEmpty();
}

bool isSaved(const KeptRun& run)
{
    return run.saved || (!run.copy.isEmpty() && QFileInfo::exists(run.copy) && QFileInfo(run.copy).size() == QFileInfo(run.path).size());
}

bool isAnotherNow(const KeptRun& run)
{
    KeptRun now = run;
    lookAtFile(now);
    return QFileInfo::exists(run.path) && (now.bytes != run.bytes || now.written != run.written);
}

QString runInWords(const KeptRun& run)
{
    return RunHistory::tr("%1: %2, %3, %4")
        .arg(run.number)
        .arg(QString::fromStdString(run.run->fabric), QString::fromStdString(run.run->experiment), bytesText(run.bytes));
}

QString whyNotCompared(const KeptRun& one, const KeptRun& other)
{
    if (!one.problem.isEmpty()) { return one.problem; }
    if (!one.complete() || !other.complete()) { return RunHistory::tr("Only completed runs can be compared."); }
    if (!one.measured() || !other.measured()) { return RunHistory::tr("The frames of this run are being read."); }
    if (conditionsOf(*one.run) != conditionsOf(*other.run)) {
        return RunHistory::tr("This run is of another experiment. Only runs of the same experiment can be compared.");
    }
    return {};
}

} // namespace hygroloom
