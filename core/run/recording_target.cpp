// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/recording_target.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/run/byte_lock.h"
#include "core/run/unfinished.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace hygroloom {
namespace {

constexpr std::chrono::milliseconds patience{20}; ///< with readers, before a commit is put off
constexpr std::chrono::seconds longest_wait{2};   ///< of a commit, for readers
constexpr std::chrono::milliseconds between{200}; ///< commits
constexpr std::size_t small = 4096;               ///< bytes of data that wait, too: of them there are many

/// An error number, or 0.
int write_all(int file, std::uint64_t at, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written < 0 ? errno : ENOSPC;
        at += static_cast<std::uint64_t>(written);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

std::string reason(int code)
{
    return code == ENOSPC || code == EDQUOT ? "the disk is full" : std::string("it cannot be written: ") + std::strerror(code);
}

/// What to do where a recording cannot be created.
const char* advice(int code)
{
    if (code == ENAMETOOLONG) return " Six letters more are needed while it is written; choose a shorter name.";
    if (code == EMFILE || code == ENFILE) return " Too many files are open; allow more (ulimit -n).";
    return " Check that the folder exists and can be written to.";
}

/// Whether the path still names the open file.
bool is_at(int file, const std::filesystem::path& path)
{
    struct stat open {
    }, named{};
    return ::fstat(file, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

} // namespace

RecordingTarget::RecordingTarget(const std::filesystem::path& path) : given_(path), target_(behind_links(path))
{
    part_ = target_;
    part_.replace_filename(fmt::format(".{}.part", target_.filename().string()));
    try {
        take_place();
        check_target();
        note_unfinished(part_.c_str());
    } catch (...) {
        if (file_ >= 0) {
            ::unlink(part_.c_str());
            ::close(file_);
        }
        throw;
    }
}

RecordingTarget::~RecordingTarget()
{
    forget_unfinished(part_.c_str());
    if (!part_.empty() && is_at(file_, part_)) ::unlink(part_.c_str());
    ::close(file_);
}

/// A file that a killed run left there is taken over. One that got its target's name before it was locked is not.
void RecordingTarget::take_place()
{
    while (!open_part()) continue;
    if (::ftruncate(file_, 0) != 0) throw FileError(given_.string() + ": the recording cannot be written: " + std::strerror(errno) + ".");
}

bool RecordingTarget::open_part()
{
    const int file = ::open(part_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (file < 0) throw FileError(given_.string() + ": the recording cannot be created: " + std::strerror(errno) + "." + advice(errno));
    if (!try_lock(file, LockedByte::writer, false)) {
        ::close(file);
        throw FileError(given_.string() + ": another run is writing this recording. Wait for its end or choose another name.");
    }
    if (!is_at(file, part_)) {
        ::close(file);
        return false;
    }
    file_ = file;
    return true;
}

void RecordingTarget::check_target()
{
    const int old = ::open(target_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (old < 0 && errno == ENOENT) return;
    std::string begin(8, '\0');
    struct stat status {};
    const bool is_file = old >= 0 && ::fstat(old, &status) == 0 && S_ISREG(status.st_mode);
    const bool is_written = is_file && is_locked(old, LockedByte::writer);
    const bool is_other =
        is_file && status.st_size > 0 && (::pread(old, begin.data(), begin.size(), 0) != 8 || begin != "\x89HDF\r\n\x1a\n");
    if (old >= 0) ::close(old);
    if (is_written) throw FileError(given_.string() + ": another run is writing this recording. Wait for its end or choose another name.");
    if (is_other)
        throw FileError(given_.string() +
                        ": there is a file of this name already and it is no recording. Choose another name for the recording.");
    has_older_ = is_file && status.st_size > 0;
    if (!is_file || ::access(target_.c_str(), W_OK) != 0)
        throw FileError(given_.string() + ": the recording cannot be created: what has this name cannot be replaced.");
    ::fchmod(file_, status.st_mode & 07777);
}

bool RecordingTarget::read(std::uint64_t at, void* bytes, std::size_t count, hdf5::BlockKind)
{
    std::memset(bytes, 0, count); // what was never written
    for (std::size_t done = 0; done < count;) {
        const ssize_t got = ::pread(file_, static_cast<char*>(bytes) + done, count - done, static_cast<off_t>(at + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return false;
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    apply(staged_, at, static_cast<char*>(bytes), count);
    return true;
}

bool RecordingTarget::write(std::uint64_t at, const void* bytes, std::size_t count, bool is_metadata)
{
    if (!failure_.empty()) return true;
    const std::string_view given(static_cast<const char*>(bytes), count);
    end_ = std::max(end_, at + count);
    if (is_metadata || count <= small || touches(staged_, at, count)) {
        stage(staged_, at, given);
        return true;
    }
    if (const int code = write_all(file_, at, given); code != 0) {
        give_up(reason(code));
        return false;
    }
    return true;
}

void RecordingTarget::give_up(const std::string& why)
{
    failure_ = why;
    staged_.clear();
    if (::ftruncate(file_, static_cast<off_t>(committed_)) != 0) return; // what lies behind is not read
}

bool RecordingTarget::is_due() const { return !in_place() || std::chrono::steady_clock::now() - last_commit_ >= between; }

bool RecordingTarget::commit(Commit when, bool may_replace)
{
    if (!failure_.empty()) throw FileError(failure_);
    const auto now = std::chrono::steady_clock::now();
    const bool may_wait = when == Commit::may_wait && part_.empty() && now - last_commit_ < longest_wait;
    while (!try_lock(file_, LockedByte::index, false)) {
        const auto waited = std::chrono::steady_clock::now() - now;
        if (may_wait && waited > patience) return false;
        if (waited > longest_wait) break; // a reader that was halted
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    try {
        write_changes(staged_);
    } catch (...) {
        unlock(file_, LockedByte::index);
        throw;
    }
    unlock(file_, LockedByte::index);
    committed_ = end_;
    staged_.clear();
    last_commit_ = now;
    if (!part_.empty() && (may_replace || !has_older_)) publish();
    return true;
}

/// First all that changes nothing that is in use, then, when that and the log of the rest stand in the file, the rest.
void RecordingTarget::write_changes(const Changes& changes)
{
    Changes rest;
    const auto keep = [&](int code) {
        if (code == 0) return;
        give_up(reason(code));
        throw FileError(failure_);
    };
    std::uint64_t begin = 0;
    std::string run; // of changes that follow each other, written at once
    const auto write_run = [&] { keep(write_all(file_, begin, std::exchange(run, {}))); };
    for (const auto& [at, bytes] : changes) {
        if (at < committed_) {
            rest.emplace(at, bytes);
            continue;
        }
        if (at != begin + run.size()) write_run();
        if (run.empty()) begin = at;
        run += bytes;
    }
    write_run();
    if (!rest.empty()) {
        const auto& [last, bytes] = *rest.rbegin();
        keep(write_all(file_, std::max({end_, committed_, last + bytes.size()}), redo_log(rest)));
    }
    for (const auto& [at, bytes] : rest) {
        const int code = write_all(file_, at, bytes);
        if (code == 0) continue;
        failure_ = reason(code); // the log stays, so that a reader makes the changes
        throw FileError(failure_);
    }
    keep(::ftruncate(file_, static_cast<off_t>(end_)) == 0 ? 0 : errno);
}

void RecordingTarget::publish()
{
    sync();
    if (::rename(part_.c_str(), target_.c_str()) != 0)
        throw FileError(std::string("the recording cannot be put in place: ") + std::strerror(errno));
    forget_unfinished(part_.c_str());
    part_.clear();
}

void RecordingTarget::sync()
{
    if (::fsync(file_) != 0 && errno != EINVAL && errno != EROFS) {
        give_up(reason(errno));
        throw FileError(failure_);
    }
}

} // namespace hygroloom
