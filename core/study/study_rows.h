// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The rows of a study: which run each is, and what has become of it.
#pragma once

#include "core/base/free_memory.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hygroloom {

/// One run of a study.
struct StudyRun {
    std::size_t point = 0;
    int replicate = 0;
    std::size_t fabric = 0, experiment = 0; ///< places in fabrics_of() and experiments_of()
};

struct StudyOptions {
    bool resume = false;       ///< goes on in a folder that has rows; without it such a folder is refused
    bool retry_failed = false; ///< with resume: also runs the rows that failed
    int threads = 1;           ///< of each run on a CPU
    MemoryRule memory;         ///< of each run
    std::string name = {};     ///< of its runs, in lists
    int task = 1, tasks = 1;   ///< the slice of the rows: task 1 of 1 has all
};

/// A row that has ended.
struct StudyRowResult {
    std::size_t row = 0; ///< its place in the table
    bool failed = false;
    std::string reason;
    std::vector<double> metrics; ///< NaN where there is none
    double wall = 0;             ///< s
    std::string device;
};

} // namespace hygroloom
