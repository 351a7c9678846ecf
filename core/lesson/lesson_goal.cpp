// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/lesson/lesson_goal.h"

#include <algorithm>
#include <array>

namespace hygroloom {
namespace {

constexpr std::array metrics{
    LessonMetric{"drops", [](const ClothScore& score) { return static_cast<double>(score.drops); }, nullptr},
    LessonMetric{"wet_area_mm2", [](const ClothScore& score) { return score.wet_area_mm2; }, nullptr},
    LessonMetric{"radius_mm", [](const ClothScore& score) { return score.radius_mm; }, nullptr},
    LessonMetric{"standing_ul", [](const ClothScore& score) { return score.standing_ul; }, nullptr},
    LessonMetric{"in_fibres_ul", [](const ClothScore& score) { return score.in_fibres_ul; }, nullptr},
    LessonMetric{"evaporated_ul", [](const ClothScore& score) { return score.evaporated_ul; }, nullptr},
    LessonMetric{"run_off_ul", [](const ClothScore& score) { return score.run_off_ul; }, nullptr},
    LessonMetric{"absorbed_s", [](const ClothScore& score) { return score.absorbed_s; }, nullptr},
    LessonMetric{"air_speed_m_s", nullptr, [](const TableState& state) { return state.air.air_speed_m_s; }},
    LessonMetric{"air_temperature_c", nullptr, [](const TableState& state) { return state.air.temperature_c; }},
    LessonMetric{"air_humidity", nullptr, [](const TableState& state) { return state.air.relative_humidity; }},
    LessonMetric{"tilt_deg", nullptr, [](const TableState& state) { return state.tilt_deg; }},
};

/// A time to absorb is there only once there is one.
bool is_there(double value, const LessonMetric& metric)
{
    return !(metric.of_cloth && value < 0 && std::string(metric.key) == "absorbed_s");
}

} // namespace

std::span<const LessonMetric> lesson_metrics() { return metrics; }

bool is_seen(const LessonGoal& goal, const TableState& state)
{
    if (state.since_step_s < goal.after_s) return false;
    if (goal.metric < 0) return true;
    const LessonMetric& metric = metrics.at(static_cast<std::size_t>(goal.metric));
    const auto value_of = [&](int cloth) { return metric.of_cloth(state.cloths.at(static_cast<std::size_t>(cloth))); };
    const auto holds = [&](double value) {
        if (!is_there(value, metric)) return false;
        switch (goal.compare) {
        case LessonGoal::Compare::at_least: return value >= goal.limit;
        case LessonGoal::Compare::at_most: return value <= goal.limit;
        case LessonGoal::Compare::greater_than_cloth: return is_there(value_of(goal.other), metric) && value > value_of(goal.other);
        case LessonGoal::Compare::less_than_cloth: return is_there(value_of(goal.other), metric) && value < value_of(goal.other);
        }
        return false;
    };
    if (metric.of_table) return holds(metric.of_table(state));
    if (goal.cloth) return holds(value_of(*goal.cloth));
    for (int k = 0; k < static_cast<int>(state.cloths.size()); ++k) {
        const bool is_other =
            goal.compare == LessonGoal::Compare::greater_than_cloth || goal.compare == LessonGoal::Compare::less_than_cloth;
        if (!(is_other && k == goal.other) && !holds(value_of(k))) return false;
    }
    return !state.cloths.empty();
}

} // namespace hygroloom
