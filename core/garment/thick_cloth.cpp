// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Cloth that was exported with its thickness: both faces are in the mesh, and would both be wetted. Places on all triangles are compared
// with those around them.
#include "core/garment/odd_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

namespace hygroloom {

namespace {

// Assumptions.
constexpr double thickest = 0.005;    // m
constexpr double least_covered = 0.8; // of both faces
constexpr double most_samples = 10000;

struct Sample {
    Vec3d place, normal;
    FlatPlace flat{};
    int panel = 0;
    double area = 0; ///< m2 that it stands for
};

/// Places on all triangles, about so far from each other.
std::vector<Sample> samples_of(const GarmentPattern& pattern, double spacing)
{
    const GarmentShape& shape = pattern.shape;
    std::vector<Sample> samples;
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        const auto corner = [&](std::size_t k) { return static_cast<std::size_t>(shape.triangles[t][k]); };
        const Vec3d a = shape.places[corner(0)], p = shape.places[corner(1)] - a, q = shape.places[corner(2)] - a;
        const double area = area_of_triangle(shape, t);
        if (!(area > 0)) continue;
        const Vec3d normal = (0.5 / area) * cross(p, q);
        const int parts = std::max(1, static_cast<int>(std::ceil(std::sqrt(2 * area) / spacing)));
        const auto add = [&](double u, double v) {
            const FlatPlace &fa = shape.flat[corner(0)], &fp = shape.flat[corner(1)], &fq = shape.flat[corner(2)];
            samples.push_back({a + u * p + v * q,
                               normal,
                               {fa[0] + u * (fp[0] - fa[0]) + v * (fq[0] - fa[0]), fa[1] + u * (fp[1] - fa[1]) + v * (fq[1] - fa[1])},
                               shape.panel[t],
                               area / (static_cast<double>(parts) * parts)});
        };
        for (int i = 0; i < parts; ++i) // middles of the parts, upright and turned
            for (int k = 0; k < parts - i; ++k) {
                add((i + 1.0 / 3) / parts, (k + 1.0 / 3) / parts);
                if (k + 1 < parts - i) add((i + 2.0 / 3) / parts, (k + 2.0 / 3) / parts);
            }
    }
    return samples;
}

/// m2 of a panel that lie on another panel, or on another part of the same one.
using Covered = std::map<std::pair<int, int>, double>;

using SampleCell = std::array<long long, 3>;
struct SampleHash {
    std::size_t operator()(const SampleCell& cell) const
    {
        std::size_t hash = 0;
        for (const long long part : cell) hash = (hash ^ static_cast<std::size_t>(part)) * 1099511628211u;
        return hash ^ hash >> 29;
    }
};

Covered covered(const std::vector<Sample>& samples, double spacing)
{
    const double side = thickest + spacing;
    const auto cell_of = [side](const Vec3d& p) {
        return SampleCell{std::llround(p.x / side), std::llround(p.y / side), std::llround(p.z / side)};
    };
    std::unordered_map<SampleCell, std::vector<std::size_t>, SampleHash> cells;
    for (std::size_t i = 0; i < samples.size(); ++i) cells[cell_of(samples[i].place)].push_back(i);
    const auto lies_on = [&](const Sample& one, const Sample& other) {
        const Vec3d way = other.place - one.place;
        const double off = std::abs(dot(way, one.normal));
        if (off > thickest || length(way - dot(way, one.normal) * one.normal) > spacing) return false;
        return other.panel != one.panel || std::hypot(other.flat[0] - one.flat[0], other.flat[1] - one.flat[1]) > 4 * side;
    };
    Covered found;
    for (const Sample& one : samples) {
        const SampleCell own = cell_of(one.place);
        std::set<int> panels;
        for (long long x = -1; x <= 1; ++x)
            for (long long y = -1; y <= 1; ++y)
                for (long long z = -1; z <= 1; ++z) {
                    const auto cell = cells.find({own[0] + x, own[1] + y, own[2] + z});
                    if (cell == cells.end()) continue;
                    for (const std::size_t other : cell->second)
                        if (!panels.contains(samples[other].panel) && lies_on(one, samples[other])) panels.insert(samples[other].panel);
                }
        for (const int panel : panels) found[{one.panel, panel}] += one.area;
    }
    return found;
}

} // namespace

void tell_thick_cloth(GarmentPattern& pattern, const std::vector<double>& in_space)
{
    double all = 0;
    for (const double area : in_space) all += area;
    const double spacing = std::max(2 * thickest, std::sqrt(2 * all / most_samples));
    if (spacing > 10 * thickest) return; // no garment is so large, which is told
    const Covered found = covered(samples_of(pattern, spacing), spacing);
    const auto share = [&](int one, int other) {
        const auto at = found.find({one, other});
        return at == found.end() ? 0.0 : at->second / in_space[one];
    };
    std::string first;
    int pairs = 0;
    for (const auto& [pair, area] : found) {
        const auto [one, other] = pair;
        if (one > other || share(one, other) < least_covered || share(other, one) < least_covered) continue;
        const auto name = [&](int panel) { return pattern.panels[panel].name; };
        if (++pairs > 1) continue;
        first = one == other ? fmt::format("The panel \"{}\" lies on itself", name(one))
                             : fmt::format("The panels \"{}\" and \"{}\" lie on each other", name(one), name(other));
    }
    if (pairs == 0) return;
    doubt(pattern, fmt::format("{}{} within {:g} mm, as the two faces of thick cloth do; each counts as cloth. Export the garment thin, "
                               "and as it is worn, not lying flat; further layers are a matter of \"layers\".",
                               first, pairs > 1 ? fmt::format(", and {} more pairs,", pairs - 1) : "", 1000 * thickest));
}

} // namespace hygroloom
