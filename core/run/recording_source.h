// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The file that a recording is read from, also while a run writes it.
#pragma once

#include "core/run/database.h"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace hygroloom {

class RecordingSource {
public:
    /// Throws FileError without the file's name: it cannot be opened, or is none of this program. At once, also for a pipe.
    explicit RecordingSource(const std::filesystem::path& path);

    bool is_being_written() const { return is_being_written_; } ///< when it was opened
    std::uint64_t size() const { return size_; }                ///< bytes, with what a killed run left beside it
    /// To be let go of soon: while a run writes the file, one that is kept holds its end up. Throws FileError.
    std::shared_ptr<const Database> open() const;

private:
    struct Look;
    Look look() const;

    std::filesystem::path path_;
    std::pair<std::uint64_t, std::uint64_t> file_{}; ///< device and number
    bool is_being_written_ = false;
    std::uint64_t size_ = 0;
    mutable std::shared_ptr<const Database> kept_; ///< of a file that nobody writes any more
};

} // namespace hygroloom
