// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/recording_target.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/run/recording_head.h"
#include "core/run/run_tables.h"
#include "core/run/unfinished.h"
#include "core/run/wal_pages.h"
#include "core/run/writer_lock.h"

#include <fmt/format.h>

#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hygroloom {
namespace {

constexpr std::chrono::milliseconds between{200}; ///< commits
constexpr std::chrono::seconds between_checkpoints{2};

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

void bring_in_left_over(const std::filesystem::path& recording)
{
    std::error_code none;
    if (std::filesystem::file_size(wal_of(recording), none) == 0 || none || is_being_written(recording)) return;
    if (recording_head(recording).is != RecordingHead::Is::recording) return;
    try {
        Database(recording, Database::Access::write).become_one_file();
    } catch (const FileError&) {
        // it stays as it is
    }
}

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
            forget_written_here(file_);
            ::close(file_);
        }
        throw;
    }
}

RecordingTarget::~RecordingTarget()
{
    database_.reset();
    forget_unfinished(part_.c_str());
    if (!part_.empty() && is_at(file_, part_)) ::unlink(part_.c_str());
    forget_written_here(file_);
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
    if (!lock_as_writer(file)) {
        ::close(file);
        throw FileError(given_.string() + ": another run is writing this recording. Wait for its end or choose another name.");
    }
    if (!is_at(file, part_)) {
        ::close(file);
        return false;
    }
    file_ = file;
    note_written_here(file_);
    return true;
}

void RecordingTarget::check_target()
{
    struct stat status {};
    if (::stat(target_.c_str(), &status) != 0 && errno == ENOENT) return;
    const bool is_file = S_ISREG(status.st_mode);
    if (is_file && is_being_written(target_))
        throw FileError(given_.string() + ": another run is writing this recording. Wait for its end or choose another name.");
    if (is_file && status.st_size > 0 && recording_head(target_).is == RecordingHead::Is::other)
        throw FileError(given_.string() +
                        ": there is a file of this name already and it is no recording. Choose another name for the recording.");
    has_older_ = is_file && status.st_size > 0;
    if (!is_file || ::access(target_.c_str(), W_OK) != 0)
        throw FileError(given_.string() + ": the recording cannot be created: what has this name cannot be replaced.");
    ::fchmod(file_, status.st_mode & 07777);
}

const Database& RecordingTarget::open()
{
    if (!database_ && in_place()) database_.emplace(target_, Database::Access::write);
    if (!database_) {
        database_.emplace(part_, Database::Access::create);
        mark_as_recording(*database_);
    }
    if (!in_transaction_) database_->run("BEGIN IMMEDIATE");
    in_transaction_ = true;
    return *database_;
}

bool RecordingTarget::is_due() const { return !in_place() || std::chrono::steady_clock::now() - last_commit_ >= between; }

void RecordingTarget::commit(bool may_replace)
{
    open().run("COMMIT");
    in_transaction_ = false;
    last_commit_ = std::chrono::steady_clock::now();
    if (!in_place()) {
        if (may_replace || !has_older_) publish();
    } else if (last_commit_ - last_checkpoint_ >= between_checkpoints) {
        if (may_checkpoint()) database_->checkpoint();
        last_checkpoint_ = last_commit_;
    }
}

/// What a killed run left beside the older recording is not the new one's. Opened anew, SQLite names what stands beside it by the target.
void RecordingTarget::publish()
{
    pages_ = database_->pages();
    database_.reset();
    sync();
    ::unlink(wal_of(target_).c_str());
    ::unlink(shm_of(target_).c_str());
    if (::rename(part_.c_str(), target_.c_str()) != 0)
        throw FileError(std::string("the recording cannot be put in place: ") + std::strerror(errno));
    forget_unfinished(part_.c_str());
    part_.clear();
    last_checkpoint_ = last_commit_;
}

/// New pages first: whoever gets the file alone after a kill finds what the others lead to.
bool RecordingTarget::may_checkpoint()
{
    if (!write_new_pages(wal_of(target_), file_, pages_)) return false;
    pages_ = database_->pages();
    return true;
}

/// A run that is cancelled ends within a moment; of one that ends well everything is on the disk before the file beside it goes.
void RecordingTarget::close(bool to_disk)
{
    if (!in_place()) return;
    if (database_) {
        if (may_checkpoint()) database_->checkpoint();
        if (to_disk) sync();
        database_->become_one_file();
    }
    database_.reset();
    if (to_disk) sync();
}

void RecordingTarget::give_up()
{
    database_.reset();
    in_transaction_ = false;
}

void RecordingTarget::sync() const
{
    if (::fsync(file_) != 0 && errno != EINVAL && errno != EROFS)
        throw FileError(errno == ENOSPC || errno == EDQUOT ? "the disk is full"
                                                           : std::string("it cannot be written: ") + std::strerror(errno));
}

} // namespace hygroloom
