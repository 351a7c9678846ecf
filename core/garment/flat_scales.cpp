// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How long flat coordinates are in space. Middles by area: an edge that is short in space, as where cloth is pinched, weighs no more than
// the cloth around it.
#include "core/garment/flat_mesh.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

// Assumptions.
constexpr double most_stretch = 1.25;     // of worn cloth: beyond, an island has a scale of its own
constexpr double most_apart_alike = 1.03; // the same where islands are all of one extent
constexpr double most_unlike_share = 0.1; // of all cloth: beyond, all islands have scales of their own
constexpr double most_deviations = 4;     // median ones, of areas within an island: triangles beyond do not count

struct Weighed {
    double value = 0, weight = 0;
};

/// The value that half of the weight lies below; between two of them the mean.
double middle_of(std::vector<Weighed> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end(), [](const Weighed& a, const Weighed& b) { return a.value < b.value; });
    double all = 0, below = 0;
    for (const Weighed& one : values) all += one.weight;
    for (std::size_t i = 0; i < values.size(); ++i) {
        below += values[i].weight;
        if (below < (0.5 - 1e-6) * all) continue;
        const bool between = below < (0.5 + 1e-6) * all && i + 1 < values.size();
        return between ? 0.5 * (values[i].value + values[i + 1].value) : values[i].value;
    }
    return values.back().value;
}

/// What a triangle says of the scale: lengths in space of a unit of flat coordinates across and along, and areas of both kinds.
struct Stretch {
    double across = 0, along = 0, flat = 0, space = 0;
};

Vec3d place_of(const FlatIslands& islands, int corner) { return islands.places[static_cast<std::size_t>(islands.corners[corner].place)]; }

/// Of the triangles that have a flat area.
std::vector<Stretch> stretches_of(const FlatIslands& islands, const Island& island)
{
    std::vector<Stretch> found;
    for (const int t : island.triangles) {
        const auto& [a, b, c] = islands.triangles[t];
        const auto uv = [&](int corner) { return islands.corners[corner].uv; };
        const Vec3d p = place_of(islands, b) - place_of(islands, a), q = place_of(islands, c) - place_of(islands, a);
        const double pu = uv(b)[0] - uv(a)[0], pv = uv(b)[1] - uv(a)[1], qu = uv(c)[0] - uv(a)[0], qv = uv(c)[1] - uv(a)[1];
        const double twice = std::abs(pu * qv - qu * pv);
        if (!(twice > 0)) continue;
        const Stretch one{length(qv * p - pv * q) / twice, length(pu * q - qu * p) / twice, 0.5 * twice, 0.5 * length(cross(p, q))};
        if (std::isfinite(one.across) && std::isfinite(one.along)) found.push_back(one);
    }
    return found;
}

double sum_of(const std::vector<Stretch>& stretches, double Stretch::*part)
{
    double sum = 0;
    for (const Stretch& one : stretches) sum += one.*part;
    return sum;
}

std::vector<Weighed> weighed(const std::vector<Stretch>& stretches, double Stretch::*part)
{
    std::vector<Weighed> values;
    for (const Stretch& one : stretches) values.push_back({one.*part, one.flat});
    return values;
}

/// m of a unit across and along that give an island its lengths in space, and the area of all of it but what is pinched or pulled; 0:
/// none do.
std::array<double, 2> scales_of(const std::vector<Stretch>& stretches)
{
    const double across = middle_of(weighed(stretches, &Stretch::across)), along = middle_of(weighed(stretches, &Stretch::along));
    if (!(across > 0 && along > 0)) return {};
    std::vector<Weighed> logs, off; // of areas in space by flat areas
    for (const Stretch& one : stretches) logs.push_back({std::log(std::max(one.space / one.flat, 1e-300)), one.flat});
    const double middle = middle_of(logs);
    for (const Weighed& one : logs) off.push_back({std::abs(one.value - middle), one.weight});
    const double most = most_deviations * middle_of(off) + 1e-6;
    double flat = 0, space = 0;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        if (off[i].value > most) continue;
        flat += stretches[i].flat;
        space += stretches[i].space;
    }
    const double by = std::sqrt(space / flat / (across * along));
    return {by * across, by * along};
}

