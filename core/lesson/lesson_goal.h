// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// When a step of a lesson counts as seen: a number of a cloth, or of the table, against a limit or against another cloth's.
#pragma once

#include "core/design/design.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hygroloom {

/// What a class reads of a cloth.
struct ClothScore {
    int drops = 0;            ///< that were dropped on it
    double wet_area_mm2 = 0;  ///< of its upper face
    double radius_mm = 0;     ///< of the smallest circle round that
    double standing_ul = 0;   ///< on it
    double in_fibres_ul = 0;  ///< more than at the start
    double evaporated_ul = 0; ///< net
    double run_off_ul = 0;    ///< that cloth and face have lost as liquid
    bool wiped = false;       ///< what stood of the last drop ran off when the cloth was squeezed
    double absorbed_s = -1;   ///< from the landing of the last drop until none stood; less than 0: not yet
    bool operator==(const ClothScore&) const = default;
};

/// What there is to see at a moment.
struct TableState {
    double since_step_s = 0; ///< simulated, since the step began
    Climate air;
    double tilt_deg = 0;
    std::vector<ClothScore> cloths;
};

/// A number that a goal may name.
struct LessonMetric {
    const char* key; ///< in the file
    double (*of_cloth)(const ClothScore&);
    double (*of_table)(const TableState&); ///< where it is no cloth's
};
std::span<const LessonMetric> lesson_metrics();

struct LessonGoal {
    enum class Compare { at_least, at_most, greater_than_cloth, less_than_cloth };
    int metric = -1;          ///< place in lesson_metrics(); less than 0: time alone counts
    std::optional<int> cloth; ///< none: each
    Compare compare = Compare::at_least;
    double limit = 0;
    int other = 0;      ///< cloth to compare with
    double after_s = 0; ///< simulated time since the step began, before which nothing counts
    bool operator==(const LessonGoal&) const = default;
};

/// Precondition: the goal's cloths are among the state's.
bool is_seen(const LessonGoal& goal, const TableState& state);

} // namespace hygroloom
