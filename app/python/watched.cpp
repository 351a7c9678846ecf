// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/python/watched.h"

#include "app/python/unlocked.h"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <pthread.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace hygroloom::python {
namespace {

constexpr auto look_every = std::chrono::milliseconds(50), patience = std::chrono::milliseconds(150),
               patience_at_exit = std::chrono::milliseconds(300);

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

/// Work that has a thread. Never destroyed: threads may use it until the process has ended.
struct Works {
    std::mutex mutex;
    std::vector<std::shared_ptr<Work>> all;
};
Works* works = new Works;
/// A forked child has none of its parent's threads.
[[maybe_unused]] const int child_has_none = pthread_atfork(nullptr, nullptr, [] { works = new Works; });

/// A thread that Python leaves behind does not come back from here.
std::unique_lock<std::mutex> locked_works()
{
    std::unique_lock lock(works->mutex);
    if (is_exited()) {
        lock.unlock();
        stay();
    }
    return lock;
}

bool has_ended(Work& work)
{
    const std::lock_guard lock(work.mutex);
    return work.ended;
}

void join_those_that_ended(Works& these)
{
    std::erase_if(these.all, [](const std::shared_ptr<Work>& work) {
        if (!has_ended(*work)) return false;
        work->thread.join();
        return true;
    });
}

void start(const std::shared_ptr<Work>& work, std::function<void(Watch&)> act)
{
    work->watch.tell = [from = work.get()](double share, const std::string& what) {
        const std::lock_guard lock(from->mutex);
        from->newest = {share, what};
    };
    const std::unique_lock lock = locked_works();
    work->thread = std::thread([work, act = std::move(act)]() mutable {
        try {
            act(work->watch);
        } catch (...) {
            work->failure = std::current_exception();
        }
        act = nullptr; // what it holds goes before the caller goes on
        const std::lock_guard own(work->mutex);
        work->ended = true;
        work->changed.notify_all();
    });
    works->all.push_back(work);
}

/// Under Python's lock: throws what the user or progress wants to end the work with.
void look(const py::object& progress, const std::optional<Told>& told)
{
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (told && !progress.is_none()) call_progress(progress, told->share, told->what.c_str());
}

/// Until the work has ended, or has been told to and takes long. Returns what it was told to end for.
std::exception_ptr look_on(const py::object& progress, Work& work, Unlocked& python)
{
    const auto has_ended = [&] { return work.ended; };
    std::unique_lock lock(work.mutex);
    while (!work.changed.wait_for(lock, look_every, has_ended)) {
        const std::optional<Told> told = std::exchange(work.newest, std::nullopt);
        lock.unlock();
        python.take();
        std::exception_ptr stopped;
        try {
            look(progress, told);
        } catch (...) {
            stopped = std::current_exception();
        }
        python.give();
        if (stopped) work.watch.control.cancel = true;
        lock.lock();
        if (stopped) work.changed.wait_for(lock, patience, has_ended);
        if (stopped) return stopped;
    }
    return nullptr;
}

/// Joins what has ended; work that goes on is left behind.
void tidy()
{
    const std::unique_lock lock = locked_works();
    join_those_that_ended(*works);
}

} // namespace

void watch(const py::object& progress, std::function<void(Watch&)> act)
{
    const auto work = std::make_shared<Work>();
    std::exception_ptr stopped;
    {
        Unlocked python;
        start(work, std::move(act));
        stopped = look_on(progress, *work, python);
        tidy();
    }
    if (stopped) std::rethrow_exception(stopped);
    if (work->failure) std::rethrow_exception(work->failure);
    if (work->newest) look(progress, work->newest);
}

void end_all_work()
{
    const Unlocked no_python;
    python_exits();
    const std::lock_guard lock(works->mutex);
    for (const std::shared_ptr<Work>& work : works->all) work->watch.control.cancel = true;
    const auto until = std::chrono::steady_clock::now() + patience_at_exit;
    for (const std::shared_ptr<Work>& work : works->all) {
        std::unique_lock own(work->mutex);
        work->changed.wait_until(own, until, [&] { return work->ended; });
    }
    join_those_that_ended(*works);
    // What still goes on uses what destructors would take away.
    if (!works->all.empty()) on_exit([](int status, void*) { std::fflush(nullptr), _exit(status); }, nullptr);
}

} // namespace hygroloom::python
