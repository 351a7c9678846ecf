// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes, as a recording, either are refused with a FileError, or are measured.
#include "tests/fuzz/as_file.h"
#include "tests/fuzz/read_recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    hygroloom::read_recording(hygroloom::as_file(data, size, "bytes.hygrorec"));
    return 0;
}
