// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/recording_source.h"

#include "core/base/error.h"
#include "core/run/recording_head.h"
#include "core/run/writer_lock.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <sys/stat.h>

namespace hygroloom {
namespace {

/// Throws FileError where the file is none of this program.
void require_form(const std::filesystem::path& path)
{
    const RecordingHead head = recording_head(path);
    switch (head.is) {
    case RecordingHead::Is::empty: throw FileError("the file is empty.");
    case RecordingHead::Is::older_form: throw FileError("this was written by an older version of the program; run it again.");
    case RecordingHead::Is::other:
        if (path.extension() != ".hygro") throw FileError("this is not a Hygroloom recording.");
        throw FileError(fmt::format("this is a project, not a recording. Run it first: hygroloom-cli simulate {} -o {}.", path.string(),
                                    std::filesystem::path(path).replace_extension(".hygrorec").string()));
    case RecordingHead::Is::recording: break;
    }
    if (head.version > recording_version)
        throw FileError(
            fmt::format("this has version {}; this program reads up to {}. Use a newer program.", head.version, recording_version));
    if (head.version < 1) throw FileError(fmt::format("this has version {}, which there is not; it is damaged.", head.version));
}

} // namespace

/// At the file as it is now.
struct RecordingSource::Look {
    std::pair<std::uint64_t, std::uint64_t> file;
    std::uint64_t size;
    bool is_being_written;
    std::uint64_t size_beside;
};

RecordingSource::Look RecordingSource::look() const
{
    struct stat status {};
    if (::stat(path_.c_str(), &status) != 0)
        throw FileError(errno == ENOENT ? "there is no such file."
                                        : std::string("the file cannot be opened: ") + std::strerror(errno) + ".");
    if (S_ISDIR(status.st_mode)) throw FileError("this is a folder; give the name of a recording.");
    if (!S_ISREG(status.st_mode)) throw FileError("this is not a regular file.");
    Look now{{status.st_dev, status.st_ino}, static_cast<std::uint64_t>(status.st_size), hygroloom::is_being_written(path_), 0};
    std::error_code none;
    if (const auto beside = std::filesystem::file_size(wal_of(path_), none); !none) now.size_beside = beside;
    return now;
}

RecordingSource::RecordingSource(const std::filesystem::path& path) : path_(path)
{
    const Look now = look();
    file_ = now.file;
    is_being_written_ = now.is_being_written;
    size_ = now.size + now.size_beside;
    open();
}

std::shared_ptr<const Database> RecordingSource::open() const
{
    if (kept_) return kept_;
    constexpr int most_tries = 5; // while runs come and go
    for (int i = 0; i < most_tries; ++i) {
        const Look now = look();
        if (now.file != file_) throw FileError("another run has replaced this recording.");
        if (!now.is_being_written) require_form(path_);
        const auto access = now.is_being_written  ? Database::Access::beside_run
                            : now.size_beside > 0 ? Database::Access::left_over
                                                  : Database::Access::finished;
        auto opened = std::make_shared<const Database>(path_, access);
        Statement form = opened->statement("PRAGMA application_id"); // reads the file's first page
        if (!form.step() || form.whole(0) != recording_application) throw FileError("this is not a Hygroloom recording.");
        const Look after = look();
        if (after.is_being_written != now.is_being_written || after.file != now.file) continue;
        if (!now.is_being_written) kept_ = opened;
        return opened;
    }
    throw FileError("runs replace this recording all the time.");
}

} // namespace hygroloom
