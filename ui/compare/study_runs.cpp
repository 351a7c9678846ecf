// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/study_runs.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/plan/frame_times.h"
#include "core/run/learned_times.h"
#include "core/run/plan_run.h"
#include "core/run/recording.h"
#include "core/run/side_by_side.h"
#include "gpu/backends.h"
#include "ui/basics/preferences.h"
#include "ui/document/document.h"
#include "ui/document/run_folder.h"
#include "ui/results/device_choice.h"
#include "ui/results/project_runs.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

/// In the bar of progress.
double weightOf(const StudyRuns::Expected& run) { return run.seconds > 0 ? std::max(0.1, run.seconds) : 1; }

/// One scene fills a CPU. A GPU computes some drafts as fast as one, where its memory holds them: see the gate.
std::size_t atOnce(Fidelity fidelity) { return expected_backend(backendOfMany()) == "cpu" || fidelity != Fidelity::draft ? 1 : 8; }

} // namespace

StudyRuns::StudyRuns(Document& document, ProjectRuns& runs, RunHistory& history, QObject* parent)
    : QObject(parent), document_(document), runs_(runs), history_(history), store_(document, runs),
      gate_([] { return memory_for_scenes("auto"); })
{
    connect(&store_, &ReplicateStore::changed, this, &StudyRuns::changed);
    connect(&store_, &ReplicateStore::failed, this, &StudyRuns::failed);
    connect(&document_, &Document::replaced, this, [this] {
        cancel();
        failures_.clear();
    });
}

StudyRuns::~StudyRuns()
{
    queue_.clear();
    control_.cancel = true;
    for (const auto& slot : slots_) {
        if (slot->thread.joinable()) { slot->thread.join(); }
    }
}

void StudyRuns::post(std::function<void()> work) { QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection); }

void StudyRuns::postOf(Slot* slot, std::function<void()> work)
{
    post([this, slot, work = std::move(work)] {
        if (std::any_of(slots_.begin(), slots_.end(), [slot](const auto& each) { return each.get() == slot; })) { work(); }
    });
}

bool StudyRuns::start(const std::vector<Expected>& jobs)
{
    if (running() && control_.cancel) { return false; } // they are just ending
    if (!running()) {
        control_.cancel = false;
        all_seconds_ = done_seconds_ = 0;
        times_ = {};
        all_ = done_ = 0;
        clock_.start();
    }
    for (const Expected& each : jobs) {
        if (stateOf(each.job) != State::none) { continue; }
        failures_.erase(kindOf(each.job));
        queue_.push_back({each, each.design ? each.design : document_.design(), document_.folder().toStdString()});
        all_seconds_ += weightOf(each);
        ++all_;
    }
    startNext();
    Q_EMIT changed();
    return true;
}

void StudyRuns::startNext()
{
    while (!queue_.empty() && slots_.size() < atOnce(queue_.front().expected.job.fidelity)) {
        auto slot = std::make_unique<Slot>();
        slot->work = queue_.front();
        queue_.pop_front();
        if (slot->work.expected.job.recorded) {
            try {
                slot->recording = runs_.reserve();
            } catch (const Error& error) {
                queue_.clear();
                Q_EMIT failed(QString::fromStdString(error.what()));
                break;
            }
        }
        Slot* own = slot.get();
        slots_.push_back(std::move(slot));
        own->thread = std::jthread([this, own, work = own->work, recording = own->recording] {
            const auto result = std::make_shared<Result>(run(work, recording, own));
            post([this, own, result] { end(own, result); });
        });
    }
}

StudyRuns::Result StudyRuns::run(const Waiting& work, const QString& recording, Slot* slot)
{
    Result result;
    try {
        if (find_wear(*work.design, work.expected.job.experiment)) {
            runGarment(work, recording, slot, result);
        } else {
            runSample(work, recording, slot, result);
        }
    } catch (const Cancelled&) {
    } catch (const std::bad_alloc&) {
        result.failure = tr("Not enough memory for this run. Choose a smaller sample or a lower fidelity.");
    } catch (const std::exception& error) {
        result.failure = QString::fromStdString(error.what());
    }
    return result;
}

void StudyRuns::showProgress(Slot* slot, const RunProgress& progress)
{
    postOf(slot, [this, slot, share = progress.duration > 0 ? progress.simulated / progress.duration : 0] {
        slot->share = share;
        slot->course.emplace_back(share, slot->seconds());
        Q_EMIT progressed();
    });
}

