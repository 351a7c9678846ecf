// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The one queue of runs: which goes when and where, how many at once, and how far each is.
#pragma once

#include "core/queue/run_job.h"
#include "core/queue/run_places.h"

#include <condition_variable>
#include <list>
#include <mutex>
#include <string>
#include <thread>

namespace hygroloom {

/// Runs that belong together: those of a comparison, the rows of a study, or one alone.
struct RunBatch {
    std::string name; ///< for lists
    std::size_t count = 1;
    std::shared_ptr<RunPlaces> places;
    std::function<RunJob(std::size_t)> job; ///< of each, in its own thread; what it throws is the failure of that run
    /// Of each that began, also of those that were stopped; never two at a time. What it throws stops the batch.
    std::function<void(std::size_t, RunResult&)> ended = {};
    std::function<void()> over = {};       ///< after the last; not where the queue goes before
    std::function<void(bool)> paused = {}; ///< when it was paused, or was let go on; it may not call the queue
    bool watched = false;                  ///< somebody waits for it: it begins whatever else is on
    /// Bytes that all runs of the queue may take together where these go; asked when none is on. Empty: the number of places is bound
    /// enough.
    std::function<double()> room = {};
};

/// A batch in a list.
struct BatchState {
    enum class State { waiting, running, paused, stopping };
    enum class WaitsFor { nothing, others, memory };

    int id = 0;
    std::string name;
    State state = State::waiting;
    WaitsFor waits_for = WaitsFor::nothing;
    std::size_t count = 0, ended = 0, failed = 0; ///< runs
    std::size_t running = 0;                      ///< runs that compute: neither on hold nor waiting for memory
    double share = 0;                             ///< of all its runs
};

/// Batches begin in their order, and runs of a batch in theirs. A run begins, or goes on, where its places have one free and its share of
/// their machine is free; until it may, none behind it begins on that machine but those that are watched. A run that fails or is stopped
/// concerns no other. Any thread may call it.
class RunQueue {
public:
    /// changed: called from any thread when list() may say something else; it may not call the queue.
    explicit RunQueue(std::function<void()> changed = {}) : changed_(std::move(changed)) {}
    /// Stops all and waits, 0.2 s or so.
    ~RunQueue();
    RunQueue(const RunQueue&) = delete;
    RunQueue& operator=(const RunQueue&) = delete;

    /// Behind all others. Returns its number, by which it is known. Precondition: it has a run.
    int add(RunBatch batch);
    /// Up (less than 0) or down by so many batches.
    void move(int id, int by);
    /// Its runs are put on hold, and none begins; others may take their turn. Let go on, it waits for its turn again.
    void set_paused(int id, bool paused);
    /// Those that are on end within 0.2 s, none begins any more.
    void cancel(int id);
    /// Until it is over. Throws what its ended() threw.
    void wait(int id);
    /// add() and wait(), which stops it once cancel is set. A batch without runs is over at once. Whether none of its runs was stopped.
    bool run(RunBatch batch, const std::atomic<bool>& cancel);

    /// Those that are not over, in order.
    std::vector<BatchState> list() const;

private:
    struct Run {
        std::size_t index = 0;
        RunControl control;
        double share = 0;
        bool waits_for_memory = false;
    };
    struct Batch {
        int id = 0;
        RunBatch what;
        std::size_t next = 0, ended = 0, failed = 0;
        bool paused = false, cancelled = false, ending = false, gone = false;
        std::list<Run> on;
        std::exception_ptr failure;               ///< of ended()
        const std::atomic<bool>* stops = nullptr; ///< of run()
        std::mutex telling;                       ///< held while ended() is called

        void stop();
        bool has_next() const { return !cancelled && !(stops && *stops) && next < what.count; }
        bool is_over() const { return on.empty() && !has_next(); }
        std::size_t held() const;
        double taken(bool with_waiting) const;
        bool waits_for_memory() const;
    };
    using Lock = std::unique_lock<std::mutex>;

    std::shared_ptr<Batch> enqueue(RunBatch batch, const std::atomic<bool>* stops);
    std::shared_ptr<Batch> find(int id) const;
    bool has_room(const Batch& batch, bool is_new) const;
    void let_go_on(Batch& batch) const;
    std::shared_ptr<Batch> next_batch();
    void work();
    void call_workers();
    void run_next(const std::shared_ptr<Batch>& batch, Lock& lock);
    RunResult result_of(Batch& batch, Run& run, Backend* backend);
    double wait_for_room(Batch& batch, Run& run, double bytes);
    void leave_room(double bytes);
    void tell(const std::shared_ptr<Batch>& batch, std::size_t index, RunResult& result);
    void stop(const std::shared_ptr<Batch>& batch, Lock& lock);
    void end(const std::shared_ptr<Batch>& batch, Lock& lock);
    void say_changed() const
    {
        if (changed_) changed_();
    }

    const std::function<void()> changed_;
    mutable std::mutex mutex_;
    std::condition_variable work_, over_, room_;
    std::list<std::shared_ptr<Batch>> batches_;
    std::mutex one_on_cpu_; ///< see RunOptions
    int last_id_ = 0, inside_ = 0;
    double all_ = 0, taken_ = 0; ///< bytes of those inside
    std::size_t idle_ = 0;
    bool closing_ = false;
    std::vector<std::jthread> workers_; // last: joined before the rest goes
};

} // namespace hygroloom
