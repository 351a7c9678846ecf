// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/queued_run.h"

#include "core/base/error.h"
#include "gpu/backends.h"
#include "ui/basics/quantity.h"

#include <utility>

namespace hygroloom {

namespace {

QueuedRun::Outcome outcomeOf(const RunResult& result)
{
    if (!result.error) { return QueuedRun::Outcome::finished; }
    try {
        std::rethrow_exception(result.error);
    } catch (const Cancelled&) {
        return QueuedRun::Outcome::cancelled;
    } catch (const DeviceError&) {
        return QueuedRun::Outcome::device_failed;
    } catch (const NotEnoughMemory&) {
        return QueuedRun::Outcome::memory_short;
    } catch (...) {
        return QueuedRun::Outcome::failed;
    }
}

} // namespace

QString failureText(const RunResult& result, const QString& else_do)
{
    if (!result.error) { return {}; }
    try {
        std::rethrow_exception(result.error);
    } catch (const NotEnoughMemory& error) {
        return QueuedRun::tr("This run takes about %1 of memory; %2 are free. %3")
            .arg(bytesText(error.needed), bytesText(error.available), else_do);
    } catch (const std::bad_alloc&) {
        return QueuedRun::tr("Not enough memory for this run. %1").arg(else_do);
    } catch (...) {
        return QString::fromStdString(result.failure());
    }
}

QueuedRun::QueuedRun(WindowQueue& queue, QObject* parent) : QObject(parent), queue_(queue) {}

QueuedRun::~QueuedRun()
{
    cancel();
    try {
        queue_.runs().wait(id_);
    } catch (...) { // nobody asks any more
    }
}

void QueuedRun::start(RunJob job, const std::string& backend, const QString& else_do, std::function<void(RunResult&)> completed)
{
    else_do_ = else_do;
    paused_ = stops_here_ = false;
    job.beside.device_failed = [this](const std::string& sentence) {
        post([this, said = QString::fromStdString(sentence)] { Q_EMIT deviceFailed(said); });
    };
    job.beside.memory_is_short = [this](const std::string&) { post([this] { Q_EMIT memoryIsShort(); }); };
    job.beside.progress = [this](const RunProgress& progress) { post([this, progress] { Q_EMIT progressed(progress); }); };
    const auto found = std::make_shared<RunResult>();
    found->error = std::make_exception_ptr(Cancelled()); // where it was stopped before it began
    RunBatch batch;
    batch.name = (job.fabric.empty() ? find_wear(*job.design, job.experiment)->garment : job.fabric) + ", " + job.experiment;
    batch.places = std::make_shared<RunPlaces>([backend] { return make_backend(backend); }, expected_backend(backend), 1);
    batch.watched = true;
    batch.paused = [this](bool paused) { post([this, paused] { showPaused(paused); }); };
    batch.job = [job = std::move(job)](std::size_t) { return job; };
    batch.ended = [found, completed = std::move(completed)](std::size_t, RunResult& result) {
        try {
            if (result.ended()) { completed(result); }
        } catch (...) {
            result.error = std::current_exception();
        }
        *found = std::move(result);
    };
    batch.over = [this, found] { post([this, found] { end(found); }); };
    id_ = queue_.runs().add(std::move(batch));
    Q_EMIT begun();
}

void QueuedRun::end(const std::shared_ptr<RunResult>& result)
{
    id_ = 0;
    paused_ = false;
    const QString device = result->ended() ? QString::fromStdString(result->device_failure()) : QString();
    Q_EMIT ended(outcomeOf(*result), QStringList{device, failureText(*result, else_do_)}.join(' ').trimmed());
}

void QueuedRun::setPaused(bool paused)
{
    if (!running() || paused_ == paused) { return; }
    queue_.runs().set_paused(id_, paused);
    showPaused(paused);
}

/// Also where it was paused in the list of runs.
void QueuedRun::showPaused(bool paused)
{
    if (running() && std::exchange(paused_, paused) != paused) { Q_EMIT pausedChanged(paused); }
}

void QueuedRun::cancel()
{
    stops_here_ = true;
    queue_.runs().cancel(id_);
}

} // namespace hygroloom
