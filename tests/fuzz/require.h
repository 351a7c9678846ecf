// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What has to hold of whatever was read.
#pragma once

#include <cstdio>
#include <cstdlib>

/// Ends the process, which the fuzzer reports, where it does not hold.
inline void require(bool holds, const char* what)
{
    if (holds) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}
