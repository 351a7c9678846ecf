// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Takes from this process what reading a stranger's file does not need.
#pragma once

#include <cstddef>

namespace hygroloom {

/// Limits memory (bytes), processor time, written files and core dumps, gives up new privileges, and ends with the process that started
/// this one.
void limit_resources(std::size_t memory);

/// From here on the kernel refuses all calls but those for memory, for files that are open already, and for ending; where it has no such
/// filter, or not for this kind of processor, nothing changes.
void refuse_calls();

} // namespace hygroloom
