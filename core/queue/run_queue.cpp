// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/queue/run_queue.h"

#include "core/base/error.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace hygroloom {

RunQueue::~RunQueue()
{
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
        for (const auto& batch : batches_) batch->stop();
    }
    work_.notify_all();
    room_.notify_all();
    workers_.clear();
}

int RunQueue::add(RunBatch batch) { return enqueue(std::move(batch), nullptr)->id; }

std::shared_ptr<RunQueue::Batch> RunQueue::enqueue(RunBatch batch, const std::atomic<bool>* stops)
{
    const std::lock_guard lock(mutex_);
    auto added = std::make_shared<Batch>();
    added->id = ++last_id_;
    added->what = std::move(batch);
    added->stops = stops;
    batches_.push_back(added);
    call_workers();
    say_changed();
    return added;
}

void RunQueue::move(int id, int by)
{
    const std::lock_guard lock(mutex_);
    const auto at = std::find_if(batches_.begin(), batches_.end(), [id](const auto& batch) { return batch->id == id; });
    if (at == batches_.end()) return;
    const auto from = std::distance(batches_.begin(), at);
    const auto batch = *at;
    batches_.erase(at);
    const auto to = std::clamp<std::ptrdiff_t>(from + by, 0, static_cast<std::ptrdiff_t>(batches_.size()));
    batches_.insert(std::next(batches_.begin(), to), batch);
    call_workers();
    say_changed();
}

void RunQueue::set_paused(int id, bool paused)
{
    const std::lock_guard lock(mutex_);
    const auto batch = find(id);
    if (!batch) return;
    if (std::exchange(batch->paused, paused) == paused) return;
    if (paused)
        for (Run& run : batch->on) run.control.pause = run.control.was_paused = true;
    if (batch->what.paused) batch->what.paused(paused);
    call_workers();
    say_changed();
}

void RunQueue::cancel(int id)
{
    Lock lock(mutex_);
    const auto batch = find(id);
    if (batch) stop(batch, lock);
}

void RunQueue::wait(int id)
{
    Lock lock(mutex_);
    const auto batch = find(id);
    if (!batch) return;
    over_.wait(lock, [&] { return batch->gone; });
    if (batch->failure) std::rethrow_exception(batch->failure);
}

bool RunQueue::run(RunBatch batch, const std::atomic<bool>& cancel)
{
    constexpr std::chrono::milliseconds soon(20); // a signal wakes nobody
    if (batch.count == 0) return true;
    const auto own = enqueue(std::move(batch), &cancel);
    Lock lock(mutex_);
    while (!over_.wait_for(lock, soon, [&] { return own->gone; }))
        if (cancel && !own->cancelled) stop(own, lock);
    if (own->failure) std::rethrow_exception(own->failure);
    return own->next == own->what.count && !own->cancelled;
}

std::vector<BatchState> RunQueue::list() const
{
    const std::lock_guard lock(mutex_);
    std::vector<BatchState> states;
    for (const auto& batch : batches_) {
        BatchState state{batch->id, batch->what.name};
        state.count = batch->what.count;
        state.ended = batch->ended;
        state.failed = batch->failed;
        state.share = static_cast<double>(batch->ended);
        bool for_memory = false;
        for (const Run& run : batch->on) {
            state.share += run.share;
            for_memory = for_memory || run.waits_for_memory;
            state.running += !run.waits_for_memory && !run.control.pause;
        }
        state.share /= static_cast<double>(state.count);
        state.state = batch->cancelled    ? BatchState::State::stopping
                      : batch->paused     ? BatchState::State::paused
                      : state.running > 0 ? BatchState::State::running
                                          : BatchState::State::waiting;
        if (state.state == BatchState::State::waiting)
            state.waits_for = for_memory ? BatchState::WaitsFor::memory : BatchState::WaitsFor::others;
        states.push_back(std::move(state));
    }
    return states;
}

std::shared_ptr<RunQueue::Batch> RunQueue::find(int id) const
{
    const auto found = std::find_if(batches_.begin(), batches_.end(), [id](const auto& batch) { return batch->id == id; });
    return found == batches_.end() ? nullptr : *found;
}

/// Whether one more run of the batch may compute: a new one, or one on hold, which has its memory and so does not wait for those that wait
/// for memory.
bool RunQueue::has_room(const Batch& batch, bool is_new) const
{
    constexpr double all = 1 + 1e-9;
    if (batch.what.watched) return true;
    double taken = batch.what.places->share();
    for (const auto& other : batches_)
        if (other->what.places->machine() == batch.what.places->machine()) taken += other->taken(is_new);
    return taken <= all;
}

void RunQueue::let_go_on(Batch& batch) const
{
    for (Run& run : batch.on)
        if (run.control.pause && has_room(batch, false)) run.control.pause = false;
}

/// The one whose next run may begin. On the way runs that were on hold go on in their turn.
std::shared_ptr<RunQueue::Batch> RunQueue::next_batch()
{
    std::set<std::string> full; // machines that one waits for which is not watched
    for (const auto& batch : batches_) {
        const RunPlaces& places = *batch->what.places;
        if (closing_ || batch->paused || (full.contains(places.machine()) && !batch->what.watched)) continue;
        let_go_on(*batch);
        const bool held = batch->held() > 0;
        if (!held && batch->has_next() && places.has_free() && has_room(*batch, true)) return batch;
        if (!batch->what.watched && (held || batch->has_next()) && !batch->waits_for_memory()) full.insert(places.machine());
    }
    return nullptr;
}

