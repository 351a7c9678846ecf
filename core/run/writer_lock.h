// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The lock by which a writer has a file to itself: on its first byte, which SQLite does not lock, of the open file and not of the process.
#pragma once

#include <filesystem>

namespace hygroloom {

/// Until the open file is closed. False when another has it; where the file system has no locks, true.
bool lock_as_writer(int file);

/// Files that this process writes. It must not open and close them otherwise: the locks that SQLite has on them would end.
void note_written_here(int file);
void forget_written_here(int file);

/// Whether a run writes the file. Precondition: the path names a regular file, or none.
bool is_being_written(const std::filesystem::path& path);

} // namespace hygroloom