void StudyRuns::waitForRoom(Slot* slot, std::optional<MemoryGate::Pass>& pass, const std::function<std::size_t()>& bytes)
{
    if (expected_backend(backendOfMany()) != "cpu") { pass.emplace(gate_, static_cast<double>(bytes()), control_.cancel); }
    QElapsedTimer clock; // waiting for memory is no part of what a run takes
    clock.start();
    postOf(slot, [slot, clock] { slot->clock = clock; });
}

void StudyRuns::runSample(const Waiting& work, const QString& recording, Slot* slot, Result& result)
{
    const StudyJob& job = work.expected.job;
    result.drawn = drawn(*work.design, job.fabric, job.experiment, {1, job.number, job.of});
    RunOptions how;
    how.fidelity = job.fidelity;
    how.seed = result.drawn.seed;
    how.may_go_on_on_cpu = true;
    how.threads = preferences().threads;
    how.one_on_cpu = &one_on_cpu_;
    how.recording = recording.toStdString();
    RunCallbacks callbacks;
    callbacks.progress = [this, slot](const RunProgress& progress) { showProgress(slot, progress); };
    MapTracer tracer;
    const bool traced = !job.recorded && job.mixture == 0;
    if (traced) {
        callbacks.started = [&tracer](const RunRecord& record) { tracer.start(record); };
        callbacks.frame = [&tracer](const std::shared_ptr<const Frame>& frame) { tracer.add(*frame); };
    }
    const Design& own = result.drawn.design;
    const Experiment& experiment = *find_experiment(own, job.experiment);
    std::optional<MemoryGate::Pass> pass;
    waitForRoom(slot, pass,
                [&] { return bytes_of_largest(own, experiment, {textile_of_run(own, *find_fabric(own, job.fabric), experiment)}, how); });
    const std::unique_ptr<Backend> machine = make_backend(backendOfMany());
    result.finished = run_and_measure(own, job.fabric, job.experiment, how, *machine, control_, callbacks);
    if (traced) { result.maps = tracer.take(); }
    if (result.finished->device_failure.empty()) { learn_time(result.finished->run); }
}

void StudyRuns::runGarment(const Waiting& work, const QString& recording, Slot* slot, Result& result)
{
    const StudyJob& job = work.expected.job;
    const GarmentCandidate cut = cut_from(*work.design, job.experiment, work.base, job.fabric);
    const WearExperiment& wear = *find_wear(cut.design, job.experiment);
    result.drawn = drawn(cut.design, fabrics_of(*find_garment(cut.design, wear.garment)), {1, job.number, job.of});
    GarmentRunOptions how;
    how.how.fidelity = job.fidelity;
    how.may_go_on_on_cpu = true;
    how.threads = preferences().threads;
    how.one_on_cpu = &one_on_cpu_;
    how.recording = recording.toStdString();
    GarmentRunCallbacks callbacks;
    callbacks.progress = [this, slot](const RunProgress& progress) { showProgress(slot, progress); };
    std::optional<MemoryGate::Pass> pass;
    waitForRoom(slot, pass, [&] { return bytes_of_largest({cut}, how.how); });
    const Design& own = result.drawn.design;
    const GarmentParts parts = garment_parts(own, *find_wear(own, job.experiment), work.base, [this] { return control_.cancel.load(); });
    const std::unique_ptr<Backend> machine = make_backend(backendOfMany());
    result.worn = run_garment(parts, how, *machine, control_, callbacks);
    learn_time(*result.worn);
}

void StudyRuns::end(Slot* slot, const std::shared_ptr<Result>& result)
{
    const auto at = std::find_if(slots_.begin(), slots_.end(), [slot](const auto& each) { return each.get() == slot; });
    const std::unique_ptr<Slot> own = std::move(*at);
    slots_.erase(at);
    own->thread.join(); // it has posted its last
    const StudyJob& job = own->work.expected.job;
    done_seconds_ += weightOf(own->work.expected);
    if (result->ended()) { times_.add(own->work.expected.seconds, own->seconds(), own->course); }
    ++done_;
    if (job.mixture != 0) {
        handOver(job, *result);
    } else if (job.recorded) {
        keepRecorded(*own, *result);
    } else if (result->ended()) {
        keepNumbers(*own, *result);
    }
    if (!result->failure.isEmpty() && job.mixture == 0) { failures_[kindOf(job)] = result->failure; }
    startNext();
    Q_EMIT changed();
    if (!running()) { Q_EMIT ended(); }
}

Candidate StudyRuns::candidateOf(const Result& result)
{
    if (result.worn) { return candidate_of(*result.worn->record, *result.worn->metrics, result.worn->wall); }
    return candidate_of(std::make_shared<const RunRecord>(result.finished->run), std::make_shared<const Metrics>(result.finished->metrics));
}

