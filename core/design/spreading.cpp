// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/spreading.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int spreading_steps = 16;

/// A yarn as balls that roll along a ribbon: two yarns meet where their ribbons are nearer than both radii.
struct Ribbon {
    double pitch;
    std::vector<double> height, radius, half_flat;
    std::vector<double> wanted; ///< half flat that keeps the area

    double at(std::size_t sample) const { return pitch * static_cast<double>(sample) / (span_samples - 1); }
};

Ribbon ribbon_of(const Spanning& yarn, const Spanning& crossed, double side)
{
    Ribbon ribbon{yarn.path.pitch, {}, {}, {}, {}};
    const double flat = 0.5 * (yarn.own.width - yarn.own.height), area = section_area(yarn.own);
    const double nearer = crossed.rise - left_between(yarn.own, yarn.rise, crossed.own, crossed.rise);
    for (std::size_t i = 0; i < span_samples; ++i) {
        const double x = ribbon.at(i);
        const double radius = yarn.changes ? 0.5 * squeezed_height_at(yarn.path, yarn.own, crossed.own, nearer, x) : 0.5 * yarn.own.height;
        ribbon.height.push_back(side * (yarn.changes ? yarn.path.height_at(x) : yarn.rise));
        ribbon.radius.push_back(radius);
        ribbon.half_flat.push_back(flat);
        const double keeps = (area - pi * radius * radius) / (4 * radius);
        ribbon.wanted.push_back(std::max(flat, std::min(keeps, 0.5 * yarn.widest - radius)));
    }
    return ribbon;
}

/// Half the flat that the other ribbon leaves at a sample.
double room_beside(const Ribbon& own, const Ribbon& other, std::size_t sample)
{
    double room = own.wanted[sample];
    for (std::size_t k = 0; k < span_samples; ++k) {
        const double apart = own.radius[sample] + other.radius[k], up = own.height[sample] - other.height[k];
        const double along = std::max(0.0, own.at(sample) - other.half_flat[k]);
        const double left = apart * apart - up * up - along * along;
        if (left > 1e-9 * apart * apart) room = std::min(room, other.at(k) - std::sqrt(left));
    }
    return room;
}

/// A share of the way from the first flat to the wanted one.
void widen(Ribbon& own, const Ribbon& other, double share, double first)
{
    std::vector<double> room;
    for (std::size_t i = 0; i < span_samples; ++i) room.push_back(room_beside(own, other, i));
    for (std::size_t i = 0; i < span_samples; ++i) {
        const double limit = std::min(room[i], room[span_samples - 1 - i]); // the same from the yarn at the other end
        own.half_flat[i] = std::max(own.half_flat[i], std::min(first + share * (own.wanted[i] - first), limit));
    }
}

void widen_both(Ribbon& one, bool one_changes, Ribbon& other, bool other_changes)
{
    const double one_flat = one.half_flat[0], other_flat = other.half_flat[0];
    for (int step = 1; step <= spreading_steps; ++step) {
        const double share = static_cast<double>(step) / spreading_steps;
        if (one_changes) widen(one, other, share, one_flat);
        if (other_changes) widen(other, one, share, other_flat);
    }
}

SpanSections sections_of(Ribbon&& ribbon, const Section& own)
{
    double area = 0, length = 0;
    for (std::size_t i = 0; i + 1 < span_samples; ++i) {
        const auto at = [&](std::size_t k) { return ribbon.radius[k] * (pi * ribbon.radius[k] + 4 * ribbon.half_flat[k]); };
        const double piece = std::hypot(ribbon.at(1), ribbon.height[i + 1] - ribbon.height[i]);
        area += 0.5 * piece * (at(i) + at(i + 1));
        length += piece;
    }
    return {std::move(ribbon.radius), std::move(ribbon.half_flat), area / (length * section_area(own))};
}

} // namespace

double SpanSections::mean_width() const
{
    double sum = 0;
    for (std::size_t i = 0; i + 1 < span_samples; ++i) sum += half_width(i) + half_width(i + 1);
    return sum / (span_samples - 1);
}

SpanPair span_sections(const Spanning& warp, const Spanning& weft)
{
    Ribbon ends = ribbon_of(warp, weft, 1), picks = ribbon_of(weft, warp, -1);
    Ribbon later_ends = ends, later_picks = picks;
    widen_both(ends, warp.changes, picks, weft.changes);
    widen_both(later_picks, weft.changes, later_ends, warp.changes);
    // What has room whichever goes first, so that a cloth turned over is the same cloth.
    for (std::size_t i = 0; i < span_samples; ++i) {
        ends.half_flat[i] = std::min(ends.half_flat[i], later_ends.half_flat[i]);
        picks.half_flat[i] = std::min(picks.half_flat[i], later_picks.half_flat[i]);
    }
    return {sections_of(std::move(ends), warp.own), sections_of(std::move(picks), weft.own)};
}

} // namespace hygroloom
