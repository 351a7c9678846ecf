// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What writing and reading a recording agree on. Frames are written whole before the ledger's row that counts them.
#pragma once

#include <fmt/format.h>

#include <string>

namespace hygroloom {

constexpr int recording_version = 1;
constexpr const char* recording_format = "hygroloom-recording";

inline std::string frame_name(int index) { return fmt::format("{:06d}", index); }

} // namespace hygroloom
