// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The file that a recording is read from, also while a run writes it.
#pragma once

#include "core/run/hdf5_driver.h"
#include "core/run/redo_log.h"

#include <filesystem>

namespace hygroloom {

class RecordingSource : public hdf5::Storage {
public:
    /// Throws FileError without the file's name. At once, also for a pipe.
    explicit RecordingSource(const std::filesystem::path& path);
    ~RecordingSource() override;
    RecordingSource(const RecordingSource&) = delete;
    RecordingSource& operator=(const RecordingSource&) = delete;

    bool is_being_written() const { return is_being_written_; }
    /// Bytes of the file when it was opened.
    std::uint64_t size() const override { return size_; }
    bool begins_as_hdf5();
    /// From here on a run may change what leads to the frames. Frames and what was read stay.
    void release_index();

    bool read(std::uint64_t at, void* bytes, std::size_t count, hdf5::BlockKind kind) override;
    bool is_written() const override { return false; }
    bool write(std::uint64_t, const void*, std::size_t, bool) override { return false; }
    void resize(std::uint64_t) override {}

private:
    bool read_plain(std::uint64_t at, void* bytes, std::size_t count);

    int file_ = -1;
    std::uint64_t size_ = 0;
    bool is_being_written_ = false;
    Changes changes_; ///< that a run was about to make
    hdf5::BlockCheck check_;
};

} // namespace hygroloom
