// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Indices of laboratory tests against the published arithmetic.
#include "core/analysis/management.h"
#include "core/verify/verify.h"

#include <algorithm>

namespace hygroloom {
namespace {

/// Yao et al. 2006: each index over its range, cut off at both ends.
double published_capability(double absorption, double transport, double speed)
{
    const double a = absorption < 10 ? 0 : absorption > 100 ? 1 : (absorption - 10) / 90;
    const double r = transport < -50 ? 0 : transport > 400 ? 1 : (transport + 50) / 450;
    const double s = speed < 1 ? 0 : speed > 4 ? 1 : (speed - 1) / 3;
    return (a + 2 * r + s) / 4;
}

/// How many of the grades' lower bounds a value has reached.
int published_grade(double value, double two, double three, double four, double five)
{
    return value >= five ? 5 : value >= four ? 4 : value >= three ? 3 : value >= two ? 2 : 1;
}

std::vector<VerifyResult> management_indices_case(const VerifyValues& v, Backend&)
{
    const auto value = [&](const char* name) { return v.at(name).value; };
    ManagementIndices m;
    m.top = {value("wetting_time_top_s"), value("absorption_rate_top_pct_s"), value("maximum_wetted_radius_top_mm"),
             value("spreading_speed_top_mm_s")};
    m.bottom = {value("wetting_time_bottom_s"), value("absorption_rate_bottom_pct_s"), value("maximum_wetted_radius_bottom_mm"),
                value("spreading_speed_bottom_mm_s")};
    m.one_way_transport = value("one_way_transport_pct");
    m.ommc = overall_capability(m.bottom.absorption_rate, m.one_way_transport, m.bottom.spreading_speed);
    const ManagementGrades g = management_grades(m);
    const double ommc = published_capability(m.bottom.absorption_rate, m.one_way_transport, m.bottom.spreading_speed);
    const auto wetting = [](double time) { return time >= 120 ? 1 : time >= 20 ? 2 : time >= 5 ? 3 : time >= 3 ? 4 : 5; };
    VerifyResult grades{"grades"};
    const auto add = [&](const char* name, int computed, int expected) { grades.parts.push_back({name, computed, expected}); };
    add("wetting_time_top", g.wetting_time_top, wetting(*m.top.wetting_time));
    add("wetting_time_bottom", g.wetting_time_bottom, wetting(*m.bottom.wetting_time));
    add("absorption_rate_top", g.absorption_rate_top, published_grade(m.top.absorption_rate, 10, 30, 50, 100));
    add("absorption_rate_bottom", g.absorption_rate_bottom, published_grade(m.bottom.absorption_rate, 10, 30, 50, 100));
    add("maximum_wetted_radius_top", g.maximum_wetted_radius_top, published_grade(m.top.maximum_wetted_radius, 7, 12, 17, 22));
    add("maximum_wetted_radius_bottom", g.maximum_wetted_radius_bottom, published_grade(m.bottom.maximum_wetted_radius, 7, 12, 17, 22));
    add("spreading_speed_top", g.spreading_speed_top, published_grade(m.top.spreading_speed, 1, 2, 3, 4));
    add("spreading_speed_bottom", g.spreading_speed_bottom, published_grade(m.bottom.spreading_speed, 1, 2, 3, 4));
    add("one_way_transport", g.one_way_transport, published_grade(m.one_way_transport, -50, 100, 200, 400));
    add("ommc", g.ommc, published_grade(ommc, 0.2, 0.4, 0.6, 0.8));
    std::vector<VerifyResult> results{{"ommc", m.ommc, ommc, 1e-12}, grades};
    for (const VerifyPart& p : grades.parts)
        results.push_back({"grade_" + p.name, static_cast<double>(p.computed), static_cast<double>(p.expected), 0});
    return results;
}

} // namespace

std::vector<VerifyCase> laboratory_cases()
{
    return {
        {"management_indices",
         "Overall capability and grades of a moisture management test from its indices.",
         {{"absorption_rate_bottom_pct_s", 55, 0, 1e4, ""},
          {"one_way_transport_pct", 250, -1e5, 1e5, ""},
          {"spreading_speed_bottom_mm_s", 3.1, 0, 1e3, ""},
          {"absorption_rate_top_pct_s", 40, 0, 1e4, ""},
          {"spreading_speed_top_mm_s", 2.5, 0, 1e3, ""},
          {"wetting_time_top_s", 4, 0, 120, ""},
          {"wetting_time_bottom_s", 6, 0, 120, ""},
          {"maximum_wetted_radius_top_mm", 15, 0, 30, ""},
          {"maximum_wetted_radius_bottom_mm", 20, 0, 30, ""}},
         management_indices_case},
    };
}

} // namespace hygroloom
