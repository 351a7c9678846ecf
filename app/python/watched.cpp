// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/python/watched.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace hygroloom::python {
namespace {

constexpr auto look_every = std::chrono::milliseconds(50), patience = std::chrono::milliseconds(150);

struct Told {
    double share = 0;
    std::string what;
};

/// Of one piece of work, between its thread and the caller's.
struct Work {
    Watch watch;
    std::mutex mutex;
    std::condition_variable changed;
    bool ended = false;
    std::optional<Told> newest;
    std::exception_ptr failure;
    std::thread thread;
};

/// Work that nobody waits for any more, until its thread is joined.
struct LeftBehind {
    std::mutex mutex;
    std::vector<std::shared_ptr<Work>> all;
};
LeftBehind& left_behind()
{
    static LeftBehind left;
    return left;
}

void start(const std::shared_ptr<Work>& work, std::function<void(Watch&)> act)
{
    work->watch.tell = [from = work.get()](double share, const std::string& what) {
        const std::lock_guard lock(from->mutex);
        from->newest = {share, what};
    };
    work->thread = std::thread([work, act = std::move(act)]() mutable {
        try {
            act(work->watch);
        } catch (...) {
            work->failure = std::current_exception();
        }
        act = nullptr; // what it holds goes before the caller goes on
        const std::lock_guard lock(work->mutex);
        work->ended = true;
        work->changed.notify_one();
    });
}

/// Under Python's lock: throws what the user or progress wants to end the work with.
void look(const py::object& progress, const std::optional<Told>& told)
{
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (told && !progress.is_none()) progress(told->share, told->what);
}

/// Until the work has ended, or has been told to and takes long. Returns what it was told to end for.
std::exception_ptr look_on(const py::object& progress, Work& work)
{
    const auto has_ended = [&] { return work.ended; };
    std::unique_lock lock(work.mutex);
    while (!work.changed.wait_for(lock, look_every, has_ended)) {
        const std::optional<Told> told = std::exchange(work.newest, std::nullopt);
        lock.unlock();
        {
            const py::gil_scoped_acquire python;
            try {
                look(progress, told);
            } catch (...) {
                work.watch.control.cancel = true;
                const std::exception_ptr stopped = std::current_exception();
                const py::gil_scoped_release no_python;
                lock.lock();
                work.changed.wait_for(lock, patience, has_ended);
                return stopped;
            }
        }
        lock.lock();
    }
    return nullptr;
}

/// Joins the thread, or leaves it behind.
void end(const std::shared_ptr<Work>& work)
{
    {
        const std::lock_guard lock(work->mutex);
        if (!work->ended) {
            const std::lock_guard list(left_behind().mutex);
            left_behind().all.push_back(work);
            return;
        }
    }
    work->thread.join();
}

} // namespace

void watch(const py::object& progress, std::function<void(Watch&)> act)
{
    const auto work = std::make_shared<Work>();
    std::exception_ptr stopped;
    {
        const py::gil_scoped_release no_python;
        start(work, std::move(act));
        stopped = look_on(progress, *work);
        end(work);
    }
    if (stopped) std::rethrow_exception(stopped);
    if (work->failure) std::rethrow_exception(work->failure);
    if (work->newest) look(progress, work->newest);
}

void wait_for_all_work()
{
    const py::gil_scoped_release no_python;
    const std::lock_guard lock(left_behind().mutex);
    for (const std::shared_ptr<Work>& work : left_behind().all) work->thread.join();
    left_behind().all.clear();
}

} // namespace hygroloom::python
