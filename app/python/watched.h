// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Long work for Python: it goes on in a thread of its own without Python's lock, while the caller's thread looks for Ctrl-C and tells the
// progress.
#pragma once

#include "core/run/run_options.h"

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>

namespace hygroloom::python {

namespace py = pybind11;

/// What the work may use while it goes on.
struct Watch {
    RunControl control;
    /// From any thread; the caller's tells the newest on. share: 0 to 1.
    std::function<void(double share, const std::string& what)> tell;
};

/// Calls act() in a thread. progress: None, or called with a share and a sentence. Throws what act() throws; KeyboardInterrupt and what
/// progress raises once act() has ended, for which it is asked at once, or 0.15 s later: it then ends by itself. act() must therefore hold
/// all that it uses, and nothing of Python. Precondition: the caller has Python's lock.
void watch(const py::object& progress, std::function<void(Watch&)> act);

/// The same with a result.
template <typename Act> auto watched(const py::object& progress, Act act)
{
    const auto result = std::make_shared<std::optional<decltype(act(std::declval<Watch&>()))>>();
    watch(progress, [result, act](Watch& all) { result->emplace(act(all)); });
    return std::move(**result);
}

/// Before Python exits: all work is asked to end, and is waited for up to 0.3 s. Threads that wait for work stay where they are. Work that
/// goes on even then ends with the process, which leaves out destructors.
void end_all_work();

} // namespace hygroloom::python
