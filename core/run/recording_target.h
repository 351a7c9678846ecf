// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The file that a run writes: beside its target until it is worth the target's name, and at any moment what the last commit made of it.
#pragma once

#include "core/run/database.h"

#include <chrono>
#include <filesystem>
#include <optional>

namespace hygroloom {

/// Beside the target it is a plain file that nobody reads. Under its name frames go into a second file first, NAME-wal, which is brought in
/// every two seconds: whoever reads, or finds what a kill left, sees whole commits.
class RecordingTarget {
public:
    /// Takes the name: throws FileError when another run writes there, or nothing can be written there. What is there stays.
    explicit RecordingTarget(const std::filesystem::path& path);
    /// Removes the file unless it got the target's name.
    ~RecordingTarget();
    RecordingTarget(const RecordingTarget&) = delete;
    RecordingTarget& operator=(const RecordingTarget&) = delete;

    /// Within a transaction. A commit may replace it by another: no statement of it may live on.
    const Database& open();
    /// Lets what was written take effect, all or nothing, and gives the file the target's name, if it may replace an older recording or
    /// there is none. Throws FileError.
    void commit(bool may_replace);
    /// Whether a commit is worth its work: the file has not its name yet, or the last one was a while ago. A kill costs what came since.
    bool is_due() const;
    /// Whether the file has the target's name.
    bool in_place() const { return part_.empty(); }
    /// After a commit: one file, closed; with to_disk it is on the disk. Throws FileError.
    void close(bool to_disk);
    /// What was not committed is dropped; nothing more can be written.
    void give_up();

private:
    void take_place();
    bool open_part();
    void check_target();
    void publish();
    bool may_checkpoint();
    void sync() const;

    std::filesystem::path given_, target_, part_; ///< as named; behind links; beside it, empty when renamed
    bool has_older_ = false;                      ///< the target is a recording with content
    int file_ = -1;                               ///< holds the writer's lock
    std::optional<Database> database_;
    bool in_transaction_ = false;
    std::uint32_t pages_ = 0; ///< of the file, without what stands beside it
    std::chrono::steady_clock::time_point last_commit_{}, last_checkpoint_{};
};

/// What a killed run left beside its recording goes into it, so that it can be linked, copied and moved as one file. Does nothing where
/// there is nothing left, or it cannot be done.
void bring_in_left_over(const std::filesystem::path& recording);

} // namespace hygroloom
