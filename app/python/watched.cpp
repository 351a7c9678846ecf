// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/python/watched.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace hygroloom::python {
namespace {

constexpr auto look_every = std::chrono::milliseconds(50);

struct Told {
    double share = 0;
    std::string what;
};

/// Between the two threads.
struct Shared {
    std::mutex mutex;
    std::condition_variable changed;
    bool ended = false;
    std::optional<Told> newest;
};

/// Under Python's lock: what the user or progress wants to end the work with.
void look(const py::object& progress, const std::optional<Told>& told)
{
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (told && !progress.is_none()) progress(told->share, told->what);
}

/// Until the work has ended. Returns what ended it before its time.
std::exception_ptr look_on(const py::object& progress, Shared& shared, Watch& all)
{
    std::exception_ptr stopped;
    std::unique_lock lock(shared.mutex);
    while (!shared.changed.wait_for(lock, look_every, [&] { return shared.ended; })) {
        if (stopped) continue;
        const std::optional<Told> told = std::exchange(shared.newest, std::nullopt);
        lock.unlock();
        {
            const py::gil_scoped_acquire python;
            try {
                look(progress, told);
            } catch (...) {
                stopped = std::current_exception();
                all.control.cancel = true;
            }
        }
        lock.lock();
    }
    return stopped;
}

} // namespace

void watch(const py::object& progress, const std::function<void(Watch&)>& act)
{
    Shared shared;
    Watch all;
    all.tell = [&shared](double share, const std::string& what) {
        const std::lock_guard lock(shared.mutex);
        shared.newest = {share, what};
    };
    std::exception_ptr failure, stopped;
    {
        const py::gil_scoped_release no_python;
        std::thread work([&] {
            try {
                act(all);
            } catch (...) {
                failure = std::current_exception();
            }
            const std::lock_guard lock(shared.mutex);
            shared.ended = true;
            shared.changed.notify_one();
        });
        stopped = look_on(progress, shared, all);
        work.join();
    }
    if (stopped) std::rethrow_exception(stopped);
    if (failure) std::rethrow_exception(failure);
    if (shared.newest) look(progress, shared.newest);
}

} // namespace hygroloom::python
