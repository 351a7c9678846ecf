// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes, as a recording, either are refused with a FileError, or are measured.
#include "tests/fuzz/read_recording.h"

#include <cstdint>
#include <cstdlib>
#include <sys/mman.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const int file = ::memfd_create("recording", MFD_CLOEXEC);
    if (file < 0 || ::write(file, data, size) != static_cast<ssize_t>(size)) std::abort();
    hygroloom::read_recording("/proc/self/fd/" + std::to_string(file));
    ::close(file);
    return 0;
}
