// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The indices of a moisture management test (AATCC 195, after Yao et al. 2006): their grades, their overall capability and the class of the
// fabric. The indices themselves come from moisture_tester.h.
#pragma once

#include <optional>

namespace hygroloom {

/// Of one face.
struct FaceIndices {
    std::optional<double> wetting_time; ///< s, when the water content first rises by more than tan 15 degrees per s
    double absorption_rate = 0;         ///< %/s, mean slope from there over half of the further rise within the feed
    double maximum_wetted_radius = 0;   ///< mm, of rings 5 mm apart, 30 at most
    double spreading_speed = 0;         ///< mm/s, mean over the wetted rings
};

struct ManagementIndices {
    FaceIndices top, bottom;
    double one_way_transport = 0; ///< %, difference of the areas under both curves over the time
    double ommc = 0;              ///< overall moisture management capability, 0 .. 1
};

/// OMMC = 0.25 AR + 0.5 R + 0.25 SS of the bottom, each scaled to 0 .. 1 (Yao et al. 2006).
double overall_capability(double absorption_rate_bottom, double one_way_transport, double spreading_speed_bottom);

/// 1 poor to 5 excellent, by the cut points of AATCC 195; a cut point belongs to the better grade, of wetting times to the worse.
struct ManagementGrades {
    int wetting_time_top = 1, wetting_time_bottom = 1;
    int absorption_rate_top = 1, absorption_rate_bottom = 1;
    int maximum_wetted_radius_top = 1, maximum_wetted_radius_bottom = 1;
    int spreading_speed_top = 1, spreading_speed_bottom = 1;
    int one_way_transport = 1;
    int ommc = 1;
};
ManagementGrades management_grades(const ManagementIndices& indices);

/// The grades by their names in the metrics file.
struct GradeName {
    const char* key;
    int ManagementGrades::*grade;
};
constexpr GradeName grade_names[] = {{"wetting_time_top", &ManagementGrades::wetting_time_top},
                                     {"wetting_time_bottom", &ManagementGrades::wetting_time_bottom},
                                     {"absorption_rate_top", &ManagementGrades::absorption_rate_top},
                                     {"absorption_rate_bottom", &ManagementGrades::absorption_rate_bottom},
                                     {"maximum_wetted_radius_top", &ManagementGrades::maximum_wetted_radius_top},
                                     {"maximum_wetted_radius_bottom", &ManagementGrades::maximum_wetted_radius_bottom},
                                     {"spreading_speed_top", &ManagementGrades::spreading_speed_top},
                                     {"spreading_speed_bottom", &ManagementGrades::spreading_speed_bottom},
                                     {"one_way_transport", &ManagementGrades::one_way_transport},
                                     {"ommc", &ManagementGrades::ommc}};

/// "fast-absorbing quick-drying" and so on. The classes are Yao et al.'s, the thresholds between them our own reading of their words.
const char* fabric_class(const ManagementIndices& indices);

} // namespace hygroloom
