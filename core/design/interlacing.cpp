// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Closed form of the arcs and straights; see the header.
#include "core/design/interlacing.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

double section_area(const Section& section)
{
    return 0.25 * pi * section.height * section.height + (section.width - section.height) * section.height;
}

Section flattened_section(double diameter, double height)
{
    const double area = 0.25 * pi * diameter * diameter;
    return {area / height + (1.0 - 0.25 * pi) * height, height};
}

Interlacing interlace(double pitch, const Section& own, const Section& other, double amplitude)
{
    Interlacing path;
    path.pitch = pitch;
    path.amplitude = amplitude;
    path.flat = std::max(0.0, 0.5 * (other.width - other.height));
    path.arc_radius = 0.5 * (own.height + other.height);

    // From the arc's centre to the middle of the pitch, where the path crosses the fabric's middle plane.
    double across = 0.5 * pitch - path.flat;
    const double down = path.arc_radius - path.amplitude;
    const double reach = std::hypot(across, down);
    double straight = 0;
    if (reach >= path.arc_radius) {
        straight = std::sqrt(reach * reach - path.arc_radius * path.arc_radius);
        path.weave_angle = 0.5 * pi - std::atan2(down, across) - std::acos(path.arc_radius / reach);
    } else {
        path.jammed = true;
        across = std::min(0.5 * pitch, std::sqrt(path.arc_radius * path.arc_radius - down * down));
        path.flat = 0.5 * pitch - across;
        path.arc_radius = (across * across + path.amplitude * path.amplitude) / (2.0 * path.amplitude);
        path.weave_angle = std::asin(std::min(1.0, across / path.arc_radius));
    }
    path.length = 2.0 * (path.flat + path.arc_radius * path.weave_angle + straight);
    return path;
}

double squeezed_height(const Section& own, const Section& crossed, double along, double over)
{
    constexpr double least = 0.1;
    const double flat = 0.5 * (crossed.width - crossed.height);
    const double clearance = std::hypot(std::max(std::abs(along) - flat, 0.0), over) - 0.5 * crossed.height; // to a racetrack's skin
    return 2 * std::clamp(clearance, 0.5 * least * own.height, 0.5 * own.height);
}

double squeezed_height_at(const Interlacing& path, const Section& own, const Section& other, double other_rise, double x)
{
    const double z = path.height_at(x);
    return std::min(squeezed_height(own, other, x, z + other_rise), squeezed_height(own, other, path.pitch - x, other_rise - z));
}

double Interlacing::height_at(double x) const
{
    if (x > 0.5 * pitch) return -height_at(pitch - x);
    const double past_flat = x - flat;
    if (past_flat <= 0) return amplitude;
    if (past_flat < arc_radius * std::sin(weave_angle))
        return amplitude - arc_radius + std::sqrt(arc_radius * arc_radius - past_flat * past_flat);
    return (0.5 * pitch - x) * std::tan(weave_angle);
}

double Interlacing::slope_at(double x) const
{
    const double past_flat = std::min(x, pitch - x) - flat;
    if (past_flat <= 0) return 0;
    if (past_flat < arc_radius * std::sin(weave_angle)) return -past_flat / std::sqrt(arc_radius * arc_radius - past_flat * past_flat);
    return -std::tan(weave_angle);
}

} // namespace hygroloom
