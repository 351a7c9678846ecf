// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Ctrl-C and a polite kill cancel what a verb is doing; a second one ends the program at once.
#pragma once

#include <atomic>
#include <csignal>

namespace hygroloom {

inline std::atomic<bool>* cancel_flag = nullptr;

extern "C" inline void on_interrupt(int) { cancel_flag->store(true); }

/// While it lives. One at a time.
struct InterruptCancels {
    explicit InterruptCancels(std::atomic<bool>& cancel)
    {
        static_assert(std::atomic<bool>::is_always_lock_free);
        cancel_flag = &cancel;
        struct sigaction action {};
        action.sa_handler = on_interrupt;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(SIGINT, &action, nullptr);
        sigaction(SIGTERM, &action, nullptr);
    }
    ~InterruptCancels()
    {
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
    }
};

} // namespace hygroloom
