// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Any bytes, as a lesson, either are refused with a FileError, or become one whose cloths can lie on the table and whose goals can be
// asked.
#include "core/base/error.h"
#include "core/lesson/lesson.h"
#include "tests/fuzz/require.h"

using namespace hygroloom;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const Lesson lesson = parse_lesson({reinterpret_cast<const char*>(data), size}, "input.json");
        TableState state;
        state.cloths.resize(lesson.cloths.size());
        require(lesson.cloths.size() >= fewest_lesson_cloths && lesson.cloths.size() <= most_lesson_cloths, "there are cloths");
        for (const LessonCloth& cloth : lesson.cloths) require(why_not_on_table(cloth.design).empty(), "cloths can lie on the table");
        for (const LessonStep& step : lesson.steps)
            if (step.seen) is_seen(*step.seen, state);
    } catch (const FileError&) {
    }
    return 0;
}