/// Whether the islands' larger extents in flat coordinates are the same, as where each fills a texture.
bool fill_alike(const FlatIslands& islands)
{
    double least = 1e300, most = 0;
    for (const Island& island : islands.islands) {
        FlatPlace low{1e300, 1e300}, high{-1e300, -1e300};
        for (const int corner : island.loop)
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const double at = islands.corners[corner].uv[axis];
                low[axis] = std::min(low[axis], at);
                high[axis] = std::max(high[axis], at);
            }
        const double extent = std::max(high[0] - low[0], high[1] - low[1]);
        least = std::min(least, extent);
        most = std::max(most, extent);
    }
    return islands.islands.size() > 1 && most <= 1.005 * least;
}

/// Whether one is so many times the other, or more.
bool are_apart(double one, double other, double times) { return one > times * other || other > times * one; }

void scale(FlatIslands& islands, const Island& island, const std::array<double, 2>& by, std::vector<bool>& done)
{
    for (const int t : island.triangles)
        for (const int corner : islands.triangles[t]) {
            const auto at = static_cast<std::size_t>(corner);
            for (std::size_t axis = 0; axis < 2 && !done[at]; ++axis) islands.corners[at].uv[axis] *= by[axis];
            done[at] = true;
        }
}

} // namespace

double area_in_space(const FlatIslands& islands, const Island& island)
{
    double area = 0;
    for (const int t : island.triangles) {
        const auto& [a, b, c] = islands.triangles[t];
        area += 0.5 * length(cross(place_of(islands, b) - place_of(islands, a), place_of(islands, c) - place_of(islands, a)));
    }
    return area;
}

FlatScale common_scale(const FlatIslands& islands)
{
    std::vector<Weighed> both, each;
    for (const Island& island : islands.islands) {
        const std::vector<Stretch> stretches = stretches_of(islands, island);
        const double per_flat = sum_of(stretches, &Stretch::space) / sum_of(stretches, &Stretch::flat);
        for (const Stretch& one : stretches) {
            if (!(one.across > 0 && one.along > 0)) continue;
            both.push_back({std::sqrt(one.across * one.along), per_flat * one.flat});
            for (const double value : {one.across, one.along}) each.push_back({value, per_flat * one.flat});
        }
    }
    const double middle = middle_of(std::move(both));
    if (!(middle > 0)) return {};
    for (Weighed& one : each) one.value = std::abs(one.value / middle - 1);
    return {middle, middle_of(std::move(each))};
}

bool take_own_scales(FlatIslands& islands, double common)
{
    const double apart = fill_alike(islands) ? most_apart_alike : most_stretch;
    double all = 0, unlike = 0; // m2
    std::vector<std::array<double, 2>> scales;
    for (const Island& island : islands.islands) {
        std::array<double, 2> own = scales_of(stretches_of(islands, island));
        if (!(own[0] > 0)) own = {common, common};
        const double area = area_in_space(islands, island);
        all += area;
        // By area, for a panel that is worn stretched across gets narrower; or by its shape, which no stretch makes so.
        if (are_apart(std::sqrt(own[0] * own[1]), common, apart) || are_apart(own[0], own[1], most_stretch * most_stretch)) unlike += area;
        scales.push_back(own);
    }
    if (unlike <= most_unlike_share * all) return false;
    std::vector<bool> done(islands.corners.size());
    for (std::size_t i = 0; i < scales.size(); ++i) scale(islands, islands.islands[i], scales[i], done);
    return true;
}

double median_of(std::vector<double> numbers)
{
    if (numbers.empty()) return 0;
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}

double spread_of(const std::vector<double>& numbers)
{
    const double middle = median_of(numbers);
    if (middle == 0) return 0;
    std::vector<double> off;
    off.reserve(numbers.size());
    for (const double number : numbers) off.push_back(std::abs(number / middle - 1));
    return median_of(std::move(off));
}

} // namespace hygroloom
