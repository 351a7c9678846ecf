// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/study_runs.h"

#include "core/base/error.h"
#include "core/plan/frame_times.h"
#include "core/run/plan_run.h"
#include "core/wear/worn_candidate.h"
#include "gpu/backends.h"
#include "ui/basics/preferences.h"
#include "ui/document/document.h"
#include "ui/document/run_folder.h"
#include "ui/results/device_choice.h"
#include "ui/results/plan_dialog.h"
#include "ui/results/project_runs.h"
#include "ui/results/queued_run.h"

#include <QFileInfo>

#include <algorithm>
#include <future>
#include <utility>

namespace hygroloom {

namespace {

/// In the bar of progress.
double weightOf(const StudyRuns::Expected& run) { return run.seconds > 0 ? std::max(0.1, run.seconds) : 1; }

/// s, of a run that came to its end.
double wallOf(const RunResult& result) { return result.garment ? result.garment->wall : result.sample->run.wall; }

/// One scene fills a CPU. A GPU computes some drafts as fast as one, where its memory holds them.
std::size_t atOnce(Fidelity fidelity) { return expected_backend(backendOfMany()) == "cpu" || fidelity != Fidelity::draft ? 1 : 8; }

} // namespace

StudyRuns::StudyRuns(Document& document, ProjectRuns& runs, RunHistory& history, WindowQueue& queue, QObject* parent)
    : QObject(parent), document_(document), runs_(runs), history_(history), queue_(queue), store_(document, runs)
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
    stopping_ = true;
    for (const WorkPtr& work : works_) { queue_.runs().cancel(work->batch); }
    for (const WorkPtr& work : works_) { queue_.runs().wait(work->batch); }
}

void StudyRuns::post(std::function<void()> work) { QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection); }

bool StudyRuns::start(const std::vector<Expected>& jobs)
{
    if (running() && stopping_) { return false; } // they are just ending
    if (!running()) {
        stopping_ = false;
        all_seconds_ = done_seconds_ = 0;
        times_ = {};
        all_ = done_ = 0;
        clock_.start();
    }
    std::vector<WorkPtr> added;
    std::size_t at_once = 8;
    for (const Expected& each : jobs) {
        if (stateOf(each.job) != State::none) { continue; }
        failures_.erase(kindOf(each.job));
        added.push_back(
            std::make_shared<Work>(Work{each, each.design ? each.design : document_.design(), document_.folder().toStdString()}));
        at_once = std::min(at_once, atOnce(each.job.fidelity));
        all_seconds_ += weightOf(each);
        ++all_;
    }
    if (added.empty()) { return true; }
    works_.insert(works_.end(), added.begin(), added.end());
    const auto id = std::make_shared<int>();
    RunBatch batch;
    batch.name = tr("Compare: %1").arg(QString::fromStdString(added.front()->expected.job.experiment)).toStdString();
    batch.count = added.size();
    const std::string machine = expected_backend(backendOfMany());
    batch.places = std::make_shared<RunPlaces>([] { return make_backend(backendOfMany()); }, machine, at_once);
    if (machine != "cpu") {
        batch.room = [] { return memory_for_scenes("auto"); };
    }
    batch.job = [this, added](std::size_t i) { return jobOf(added[i]); };
    batch.ended = [this, added](std::size_t i, RunResult& result) {
        post([this, work = added[i], found = std::make_shared<RunResult>(std::move(result))] { end(work, found); });
    };
    batch.paused = [this, id](bool paused) { post([this, id, paused] { setPaused(*id, paused); }); };
    batch.over = [this, id] { post([this, id] { endBatch(*id); }); };
    *id = queue_.runs().add(std::move(batch));
    for (const WorkPtr& work : added) { work->batch = *id; }
    Q_EMIT changed();
    return true;
}

