// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Changes to a file that stand at its end until all of them are made: a reader makes them again, so that it sees all or none.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace hygroloom {

/// Bytes by their place in the file.
using Changes = std::map<std::uint64_t, std::string>;

/// Puts bytes over what is staged. No two entries overlap before or after, and none is empty.
void stage(Changes& changes, std::uint64_t at, std::string_view bytes);
/// Whether some of it is staged.
bool touches(const Changes& changes, std::uint64_t at, std::size_t count);
/// Over bytes that were read from a place in the file.
void apply(const Changes& changes, std::uint64_t at, char* bytes, std::size_t count);

/// To be written behind all that it changes.
std::string redo_log(const Changes& changes);
/// Of a file that ends in a whole log, whose changes are in order and lie before it; none otherwise.
Changes changes_in_log(std::string_view end_of_file, std::uint64_t file_size);

/// The log's last bytes; they say how long it is. 0: these end no log.
constexpr std::size_t log_foot_bytes = 32;
std::uint64_t length_of_log(std::string_view foot);

} // namespace hygroloom
