// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the program that reads files of strangers may take.
#pragma once

#include <cstddef>

namespace hygroloom {

constexpr std::size_t most_reader_bytes = 2'000'000'000; ///< of its memory
constexpr int most_reader_seconds = 20;                  ///< of a processor

} // namespace hygroloom
