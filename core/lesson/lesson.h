// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A lesson as a file: which cloths lie on the table, what is said and asked step by step, and what counts as seen.
#pragma once

#include "core/lesson/lesson_goal.h"

#include <filesystem>
#include <string_view>

namespace hygroloom {

/// One cloth on the table.
struct LessonCloth {
    std::string title;
    Design design; ///< one fabric, no experiments
    bool operator==(const LessonCloth&) const = default;
};

struct LessonStep {
    std::string text;
    std::string ask;                ///< what to do; may be empty
    std::optional<LessonGoal> seen; ///< none: the class says when to go on
    bool operator==(const LessonStep&) const = default;
};

struct Lesson {
    std::string title;
    Climate air{25, 0.65, 0.1};
    double drop_ul = 5;
    std::vector<LessonCloth> cloths;
    std::vector<LessonStep> steps;
    bool operator==(const Lesson&) const = default;
};

constexpr double lesson_cloth_mm = 40; ///< side of each cloth
constexpr std::size_t fewest_lesson_cloths = 2, most_lesson_cloths = 4, most_lesson_steps = 50;
constexpr std::size_t largest_lesson_bytes = std::size_t{1} << 20U;
constexpr int most_lesson_crossings = 60000; ///< of one cloth, so that it can be simulated while one looks
constexpr double least_drop_ul = 0.5, most_drop_ul = 20;

/// Reads and checks a lesson, its fabrics too. Throws FileError: file, field, what is allowed, what was given.
Lesson read_lesson(const std::filesystem::path& path);
/// The same from text; name stands for the file in messages.
Lesson parse_lesson(std::string_view text, const std::string& name);

/// Why a design's only fabric cannot lie on the table, in a sentence; empty: it can.
std::string why_not_on_table(const Design& design);
/// The experiment that a cloth on the table is: drops on all of it, none so far.
Experiment table_experiment(const Climate& air);

} // namespace hygroloom
