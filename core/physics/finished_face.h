// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A finish on one face of a woven cloth: a skin that reaches down to a depth from the plane of that face, over yarns that stay as they
// are. How much of the yarns lies in it, and which pressure takes liquid past it. Lengths in m, angles in radian.
#pragma once

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

/// A yarn that goes from one face to the other at each crossing, by a cosine. Its section is a racetrack.
struct FinishedYarn {
    double width = 0, height = 0;
    double rise = 0; ///< of its centreline over the middle plane where it lies on the face
};

/// Share of a racetrack's area down to a depth under its top; 0 above that, 1 below its bottom.
inline double share_of_section_above(const FinishedYarn& yarn, double depth)
{
    const double flat = std::max(0.0, yarn.width - yarn.height), down = std::clamp(depth / yarn.height, 0.0, 1.0),
                 cosine = 1.0 - 2.0 * down;
    const double round = std::acos(cosine) - cosine * std::sqrt(1.0 - cosine * cosine); // of a circle of radius 1
    const double of_circles = 0.25 * yarn.height * yarn.height, all = pi * of_circles + flat * yarn.height;
    return down >= 1.0 ? 1.0 : (of_circles * round + flat * yarn.height * down) / all;
}

/// The same of its outline.
inline double share_of_outline_above(const FinishedYarn& yarn, double depth)
{
    if (depth <= 0) return 0.0;
    if (depth >= yarn.height) return 1.0;
    const double flat = std::max(0.0, yarn.width - yarn.height), all = pi * yarn.height + 2.0 * flat;
    return (yarn.height * std::acos(1.0 - 2.0 * depth / yarn.height) + flat) / all;
}

/// Shares of a yarn that lie in a finish, 0..1.
struct FinishedShares {
    double crown = 0;   ///< of its section where it lies on the face, mean over the middle three tenths of its way there
    double section = 0; ///< of its section, mean over all of that way
    double outline = 0; ///< of its outline there
    double all = 0;     ///< of its section, mean over where it lies on the face and where it lies on the other

    bool goes_through() const { return crown >= 1.0; }
};

/// In a cloth of this thickness, of a finish that is so deep. Derived here.
inline FinishedShares shares_in_finish(const FinishedYarn& yarn, double thickness, double depth)
{
    constexpr int places = 120; // from where it lies on the face to where it lies on the other
    FinishedShares shares;
    double crown = 0;
    for (int i = 0; i < places; ++i) {
        const double way = (i + 0.5) / places, under_top = depth - 0.5 * thickness + yarn.rise * std::cos(pi * way) + 0.5 * yarn.height;
        const double share = share_of_section_above(yarn, under_top);
        shares.all += share / places;
        if (2 * i >= places) continue;
        shares.section += 2.0 * share / places;
        shares.outline += 2.0 * share_of_outline_above(yarn, under_top) / places;
        if (20 * i < 3 * places) crown += share;
    }
    shares.crown = crown / (0.15 * places);
    return shares;
}

/// A meniscus on its way down between two yarns, its edges on them.
struct SaggingMeniscus {
    double curvature = 0; ///< 1/m, less than 0 where it is hollow
    double deep = 0;      ///< m, of its middle under the yarns' tops
};

/// line: of its edges under the plane through the yarns' axes, as an angle from the axis. Half a gap on either side of the middle.
inline SaggingMeniscus sagging_meniscus(double contact_angle, double half_height, double half_gap, double line)
{
    const double half_width = half_height + half_gap - half_height * std::cos(line), bends = -std::cos(contact_angle + line);
    const double sags = half_width * bends / (1.0 + std::sin(contact_angle + line));
    return {bends / half_width, half_height * (1.0 + std::sin(line)) + sags};
}

/// Pressure over the air's, Pa, at which liquid that stands on a face reaches down to a depth between two yarns: the most on the way there.
/// 0 where it gets there by itself: to half_height (1 + cos contact_angle). A hole between four like yarns counts as two slots. Derived
/// here.
inline double pressure_past_finish(double surface_tension, double contact_angle, double half_height, double half_gap, double depth)
{
    constexpr int places = 1800;
    const auto line = [](double place) { return pi * (place / places - 0.5); };
    const auto at = [&](double place) { return sagging_meniscus(contact_angle, half_height, half_gap, line(place)); };
    double most = 0, last = 0; // 1/m; place
    for (int i = 1; i < places; ++i) {
        if (std::cos(contact_angle + line(i)) >= 0) continue;
        if (at(i).deep > depth) {
            double high = i, low = std::max(last, i - 1.0);
            for (int round = 0; round < 40; ++round) (at(0.5 * (low + high)).deep > depth ? high : low) = 0.5 * (low + high);
            return 2.0 * surface_tension * std::max(most, at(low).curvature);
        }
        most = std::max(most, at(i).curvature);
        last = i;
    }
    return 2.0 * surface_tension * most;
}

} // namespace hygroloom
