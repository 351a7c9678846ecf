// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The file that a run writes: beside its target until it is worth the target's name, and at any moment what the last commit made of it.
#pragma once

#include "core/run/hdf5_driver.h"
#include "core/run/redo_log.h"

#include <chrono>
#include <filesystem>

namespace hygroloom {

/// What the library writes as data goes to the file, beyond all that is in use; metadata and small data wait for the commit. A run that is
/// killed, or has no room, leaves the file as the last commit made it.
class RecordingTarget : public hdf5::Storage {
public:
    /// Takes the name: throws FileError when another run writes there, or nothing can be written there. What is there stays.
    explicit RecordingTarget(const std::filesystem::path& path);
    /// Removes the file unless it got the target's name.
    ~RecordingTarget() override;
    RecordingTarget(const RecordingTarget&) = delete;
    RecordingTarget& operator=(const RecordingTarget&) = delete;

    enum class Commit { may_wait, now };
    /// Lets what was written take effect, all or nothing, and gives the file the target's name, if it may replace an older recording or
    /// there is none. While a reader looks for frames it may wait for the next time. Throws FileError; the file stays as it was and takes
    /// nothing more.
    /// Returns whether it did.
    bool commit(Commit when, bool may_replace);
    /// Whether a commit is worth its work: the file has not its name yet, or the last one was a while ago. A kill costs what came since.
    bool is_due() const;
    /// Whether the file has the target's name.
    bool in_place() const { return part_.empty(); }
    /// Why nothing more can be written; empty: it can.
    const std::string& failure() const { return failure_; }
    /// From here on what the library writes is dropped.
    void give_up(const std::string& why);
    /// To the disk.
    void sync();

    std::uint64_t size() const override { return end_; }
    bool read(std::uint64_t at, void* bytes, std::size_t count, hdf5::BlockKind kind) override;
    bool is_written() const override { return true; }
    bool write(std::uint64_t at, const void* bytes, std::size_t count, bool is_metadata) override;
    void resize(std::uint64_t size) override { end_ = size; }

private:
    void take_place();
    bool open_part();
    void check_target();
    void write_changes(const Changes& changes);
    void publish();

    std::filesystem::path given_, target_, part_; ///< as named; behind links; beside it, empty when renamed
    bool has_older_ = false;                      ///< the target is a recording with content
    int file_ = -1;
    std::uint64_t end_ = 0;       ///< of what was written
    std::uint64_t committed_ = 0; ///< end of the file as the last commit made it
    Changes staged_;
    std::string failure_;
    std::chrono::steady_clock::time_point last_commit_{};
};

} // namespace hygroloom
