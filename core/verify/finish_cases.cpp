// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a finish of one face covers of the yarns, and which pressure takes water past it, against sums and roots found in other ways.
#include "core/physics/finished_face.h"
#include "core/physics/water.h"
#include "core/verify/verify.h"

#include <functional>

namespace hygroloom {
namespace {

constexpr double width_over_height = 1.25; // of a ring-spun yarn in a cloth, as a racetrack

/// Share of such a section, one high, above a plane: strips, each as wide as the section is there.
double by_strips(double down)
{
    constexpr int strips = 4000;
    double above = 0, all = 0;
    for (int i = 0; i < strips; ++i) {
        const double y = (i + 0.5) / strips, wide = width_over_height - 1 + 2 * std::sqrt(y * (1 - y));
        all += wide;
        if (y < down) above += wide;
    }
    return above / all;
}

/// Of a plain cloth whose yarns all come up to both faces, two of them thick.
std::vector<VerifyResult> finished_share(const VerifyValues& v, Backend&)
{
    const double depth = value(v, "depth_share");
    const FinishedShares found = shares_in_finish({width_over_height, 1, 0.5}, 2, 2 * depth);
    constexpr int places = 400; // of the way from one face to the other
    double all = 0, crown = 0;
    for (int i = 0; i < places; ++i) {
        const double sinks = 0.5 * (1 - std::cos(pi * (i + 0.5) / places)), share = by_strips(2 * depth - sinks);
        all += share / places;
        if (20 * i < 3 * places) crown += share / (0.15 * places);
    }
    return {{"all", found.all, all, 2e-3}, {"crown", found.crown, crown, 2e-3}};
}

/// The place between two where a function that rises with it passes a value.
double where(const std::function<double(double)>& rises, double wanted, double low, double high)
{
    for (int round = 0; round < 100; ++round) (rises(0.5 * (low + high)) < wanted ? low : high) = 0.5 * (low + high);
    return low;
}

/// Expected: from where the meniscus is flat to where it reaches the depth, each found as a root; on the way its pressure rises as long as
/// sin(angle + line) (b + g - b cos line) + b sin line cos(angle + line) is more than 0.
std::vector<VerifyResult> finished_hole(const VerifyValues& v, Backend&)
{
    const double tension = water_surface_tension(kelvin_from_celsius(20)), angle = radian_from_degree(value(v, "contact_angle_deg"));
    const double half = metre_from_um(value(v, "half_height_um")), gap = metre_from_um(value(v, "half_gap_um"));
    const double depth = value(v, "depth_share") * metre_from_um(value(v, "thickness_um"));
    const double computed = pressure_past_finish(tension, angle, half, gap, depth);
    const double flat = 0.5 * pi - angle, end = 0.5 * pi;
    const auto width = [&](double line) { return half + gap - half * std::cos(line); };
    const auto deep = [&](double line) { // an arc over its chord
        return half * (1 + std::sin(line)) + width(line) * std::tan(0.5 * (line - flat));
    };
    const auto past_most = [&](double line) { // rises through 0 where the pressure is at its most
        return -(std::sin(angle + line) * width(line) + half * std::sin(line) * std::cos(angle + line));
    };
    const auto pressure = [&](double line) { return -2 * tension * std::cos(angle + line) / width(line); };
    double expected = 0;
    if (half * (1 + std::cos(angle)) < depth && angle > 0) {
        const double reached = where(deep, depth, flat, end);
        expected = pressure(std::min(reached, where(past_most, 0, flat, end)));
    }
    return {{"breakthrough_pa", computed, expected, std::max(0.5, 2e-3 * expected)}};
}

} // namespace

std::vector<VerifyCase> finish_cases()
{
    return {{"finished_hole",
             "The pressure at which water on a finished face reaches through the hole between yarns down to the finish's depth.",
             {{"half_height_um", 62, 1, 1e4, ""},
              {"half_gap_um", 125, 1, 1e4, ""},
              {"thickness_um", 250, 1, 5e4, ""},
              {"contact_angle_deg", 110, 90, 180, ""},
              {"depth_share", 0.25, 0, 1, ""}},
             finished_hole},
            {"finished_share",
             "How much of the yarns a finish of one face covers, of all and where they lie on that face, in a plain cloth of level faces.",
             {{"depth_share", 0.1, 0, 1, ""}},
             finished_share}};
}

} // namespace hygroloom
