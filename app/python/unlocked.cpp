// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/python/unlocked.h"

#include <atomic>
#include <cxxabi.h>
#include <pthread.h>
#include <thread>

namespace hygroloom::python {
namespace {

std::atomic<bool> exits = false;
std::thread::id exits_by; ///< set before exits

/// A forked child goes on, whatever its parent did.
[[maybe_unused]] const int child_goes_on = pthread_atfork(nullptr, nullptr, [] { exits = false; });

} // namespace

void stay()
{
    while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

void python_exits()
{
    exits_by = std::this_thread::get_id();
    exits = true;
}

bool is_exited() { return exits && exits_by != std::this_thread::get_id(); }

void Unlocked::take() noexcept
{
    if (is_exited()) stay();
    try {
        PyEval_RestoreThread(state_);
    } catch (abi::__forced_unwind&) { // Python ends this thread
        stay();
    }
    state_ = nullptr;
}

void call_progress(const pybind11::object& progress, double share, const char* what)
{
    PyObject* said = nullptr;
    try {
        said = PyObject_CallFunction(progress.ptr(), "ds", share, what);
    } catch (abi::__forced_unwind&) {
        stay();
    }
    if (!said) throw pybind11::error_already_set();
    Py_DECREF(said);
}

} // namespace hygroloom::python