void RunQueue::call_workers()
{
    if (!next_batch()) return;
    if (idle_ == 0)
        workers_.emplace_back([this] { work(); });
    else
        work_.notify_one();
}

void RunQueue::work()
{
    Lock lock(mutex_);
    while (!closing_) {
        if (const auto batch = next_batch()) {
            run_next(batch, lock);
        } else {
            ++idle_;
            work_.wait(lock);
            --idle_;
        }
    }
}

void RunQueue::run_next(const std::shared_ptr<Batch>& batch, Lock& lock)
{
    Run& run = batch->on.emplace_back();
    run.index = batch->next++;
    Backend* const backend = batch->what.places->take();
    call_workers(); // there may be room for another
    lock.unlock();
    RunResult result = result_of(*batch, run, backend);
    const bool device_failed = result.ended() && !result.device_failure().empty(), failed = !result.failure().empty();
    tell(batch, run.index, result); // who is told may take it
    lock.lock();
    const bool last = !batch->has_next();
    if (backend && (last || device_failed)) { // leaves all of the device to the others
        lock.unlock();
        backend->unload();
        lock.lock();
    }
    batch->what.places->give_back(backend, device_failed);
    batch->on.remove_if([&run](const Run& each) { return &each == &run; });
    ++batch->ended;
    batch->failed += failed;
    if (batch->is_over()) end(batch, lock);
    say_changed();
}

RunResult RunQueue::result_of(Batch& batch, Run& run, Backend* backend)
{
    const auto start = std::chrono::steady_clock::now();
    RunResult result;
    std::string device;
    double bytes = 0;
    try {
        RunJob job = batch.what.job(run.index);
        job.how.one_on_cpu = &one_on_cpu_;
        job.beside.progress = [this, &run, beside = std::move(job.beside.progress)](const RunProgress& progress) {
            {
                const std::lock_guard lock(mutex_);
                run.share = progress.duration > 0 ? std::min(1.0, progress.simulated / progress.duration) : 0;
            }
            if (beside) beside(progress);
            say_changed();
        };
        if (batch.what.room) bytes = wait_for_room(batch, run, bytes_of(job));
        const std::unique_ptr<Backend> own = backend ? nullptr : batch.what.places->open();
        Backend& machine = backend ? *backend : *own;
        device = machine.device();
        result = run_job(job, machine, run.control);
    } catch (...) {
        result.error = std::current_exception();
        result.device = device;
    }
    result.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (bytes > 0) leave_room(bytes);
    return result;
}

/// Returns the bytes that it takes up. What would never fit goes alone. Throws Cancelled.
double RunQueue::wait_for_room(Batch& batch, Run& run, double bytes)
{
    if (bytes <= 0) return 0;
    Lock lock(mutex_);
    const auto fits = [&] { return inside_ == 0 || taken_ + bytes <= all_; };
    run.waits_for_memory = !fits();
    if (run.waits_for_memory) {
        call_workers(); // runs on hold may go on now
        say_changed();
    }
    room_.wait(lock, [&] { return fits() || run.control.cancel; });
    run.waits_for_memory = false;
    if (run.control.cancel) throw Cancelled();
    taken_ += bytes;
    if (inside_++ > 0) return bytes;
    all_ = 0; // for the others, until it is known: to ask a device takes a while
    lock.unlock();
    try {
        const double all = batch.what.room();
        lock.lock();
        all_ = all;
    } catch (...) {
        leave_room(bytes);
        throw;
    }
    lock.unlock();
    room_.notify_all();
    return bytes;
}

void RunQueue::leave_room(double bytes)
{
    {
        const std::lock_guard lock(mutex_);
        --inside_;
        taken_ = inside_ == 0 ? 0 : taken_ - bytes;
    }
    room_.notify_all();
}

void RunQueue::tell(const std::shared_ptr<Batch>& batch, std::size_t index, RunResult& result)
{
    if (!batch->what.ended) return;
    const std::lock_guard telling(batch->telling);
    try {
        batch->what.ended(index, result);
    } catch (...) {
        Lock lock(mutex_);
        if (!batch->failure) batch->failure = std::current_exception();
        stop(batch, lock);
    }
}

std::size_t RunQueue::Batch::held() const
{
    return static_cast<std::size_t>(std::count_if(on.begin(), on.end(), [](const Run& run) { return run.control.pause.load(); }));
}

bool RunQueue::Batch::waits_for_memory() const
{
    return std::any_of(on.begin(), on.end(), [](const Run& run) { return run.waits_for_memory; });
}

/// Of its machine; with or without that of runs that wait for memory.
double RunQueue::Batch::taken(bool with_waiting) const
{
    const auto counts = [&](const Run& run) { return !run.control.pause && (with_waiting || !run.waits_for_memory); };
    return what.places->share() * static_cast<double>(std::count_if(on.begin(), on.end(), counts));
}

void RunQueue::Batch::stop()
{
    cancelled = true;
    for (Run& run : on) run.control.cancel = true;
}

void RunQueue::stop(const std::shared_ptr<Batch>& batch, Lock& lock)
{
    batch->stop();
    room_.notify_all();
    if (batch->is_over()) end(batch, lock);
    call_workers(); // those behind it may begin
    say_changed();
}

void RunQueue::end(const std::shared_ptr<Batch>& batch, Lock& lock)
{
    if (std::exchange(batch->ending, true)) return;
    if (!closing_ && batch->what.over) {
        lock.unlock();
        batch->what.over();
        lock.lock();
    }
    batches_.remove(batch);
    batch->gone = true;
    over_.notify_all();
}

} // namespace hygroloom