/// Of a run that was stopped nothing is kept: it has no numbers to compare.
void StudyRuns::keepRecorded(Slot& slot, const Result& result)
{
    const QString path = runs_.settle(slot.recording);
    if (path.isEmpty()) { return; }
    if (!result.ended() && result.failure.isEmpty()) { return runs_.forget(path); }
    KeptRun kept{path, nullptr, nullptr};
    try {
        if (result.ended()) {
            const Candidate candidate = candidateOf(result);
            kept.run = candidate.run;
            kept.metrics = candidate.metrics;
            if (result.worn) {
                kept.worn = true;
                kept.run = runOfGarment(*result.worn->record, result.worn->wall);
                kept.numbers = std::make_shared<const Candidate>(candidate);
            }
        } else {
            kept = listedRun(path);
        }
    } catch (const Error&) { // the project lists it with its reason when it is opened again
        return;
    }
    kept.own = runs_.owns(path);
    kept.saved = !kept.own || runs_.isFiled(path);
    kept.number = runNumber(path);
    history_.keep(kept);
}

void StudyRuns::keepNumbers(const Slot& slot, const Result& result)
{
    ReplicateSet set{keyOf(*slot.work.design, slot.work.expected.job), result.drawn.names, {}};
    ReplicateRun run = *candidateOf(result).replicates.front();
    run.places = result.drawn.places;
    RunTrace trace = *run.trace;
    trace.maps = result.maps;
    run.trace = std::make_shared<const RunTrace>(std::move(trace));
    set.runs[slot.work.expected.job.number] = std::move(run);
    store_.add(set);
}

/// Of a run that was cancelled there is nothing.
void StudyRuns::handOver(const StudyJob& job, const Result& result)
{
    Candidate candidate;
    candidate.fabric = job.fabric;
    candidate.failure = result.failure.toStdString();
    if (result.finished) {
        candidate = candidateOf(result);
        candidate.replicates.front()->places = result.drawn.places;
        candidate.unknowns = result.drawn.names;
        candidate.run.reset(); // large, and nobody reads them
        candidate.metrics.reset();
    }
    if (result.finished || !result.failure.isEmpty()) { Q_EMIT mixtureEnded(job, candidate); }
}

void StudyRuns::cancel()
{
    queue_.clear();
    if (running()) { control_.cancel = true; }
    Q_EMIT changed();
}

StudyRuns::State StudyRuns::stateOf(const StudyJob& job) const
{
    for (const auto& slot : slots_) {
        if (slot->work.expected.job == job) { return State::running; }
    }
    const auto waits = [&job](const Waiting& each) { return each.expected.job == job; };
    return std::any_of(queue_.begin(), queue_.end(), waits) ? State::waiting : State::none;
}

double StudyRuns::share() const
{
    double done = done_seconds_;
    for (const auto& slot : slots_) { done += slot->share * weightOf(slot->work.expected); }
    return all_seconds_ > 0 ? std::clamp(done / all_seconds_, 0.0, 1.0) : 0;
}

std::optional<double> StudyRuns::timeLeft() const
{
    constexpr qint64 soonest = 2000; // ms
    if (clock_.elapsed() < soonest) { return std::nullopt; }
    std::vector<TimedRun> running;
    std::vector<double> waiting;
    for (const auto& slot : slots_) { running.push_back({slot->work.expected.seconds, slot->seconds(), slot->share}); }
    for (const Waiting& each : queue_) { waiting.push_back(each.expected.seconds); }
    const Fidelity fidelity = queue_.empty() ? Fidelity::draft : queue_.front().expected.job.fidelity;
    return times_.left(running, waiting, static_cast<int>(std::max(atOnce(fidelity), slots_.size())));
}

QString StudyRuns::progressText() const { return tr("%1 of %2 runs done").arg(done_).arg(all_); }

QString StudyRuns::failureOf(const StudyJob& job) const
{
    const auto found = failures_.find(kindOf(job));
    return found == failures_.end() ? QString() : found->second;
}

double secondsToRun(const Design& design, const std::filesystem::path& base, const StudyJob& job)
{
    const std::string backend = expected_backend(backendOfMany());
    try {
        if (find_wear(design, job.experiment)) {
            WearOptions how;
            how.fidelity = job.fidelity;
            return plan_of(cut_from(design, job.experiment, base, job.fabric), how, backend).time.seconds;
        }
        const ModelPlan plan =
            plan_run(design, *find_fabric(design, job.fabric), *find_experiment(design, job.experiment), job.fidelity, {}, {}, backend);
        return seconds_to_wait(plan, job.recorded);
    } catch (const Error&) { // its run will say why
        return 0;
    }
}

} // namespace hygroloom