/// In the run's thread.
RunJob StudyRuns::jobOf(const WorkPtr& work)
{
    const StudyJob& asked = work->expected.job;
    RunJob job{work->design, asked.experiment, asked.fabric, work->base};
    job.replicate = asked.number;
    job.replicates = asked.of;
    job.how.fidelity = asked.fidelity;
    job.how.may_go_on_on_cpu = true;
    job.how.threads = preferences().threads;
    job.how.recording = reserved(work).toStdString();
    job.beside.progress = [this, work](const RunProgress& progress) { showProgress(work, progress); };
    if (!asked.recorded && asked.mixture == 0) {
        job.beside.started = [work](const RunRecord& record) { work->tracer.start(record); };
        job.beside.frame = [work](const std::shared_ptr<const Frame>& frame) { work->tracer.add(*frame); };
    }
    return job;
}

/// The path of its recording, which the window's thread knows; empty where none is recorded. Throws Cancelled and Error.
QString StudyRuns::reserved(const WorkPtr& work)
{
    constexpr std::chrono::milliseconds soon(20);
    const auto promise = std::make_shared<std::promise<QString>>();
    post([this, work, promise] {
        work->state = State::running;
        try {
            if (work->expected.job.recorded && !stopping_) { work->recording = runs_.reserve(); }
            promise->set_value(work->recording);
        } catch (const Error& error) {
            promise->set_exception(std::current_exception());
            cancel();
            Q_EMIT failed(QString::fromStdString(error.what()));
        }
        Q_EMIT changed();
    });
    std::future<QString> path = promise->get_future();
    while (path.wait_for(soon) != std::future_status::ready) {
        if (stopping_) { throw Cancelled(); }
    }
    return path.get();
}

void StudyRuns::showProgress(const WorkPtr& work, const RunProgress& progress)
{
    post([this, work, wall = progress.wall, share = progress.duration > 0 ? progress.simulated / progress.duration : 0] {
        work->share = share;
        work->wall = wall;
        work->course.emplace_back(share, wall);
        Q_EMIT progressed();
    });
}

void StudyRuns::end(const WorkPtr& work, const std::shared_ptr<RunResult>& result)
{
    std::erase(works_, work);
    const StudyJob& job = work->expected.job;
    const QString failure = failureText(*result, tr("Choose a smaller sample or a lower fidelity."));
    done_seconds_ += weightOf(work->expected);
    if (result->ended()) { times_.add(work->expected.seconds, wallOf(*result), work->course); }
    ++done_;
    if (job.mixture != 0) {
        handOver(job, *result, failure);
    } else if (job.recorded) {
        keepRecorded(*work, *result, failure);
    } else if (result->ended()) {
        keepNumbers(*work, *result);
    }
    if (!failure.isEmpty() && job.mixture == 0) { failures_[kindOf(job)] = failure; }
    Q_EMIT changed();
}

void StudyRuns::setPaused(int batch, bool paused)
{
    for (const WorkPtr& work : works_) {
        if (work->batch == batch) { work->paused = paused; }
    }
    Q_EMIT progressed();
}

bool StudyRuns::paused() const
{
    return running() && std::all_of(works_.begin(), works_.end(), [](const WorkPtr& work) { return work->paused; });
}

/// Those that did not begin are left.
void StudyRuns::endBatch(int batch)
{
    std::erase_if(works_, [batch](const WorkPtr& work) { return work->batch == batch; });
    Q_EMIT changed();
    if (!running()) { Q_EMIT ended(); }
}

Candidate StudyRuns::candidateOf(const RunResult& result)
{
    if (result.garment) { return candidate_of(*result.garment->record, *result.garment->metrics, result.garment->wall); }
    return candidate_of(std::make_shared<const RunRecord>(result.sample->run), std::make_shared<const Metrics>(result.sample->metrics));
}

