// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Ctrl-C, a polite kill and a closed terminal (but under nohup) cancel what a verb is doing; a second one ends the program
// at once, as does the time of a verb that may not take long.
#pragma once

#include "core/run/unfinished.h"

#include <atomic>
#include <csignal>
#include <string>
#include <sys/time.h>
#include <unistd.h>

namespace hygroloom {

inline std::atomic<bool>* cancel_flag = nullptr;

/// What is said when a verb has no time to end by itself.
struct LastWords {
    std::string note;   ///< on stderr
    std::string result; ///< on stdout
};
/// None: the verb ends by itself, however long it takes.
inline std::atomic<const LastWords*> last_words = nullptr;
inline constexpr suseconds_t patience_us = 100'000;

extern "C" inline void on_interrupt(int)
{
    cancel_flag->store(true);
    constexpr itimerval once{{0, 0}, {0, patience_us}};
    if (last_words.load() != nullptr) setitimer(ITIMER_REAL, &once, nullptr);
}
extern "C" inline void on_patience_lost(int)
{
    const LastWords* words = last_words.load();
    if (words == nullptr) return; // it is ending by itself
    remove_unfinished();
    [[maybe_unused]] ssize_t written = write(STDERR_FILENO, words->note.data(), words->note.size());
    written = write(STDOUT_FILENO, words->result.data(), words->result.size());
    _exit(130);
}

/// While it lives. One at a time.
struct InterruptCancels {
    /// With last words, which may be changed meanwhile, the program ends 0.1 s later whatever it is doing. For verbs that write only
    /// recordings, which are whole at any moment.
    explicit InterruptCancels(std::atomic<bool>& cancel, const LastWords* words = nullptr)
    {
        static_assert(std::atomic<bool>::is_always_lock_free);
        cancel_flag = &cancel;
        last_words = words;
        if (words != nullptr) std::signal(SIGALRM, on_patience_lost);
        struct sigaction action {};
        action.sa_handler = on_interrupt;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(SIGINT, &action, nullptr);
        sigaction(SIGTERM, &action, nullptr);
        struct sigaction before {};
        sigaction(SIGHUP, nullptr, &before);
        minds_hangup_ = before.sa_handler != SIG_IGN;
        if (minds_hangup_) sigaction(SIGHUP, &action, nullptr);
    }
    ~InterruptCancels()
    {
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
        if (minds_hangup_) std::signal(SIGHUP, SIG_DFL);
        constexpr itimerval never{};
        setitimer(ITIMER_REAL, &never, nullptr);
        last_words = nullptr;
    }

private:
    bool minds_hangup_ = false;
};

} // namespace hygroloom
