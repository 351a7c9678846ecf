// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the program that reads files of strangers may take.
#pragma once

#include <algorithm>
#include <cstddef>

namespace hygroloom {

constexpr int most_reader_seconds = 20; ///< of a processor

/// Bytes of its memory: enough for a file of that size, however it is written, and at most 2 GB.
constexpr std::size_t most_reader_bytes(std::size_t file) { return std::min<std::size_t>(2'000'000'000, 300'000'000 + 100 * file); }

} // namespace hygroloom
