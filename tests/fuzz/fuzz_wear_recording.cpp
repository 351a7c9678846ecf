// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes, as the recording of a worn garment, either are refused with a FileError, or are summed up and drawn.
#include "core/base/error.h"
#include "tests/support/crafted_wear.h"

#include <cstdlib>
#include <filesystem>
#include <sys/mman.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const std::string folder = (std::filesystem::temp_directory_path() / ("wear-map-" + std::to_string(::getpid()))).string();
    std::filesystem::create_directories(folder);
    const int file = ::memfd_create("recording", MFD_CLOEXEC);
    if (file < 0 || ::write(file, data, size) != static_cast<ssize_t>(size)) std::abort();
    try {
        hygroloom::use_wear_recording("/proc/self/fd/" + std::to_string(file), folder);
    } catch (const hygroloom::FileError&) {
        // said to the person
    }
    ::close(file);
    return 0;
}
