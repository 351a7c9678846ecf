// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/recording_source.h"

#include "core/base/error.h"
#include "core/run/byte_lock.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace hygroloom {
namespace {

bool read_all(int file, std::uint64_t at, char* bytes, std::size_t count)
{
    while (count > 0) {
        const ssize_t got = ::pread(file, bytes, count, static_cast<off_t>(at));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += static_cast<std::uint64_t>(got);
        bytes += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

/// A run holds the index for a millisecond at a time; one that was halted while it did is not waited for.
void share_index(int file)
{
    for (int i = 0; i < 200 && !try_lock(file, LockedByte::index, true); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

} // namespace

RecordingSource::RecordingSource(const std::filesystem::path& path) : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))
{
    if (file_ < 0)
        throw FileError(errno == ENOENT ? "there is no such file."
                                        : std::string("the file cannot be opened: ") + std::strerror(errno) + ".");
    struct stat status {};
    const bool known = ::fstat(file_, &status) == 0;
    if (!known || !S_ISREG(status.st_mode)) {
        ::close(file_);
        throw FileError(known && S_ISDIR(status.st_mode) ? "this is a folder; give the name of a recording."
                                                         : "this is not a regular file.");
    }
    is_being_written_ = is_locked(file_, LockedByte::writer);
    if (is_being_written_) share_index(file_);
    size_ = ::fstat(file_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
    check_ = {[this](std::uint64_t at, void* bytes, std::size_t count) { return read_plain(at, bytes, count); }, size_};
    std::string end(std::min<std::uint64_t>(size_, log_foot_bytes), '\0');
    if (!read_all(file_, size_ - end.size(), end.data(), end.size())) return;
    const std::uint64_t length = length_of_log(end);
    if (length == 0 || length > size_) return;
    end.resize(length);
    if (read_all(file_, size_ - length, end.data(), length)) changes_ = changes_in_log(end, size_);
}

RecordingSource::~RecordingSource() { ::close(file_); }

bool RecordingSource::begins_as_hdf5()
{
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    std::string begin(signature.size(), '\0');
    return read_plain(0, begin.data(), begin.size()) && begin == signature;
}

void RecordingSource::release_index() { unlock(file_, LockedByte::index); }

bool RecordingSource::read(std::uint64_t at, void* bytes, std::size_t count, hdf5::BlockKind kind)
{
    return check_.allows(at, count, kind) && read_plain(at, bytes, count);
}

bool RecordingSource::read_plain(std::uint64_t at, void* bytes, std::size_t count)
{
    if (at > size_ || count > size_ - at) return false;
    if (!read_all(file_, at, static_cast<char*>(bytes), count)) return false;
    apply(changes_, at, static_cast<char*>(bytes), count);
    return true;
}

} // namespace hygroloom
