// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the first bytes of a file say: whether it is a recording, or the results of a study, and of which form.
#pragma once

#include <filesystem>

namespace hygroloom {

constexpr int recording_application = 0x4879676c; ///< "Hygl", as SQLite's application_id
constexpr int recording_version = 1;              ///< as its user_version

struct RecordingHead {
    enum class Is {
        recording,
        older_form, ///< HDF5, which versions before wrote
        other,
        empty
    } is = Is::other;
    int version = 0;
};
/// Precondition: no run of this process writes the file.
RecordingHead recording_head(const std::filesystem::path& path);

/// The files that stand beside a recording while it is written.
std::filesystem::path wal_of(const std::filesystem::path& recording);
std::filesystem::path shm_of(const std::filesystem::path& recording);

} // namespace hygroloom