/// Of a run that was stopped nothing is kept: it has no numbers to compare.
void StudyRuns::keepRecorded(const Work& work, const RunResult& result, const QString& failure)
{
    const QString path = work.recording.isEmpty() ? QString() : runs_.settle(work.recording);
    if (path.isEmpty()) { return; }
    if (!result.ended() && failure.isEmpty()) { return runs_.forget(path); }
    KeptRun kept{path, nullptr, nullptr};
    try {
        if (result.ended()) {
            const Candidate candidate = candidateOf(result);
            kept.run = candidate.run;
            kept.metrics = candidate.metrics;
            if (result.garment) {
                kept.worn = true;
                kept.run = runOfGarment(*result.garment->record, result.garment->wall);
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

void StudyRuns::keepNumbers(Work& work, const RunResult& result)
{
    ReplicateSet set{keyOf(*work.design, work.expected.job), result.drawn.names, {}};
    ReplicateRun run = *candidateOf(result).replicates.front();
    run.places = result.drawn.places;
    RunTrace trace = *run.trace;
    if (result.sample) { trace.maps = work.tracer.take(); }
    run.trace = std::make_shared<const RunTrace>(std::move(trace));
    set.runs[work.expected.job.number] = std::move(run);
    store_.add(set);
}

/// Of a run that was cancelled there is nothing.
void StudyRuns::handOver(const StudyJob& job, const RunResult& result, const QString& failure)
{
    Candidate candidate;
    candidate.fabric = job.fabric;
    candidate.failure = failure.toStdString();
    if (result.sample) {
        candidate = candidateOf(result);
        candidate.replicates.front()->places = result.drawn.places;
        candidate.unknowns = result.drawn.names;
        candidate.run.reset(); // large, and nobody reads them
        candidate.metrics.reset();
    }
    if (result.sample || !failure.isEmpty()) { Q_EMIT mixtureEnded(job, candidate); }
}

void StudyRuns::cancel()
{
    if (!running()) { return; }
    stopping_ = true;
    for (const WorkPtr& work : works_) {
        if (work->state == State::waiting) { work->state = State::none; }
        queue_.runs().cancel(work->batch);
    }
    Q_EMIT changed();
}

StudyRuns::State StudyRuns::stateOf(const StudyJob& job) const
{
    const auto found = std::find_if(works_.begin(), works_.end(), [&job](const WorkPtr& work) { return work->expected.job == job; });
    return found == works_.end() ? State::none : (*found)->state;
}

double StudyRuns::share() const
{
    double done = done_seconds_;
    for (const WorkPtr& work : works_) { done += work->share * weightOf(work->expected); }
    return all_seconds_ > 0 ? std::clamp(done / all_seconds_, 0.0, 1.0) : 0;
}

std::optional<double> StudyRuns::timeLeft() const
{
    constexpr qint64 soonest = 2000; // ms
    if (clock_.elapsed() < soonest) { return std::nullopt; }
    std::vector<TimedRun> running;
    std::vector<double> waiting;
    Fidelity next = Fidelity::draft;
    for (const WorkPtr& work : works_) {
        if (work->state == State::running) {
            running.push_back({work->expected.seconds, work->wall, work->share});
        } else {
            if (waiting.empty()) { next = work->expected.job.fidelity; }
            waiting.push_back(work->expected.seconds);
        }
    }
    return times_.left(running, waiting, static_cast<int>(std::max(atOnce(next), running.size())));
}

QString StudyRuns::progressText() const { return tr("%1 of %2 runs done").arg(done_).arg(all_); }

QString StudyRuns::stateText() const
{
    if (paused()) { return tr("%1, paused.").arg(progressText()); }
    const auto left = timeLeft();
    return left ? tr("%1, %2 left.").arg(progressText(), roughDuration(*left)) : progressText() + ".";
}

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
            RunOptions how;
            how.fidelity = job.fidelity;
            return plan_worn(cut_from(design, job.experiment, job.fabric), job.experiment, base, how, backend).time.seconds;
        }
        const ModelPlan plan =
            plan_run(design, *find_fabric(design, job.fabric), *find_experiment(design, job.experiment), job.fidelity, {}, {}, backend);
        return seconds_to_wait(plan, job.recorded);
    } catch (const Error&) { // its run will say why
        return 0;
    }
}

} // namespace hygroloom
