// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Locks on single bytes of a recording, of the open file and not of the process: they end with it, and no other library asks for them.
#pragma once

#include <cerrno>
#include <fcntl.h>

namespace hygroloom {

/// writer: while a run writes the recording. index: while what leads to the frames changes (exclusive) or is read (shared).
enum class LockedByte : off_t { writer = 0, index = 1 };

namespace detail {

inline struct flock one_byte(LockedByte byte, short type)
{
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = static_cast<off_t>(byte);
    lock.l_len = 1;
    return lock;
}

} // namespace detail

/// Does not wait. False when another open file has it; where the file system has no locks, true.
inline bool try_lock(int file, LockedByte byte, bool shared)
{
    struct flock lock = detail::one_byte(byte, shared ? F_RDLCK : F_WRLCK);
    return ::fcntl(file, F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES);
}

inline void unlock(int file, LockedByte byte)
{
    struct flock lock = detail::one_byte(byte, F_UNLCK);
    ::fcntl(file, F_OFD_SETLK, &lock);
}

/// Whether another open file has it exclusively.
inline bool is_locked(int file, LockedByte byte)
{
    struct flock lock = detail::one_byte(byte, F_RDLCK);
    return ::fcntl(file, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

} // namespace hygroloom
