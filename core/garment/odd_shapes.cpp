// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/odd_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

// Assumptions.
constexpr double largest_garment = 2.5, smallest_garment = 0.1; // m, of the longest way through it
constexpr double most_other_area = 0.25;                        // of a panel's flat area and that in space

void tell_size(GarmentPattern& pattern)
{
    if (pattern.shape.places.empty()) return;
    Vec3d least = pattern.shape.places.front(), most = least;
    for (const Vec3d& p : pattern.shape.places) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    }
    const Vec3d size = most - least;
    const double largest = std::max({size.x, size.y, size.z});
    if (largest >= smallest_garment && largest <= largest_garment) return;
    doubt(pattern, fmt::format("The garment is {:.3g} m high, {:.3g} m wide and {:.3g} m deep; the longest of these is from {:g} to {:g} m "
                               "of a garment. Its file may be in another unit than it should: GLB and glTF are in metres.",
                               size.y, size.x, size.z, smallest_garment, largest_garment));
}

/// m2 in space, of each panel.
std::vector<double> areas_in_space(const GarmentPattern& pattern)
{
    std::vector<double> areas(pattern.panels.size());
    for (std::size_t t = 0; t < pattern.shape.triangles.size(); ++t) areas[pattern.shape.panel[t]] += area_of_triangle(pattern.shape, t);
    return areas;
}

void tell_areas(GarmentPattern& pattern, const std::vector<double>& in_space)
{
    constexpr std::size_t most_told = 5;
    std::vector<std::string> told;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const double flat = area_of(pattern.panels[p]), space = in_space[p];
        if (!(std::abs(flat - space) > most_other_area * std::min(flat, space))) continue;
        told.push_back(fmt::format("\"{}\" {:.4g} and {:.4g} m2", pattern.panels[p].name, flat, space));
    }
    if (told.empty()) return;
    const std::size_t more = told.size() - std::min(told.size(), most_told);
    told.resize(told.size() - more);
    doubt(pattern, fmt::format("The area of {} in flat coordinates differs from that in space by more than {:.0f} %: {}{}.",
                               told.size() + more == 1 ? "a panel" : fmt::format("{} panels", told.size() + more), 100 * most_other_area,
                               fmt::join(told, ", "), more > 0 ? fmt::format(" and {} more", more) : ""));
}

/// Whether a place lies inside an outline.
bool inside(const std::vector<FlatPlace>& outline, const FlatPlace& p)
{
    bool in = false;
    for (std::size_t i = 0, k = outline.size() - 1; i < outline.size(); k = i++) {
        const FlatPlace &a = outline[i], &b = outline[k];
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0]) in = !in;
    }
    return in;
}

} // namespace

void doubt(GarmentPattern& pattern, std::string sentence)
{
    pattern.doubts.push_back(sentence);
    pattern.issues.push_back(std::move(sentence));
}

double area_of_triangle(const GarmentShape& shape, std::size_t t)
{
    const auto place = [&](std::size_t k) { return shape.places[shape.triangles[t][k]]; };
    return 0.5 * length(cross(place(1) - place(0), place(2) - place(0)));
}

void tell_odd_shapes(GarmentPattern& pattern)
{
    tell_size(pattern);
    if (!pattern.is_draped) return;
    const std::vector<double> in_space = areas_in_space(pattern);
    tell_areas(pattern, in_space);
    tell_thick_cloth(pattern, in_space);
}

void tell_overlaps(GarmentPattern& pattern, const std::vector<std::vector<FlatPlace>>& outlines)
{
    std::size_t work = 0;
    for (std::size_t k = 0; k < outlines.size(); ++k)
        for (std::size_t m = 0; m < outlines.size(); ++m) {
            if (m == k) continue;
            const std::size_t every = 1 + outlines[k].size() / 20;
            for (std::size_t i = 0; i < outlines[k].size(); i += every) {
                work += outlines[m].size();
                if (work > 20'000'000) return;
                if (!inside(outlines[m], outlines[k][i])) continue;
                pattern.issues.push_back(
                    fmt::format("The flat coordinates of the panels \"{}\" and \"{}\" overlap; each is a panel of its own here.",
                                pattern.panels[k].name, pattern.panels[m].name));
                return;
            }
        }
}

} // namespace hygroloom
