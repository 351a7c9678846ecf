// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The pages of a database that SQLite keeps in the file NAME-wal until a checkpoint brings them into the database.
#pragma once

#include <cstdint>
#include <filesystem>

namespace hygroloom {

/// Writes those pages behind the database's end that it does not have yet, so that a checkpoint that is cut off, whose pages come in the
/// order of their numbers, lets none lead to what is not there. size: pages that the database had. False where they cannot be written.
/// Precondition: no transaction is on; the open file is the database.
bool write_new_pages(const std::filesystem::path& wal, int database, std::uint32_t size);

} // namespace hygroloom
