// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Tells ThreadSanitizer what it cannot see inside oneTBB, which distributions build without it: all tasks come after what was before their
// loop, and what follows the loop comes after them. Of two tasks none comes first, so races between them are found. Empty in other builds.
#pragma once

#ifndef __has_feature
#define __has_feature(feature) 0
#endif
#if defined(__SANITIZE_THREAD__) || __has_feature(thread_sanitizer)
#define HL_THREADS_ARE_CHECKED 1
#include <sanitizer/tsan_interface.h>
#else
#define HL_THREADS_ARE_CHECKED 0
#endif

namespace hygroloom {

#if HL_THREADS_ARE_CHECKED
/// Stands where a loop's caller waits for its tasks.
class ForkJoin {
public:
    ForkJoin() { __tsan_release(&forked_); }
    ~ForkJoin() { __tsan_acquire(&joined_); }
    ForkJoin(const ForkJoin&) = delete;
    ForkJoin& operator=(const ForkJoin&) = delete;

    /// Stands in a task.
    class Task {
    public:
        explicit Task(ForkJoin& loop) : loop_(loop) { __tsan_acquire(&loop.forked_); }
        ~Task() { __tsan_release(&loop_.joined_); }
        Task(const Task&) = delete;
        Task& operator=(const Task&) = delete;

    private:
        ForkJoin& loop_;
    };

private:
    char forked_ = 0, joined_ = 0;
};
#else
struct ForkJoin {
    ForkJoin() {}
    struct Task {
        explicit Task(ForkJoin&) {}
    };
};
#endif

} // namespace hygroloom
