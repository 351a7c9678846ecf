// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Python's lock, given back for long work and taken again; and what becomes of threads that want it when Python has begun to exit.
#pragma once

#include <pybind11/pybind11.h>

namespace hygroloom::python {

/// Python's lock is free while this lives, and taken again after it. A daemon thread that wants it back when Python exits stays here until
/// the process has ended: Python up to 3.13 would end it in the midst of C++, which aborts. Precondition: the caller has Python's lock.
class Unlocked {
public:
    Unlocked() : state_(PyEval_SaveThread()) {}
    ~Unlocked()
    {
        if (state_) take();
    }
    Unlocked(const Unlocked&) = delete;
    Unlocked& operator=(const Unlocked&) = delete;

    void take() noexcept;
    void give() { state_ = PyEval_SaveThread(); }

private:
    PyThreadState* state_; ///< nullptr: the lock is taken
};

/// progress(share, what) under Python's lock, with the same end for a daemon thread. Throws what it raises.
void call_progress(const pybind11::object& progress, double share, const char* what);

/// From now on threads other than the caller's stay where they want the lock back.
void python_exits();
/// Whether Python exits, and another thread than the caller's sees to it.
bool is_exited();
/// Waits for the end of the process.
[[noreturn]] void stay();

} // namespace hygroloom::python
