// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether ThreadSanitizer finds a race in a stage, and nothing where there is none: thread_check race, thread_check none. See
// packaging/threads.sh.
#include "core/solver/cpu_executor.h"

#include <cstdio>
#include <string>

using namespace hygroloom;

namespace {

/// Each element its own; with a race also the next one's, which another thread may be writing.
struct Write {
    double* values;
    bool races;
    void operator()(int index) const
    {
        values[index] += 1;
        if (races) values[index + 1] += 1;
    }
};

} // namespace

int main(int count, char** values)
{
    const bool races = count > 1 && std::string(values[1]) == "race";
    CpuExecutor executor;
    executor.set_threads(4);
    constexpr int elements = 20'000;
    std::vector<double> numbers(elements + 1);
    for (int round = 0; round < 50; ++round) executor.for_each("write", elements, Write{numbers.data(), races});
    std::printf("%g\n", numbers[0]);
    return 0;
}
