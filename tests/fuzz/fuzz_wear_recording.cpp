// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes, as the recording of a worn garment, either are refused with a FileError, or are summed up and drawn.
#include "core/base/error.h"
#include "tests/fuzz/as_file.h"
#include "tests/support/crafted_wear.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const std::string folder = (std::filesystem::temp_directory_path() / ("wear-map-" + std::to_string(::getpid()))).string();
    std::filesystem::create_directories(folder);
    try {
        hygroloom::use_wear_recording(hygroloom::as_file(data, size, "wear.hygrorec"), folder);
    } catch (const hygroloom::FileError&) {
        // said to the person
    }
    return 0;
}
