// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The files that this process has begun beside its recordings' targets and not yet put in place, where the handler of a signal may read
// them.
#pragma once

#include <array>
#include <atomic>
#include <unistd.h>

namespace hygroloom {

/// Of more, the last are left to the next run to their target.
inline std::array<std::atomic<const char*>, 64> unfinished_recordings;

/// The path stays where it is until it is forgotten.
inline void note_unfinished(const char* path)
{
    for (std::atomic<const char*>& place : unfinished_recordings)
        if (const char* empty = nullptr; place.compare_exchange_strong(empty, path)) return;
}
inline void forget_unfinished(const char* path)
{
    for (std::atomic<const char*>& place : unfinished_recordings)
        if (const char* own = path; place.compare_exchange_strong(own, nullptr)) return;
}
/// For a handler that ends the process.
inline void remove_unfinished() noexcept
{
    for (const std::atomic<const char*>& place : unfinished_recordings)
        if (const char* path = place.load()) ::unlink(path);
}

} // namespace hygroloom
