// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The names of temporary files, and those that a killed process left.
#pragma once

#include <filesystem>

namespace hygroloom {

/// Beside the target, hidden, with its extension and the number of this process; another one each time, at which nothing lies.
std::filesystem::path temporary_beside(const std::filesystem::path& target);

/// Removes what processes that are gone left beside the target while they wrote it. What was written within the last minute stays, since
/// its process may run on another machine.
void remove_leftovers(const std::filesystem::path& target);

} // namespace hygroloom
