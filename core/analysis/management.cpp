// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/management.h"

#include <algorithm>
#include <array>

namespace hygroloom {
namespace {

double scaled(double value, double low, double width) { return std::clamp((value - low) / width, 0.0, 1.0); }

int grade(double value, const std::array<double, 4>& cuts)
{
    return 1 + static_cast<int>(std::count_if(cuts.begin(), cuts.end(), [&](double cut) { return value >= cut; }));
}

int wetting_grade(const std::optional<double>& time) { return time ? 6 - grade(*time, {3, 5, 20, 120}) : 1; }
int rate_grade(double value) { return grade(value, {10, 30, 50, 100}); }
int radius_grade(double value) { return grade(value, {7, 12, 17, 22}); }
int speed_grade(double value) { return grade(value, {1, 2, 3, 4}); }

} // namespace

double overall_capability(double absorption_rate_bottom, double one_way_transport, double spreading_speed_bottom)
{
    return 0.25 * scaled(absorption_rate_bottom, 10, 90) + 0.5 * scaled(one_way_transport, -50, 450) +
           0.25 * scaled(spreading_speed_bottom, 1, 3);
}

ManagementGrades management_grades(const ManagementIndices& indices)
{
    ManagementGrades grades;
    grades.wetting_time_top = wetting_grade(indices.top.wetting_time);
    grades.wetting_time_bottom = wetting_grade(indices.bottom.wetting_time);
    grades.absorption_rate_top = rate_grade(indices.top.absorption_rate);
    grades.absorption_rate_bottom = rate_grade(indices.bottom.absorption_rate);
    grades.maximum_wetted_radius_top = radius_grade(indices.top.maximum_wetted_radius);
    grades.maximum_wetted_radius_bottom = radius_grade(indices.bottom.maximum_wetted_radius);
    grades.spreading_speed_top = speed_grade(indices.top.spreading_speed);
    grades.spreading_speed_bottom = speed_grade(indices.bottom.spreading_speed);
    grades.one_way_transport = grade(indices.one_way_transport, {-50, 100, 200, 400});
    grades.ommc = grade(indices.ommc, {0.2, 0.4, 0.6, 0.8});
    return grades;
}

const char* fabric_class(const ManagementIndices& indices)
{
    const ManagementGrades grades = management_grades(indices);
    const FaceIndices &top = indices.top, &bottom = indices.bottom;
    if (grades.wetting_time_top == 1 && grades.wetting_time_bottom == 1) return "water-proof or water-repellent";
    if (grades.one_way_transport >= 3)
        return bottom.maximum_wetted_radius >= 18 && bottom.spreading_speed >= 2 ? "moisture management" : "water penetration";
    if (grades.wetting_time_top <= 2 || top.absorption_rate < 30) return "slow-absorbing and slow-drying";
    return bottom.maximum_wetted_radius >= 18 && bottom.spreading_speed >= 3 ? "fast-absorbing and quick-drying"
                                                                             : "fast-absorbing and slow-drying";
}

} // namespace hygroloom
