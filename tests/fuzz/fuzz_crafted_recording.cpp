// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Bytes choose what is changed in a valid recording, object by object; the result is refused with a FileError or measured.
#include "tests/fuzz/read_recording.h"
#include "tests/support/crafted_recording.h"

#include <cstdlib>
#include <filesystem>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const std::string stem = (std::filesystem::temp_directory_path() / ("crafted-" + std::to_string(::getpid()))).string();
    static const std::string valid = stem + "-valid.hygrorec", crafted = stem + ".hygrorec";
    if (!std::filesystem::exists(valid)) hygroloom::write_small_recording(valid);
    std::filesystem::copy_file(valid, crafted, std::filesystem::copy_options::overwrite_existing);
    const std::string did = hygroloom::craft(crafted, {data, size});
    if (std::getenv("HYGROLOOM_SAY_CRAFT")) std::fprintf(stderr, "%s\n", did.c_str());
    hygroloom::read_recording(crafted);
    return 0;
}
