// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Work in a process of its own: its memory is measured apart, and when it is killed this process goes on.
#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace hygroloom {

/// What the work returned, and what its process took.
struct ApartResult {
    std::string text;
    double peak_bytes = 0; ///< largest resident set
};

/// Takes a function to report progress with, a share of 0 to 1. Returns one line of text.
using ApartWork = std::function<std::string(const std::function<void(double)>&)>;

/// Forks and runs the work there; progress is called here with what it reports. When cancel becomes true the process gets SIGTERM.
/// Throws Cancelled when it was cancelled, DeviceError and Error as the work did, Error when the process was killed; name is what the
/// sentence calls the work. Precondition: this process has started no thread yet.
ApartResult run_apart(const std::string& name, const ApartWork& work, const std::atomic<bool>& cancel,
                      const std::function<void(double)>& progress);

} // namespace hygroloom
