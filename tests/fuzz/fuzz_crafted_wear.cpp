// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Bytes choose what is changed in the valid recording of a worn garment, object by object; the result is refused with a FileError, or
// summed up and drawn.
#include "core/base/error.h"
#include "tests/support/crafted_wear.h"

#include <cstdlib>
#include <filesystem>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const std::string stem = (std::filesystem::temp_directory_path() / ("crafted-wear-" + std::to_string(::getpid()))).string();
    static const std::string valid = stem + "-valid.hygrorec", crafted = stem + ".hygrorec", folder = stem + "-map";
    if (!std::filesystem::exists(valid)) {
        hygroloom::write_small_wear_recording(valid);
        std::filesystem::create_directories(folder);
    }
    std::filesystem::copy_file(valid, crafted, std::filesystem::copy_options::overwrite_existing);
    const std::string did = hygroloom::craft(crafted, {data, size}, hygroloom::targets_of_a_garment());
    if (std::getenv("HYGROLOOM_SAY_CRAFT")) std::fprintf(stderr, "%s\n", did.c_str());
    try {
        const bool draws = size == 0 || data[size - 1] % 16 == 0; // takes most of the time
        hygroloom::use_wear_recording(crafted, draws ? folder : std::string());
    } catch (const hygroloom::FileError&) {
        // said to the person
    }
    return 0;
}
