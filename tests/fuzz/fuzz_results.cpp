// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes, as the table of a study in either form, either are refused with a FileError, or are a table that is written and read again.
#include "core/base/error.h"
#include "core/study/results.h"
#include "tests/fuzz/as_file.h"

using namespace hygroloom;

namespace {

std::string again(const std::string& text) { return format_results(parse_results(text, "written.csv")); }

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        const StudyTable table = bytes.starts_with("SQLite format 3") ? read_results_database(as_file(data, size, "study.sqlite"))
                                                                      : parse_results(bytes, "input.csv");
        const std::string once = again(format_results(table)); // words that are numbers are written as numbers from here on
        if (again(once) != once) std::abort();
    } catch (const FileError&) {
        // said to the person
    }
    return 0;
}
