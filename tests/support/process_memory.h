// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What memory a test takes.
#pragma once

#include <sys/resource.h>

namespace hygroloom {

/// Most that the process has held until now, bytes.
inline double peak_memory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss); // kB on Linux
}

} // namespace hygroloom
