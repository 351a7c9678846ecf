// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How much memory this process may still take, and whether what is to begin fits into it.
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <limits>
#include <string>

namespace hygroloom {

struct FreeMemory {
    double bytes = std::numeric_limits<double>::infinity(); ///< infinity: nothing says it
    std::string bound;                                      ///< of what it is free: "on this machine", "under the limit ..."
};

/// The least of what the machine has available, of what the control groups of this process (v1 and v2, with all above them) allow beside
/// their use, and of what the limits on address space and data of this process leave. Pages of files count as free: the kernel gives them
/// back. root: where proc and sys lie; tests have their own.
FreeMemory free_memory(const std::filesystem::path& root = "/");

/// Whether to begin what does not fit, and what the sentence says can be done else.
struct MemoryRule {
    bool force = false;
    std::string else_do = "Take a smaller sample or a lower fidelity.";
};

/// Something that was to begin would take more memory than is free. what() has both numbers and how to go on.
struct NotEnoughMemory : Error {
    NotEnoughMemory(const std::string& sentence, double bytes_needed, double bytes_free)
        : Error(sentence), needed(bytes_needed), available(bytes_free)
    {
    }
    double needed, available;
};

constexpr double much_of_memory = 0.7; ///< of what is free: from here on a sentence warns

/// To be asked before memory is taken. what: the subject of the sentence, as "This run". Returns a warning from much_of_memory on, empty
/// below it. Throws NotEnoughMemory. With force nothing is asked.
std::string ask_for_memory(const std::string& what, double bytes, const MemoryRule& rule, const FreeMemory& free = free_memory());

/// How many of the wanted jobs (at least one) fit beside each other without that warning, one at least.
int jobs_that_fit(int wanted, double bytes_each, const FreeMemory& free = free_memory());

} // namespace hygroloom
