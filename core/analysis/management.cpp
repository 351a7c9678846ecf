// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/management.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hygroloom {
namespace {

constexpr double wetting_slope = 0.26794919243112270; // tan 15 degrees, % per s
constexpr double ring_step = 5, last_ring = 30;       // mm

double water_at(const std::vector<double>& time, const std::vector<double>& water, double at)
{
    const auto after = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), at) - time.begin());
    if (after == 0) return water.front();
    if (after == time.size()) return water.back();
    const double share = (at - time[after - 1]) / (time[after] - time[after - 1]);
    return water[after - 1] + share * (water[after] - water[after - 1]);
}

/// When the wetted circle first reaches a radius (mm).
std::optional<double> reached(const std::vector<double>& time, const std::vector<double>& radius, double wanted)
{
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double here = 1e3 * radius[i];
        if (here < wanted) continue;
        if (i == 0) return time[0];
        const double before = 1e3 * radius[i - 1];
        return time[i - 1] + (wanted - before) / (here - before) * (time[i] - time[i - 1]);
    }
    return std::nullopt;
}

FaceIndices face_indices(const std::vector<double>& time, const FaceCurve& face, double feed_end)
{
    FaceIndices indices;
    for (std::size_t i = 1; i < time.size() && !indices.wetting_time; ++i)
        if (face.water[i] - face.water[i - 1] > wetting_slope * (time[i] - time[i - 1])) indices.wetting_time = time[i - 1];
    if (!indices.wetting_time) return indices;
    const double end = std::min(feed_end, time.back());
    if (end > *indices.wetting_time)
        indices.absorption_rate =
            (water_at(time, face.water, end) - water_at(time, face.water, *indices.wetting_time)) / (end - *indices.wetting_time);

    double before = *indices.wetting_time, speeds = 0;
    int rings = 0;
    for (double ring = ring_step; ring <= last_ring; ring += ring_step) {
        const std::optional<double> wet = reached(time, face.radius, ring);
        if (!wet) break;
        indices.maximum_wetted_radius = ring;
        ++rings;
        constexpr double shortest = 0.1; // s, between two readings of a tester
        speeds += ring_step / std::max(*wet - before, shortest);
        before = std::max(*wet, before);
    }
    if (rings > 0) indices.spreading_speed = speeds / rings;
    return indices;
}

double area(const std::vector<double>& time, const std::vector<double>& water)
{
    double sum = 0;
    for (std::size_t i = 1; i < time.size(); ++i) sum += 0.5 * (water[i] + water[i - 1]) * (time[i] - time[i - 1]);
    return sum;
}

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

ManagementIndices management_indices(const std::vector<double>& time, const FaceCurve& top, const FaceCurve& bottom, double feed_end)
{
    ManagementIndices indices;
    if (time.size() < 2) return indices;
    indices.top = face_indices(time, top, feed_end);
    indices.bottom = face_indices(time, bottom, feed_end);
    indices.one_way_transport = (area(time, bottom.water) - area(time, top.water)) / (time.back() - time.front());
    indices.ommc = overall_capability(indices.bottom.absorption_rate, indices.one_way_transport, indices.bottom.spreading_speed);
    return indices;
}

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
