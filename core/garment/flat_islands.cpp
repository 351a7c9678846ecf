// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/garment/flat_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <unordered_map>

namespace hygroloom {

namespace {

std::uint64_t key_of(int a, int b)
{
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
}

struct CellHash {
    std::size_t operator()(const std::array<std::int64_t, 3>& cell) const
    {
        std::uint64_t hash = 1469598103934665603u;
        for (const std::int64_t part : cell) hash = (hash ^ static_cast<std::uint64_t>(part)) * 1099511628211u;
        return hash ^ hash >> 29;
    }
};

/// Of each place the first that lies as near as the tolerance.
class Welder {
public:
    explicit Welder(double tolerance) : tolerance_(tolerance) {}
    int weld(const Vec3d& place)
    {
        const std::array<std::int64_t, 3> own = cell_of(place);
        for (std::int64_t x = -1; x <= 1; ++x)
            for (std::int64_t y = -1; y <= 1; ++y)
                for (std::int64_t z = -1; z <= 1; ++z) {
                    const auto cell = cells_.find({own[0] + x, own[1] + y, own[2] + z});
                    if (cell == cells_.end()) continue;
                    if (length(places_[static_cast<std::size_t>(cell->second)] - place) <= tolerance_) return cell->second;
                }
        cells_.emplace(own, static_cast<int>(places_.size()));
        places_.push_back(place);
        return static_cast<int>(places_.size()) - 1;
    }
    std::vector<Vec3d> places_;

private:
    std::array<std::int64_t, 3> cell_of(const Vec3d& p) const
    {
        return {std::llround(p.x / tolerance_), std::llround(p.y / tolerance_), std::llround(p.z / tolerance_)};
    }
    double tolerance_;
    std::unordered_map<std::array<std::int64_t, 3>, int, CellHash> cells_;
};

int root_of(std::vector<int>& parents, int one)
{
    while (parents[static_cast<std::size_t>(one)] != one) {
        int& parent = parents[static_cast<std::size_t>(one)];
        parent = parents[static_cast<std::size_t>(parent)];
        one = parent;
    }
    return one;
}

void weld(const FlatMesh& mesh, FlatIslands& found)
{
    Vec3d least = mesh.places[static_cast<std::size_t>(mesh.triangles[0][0])], most = least;
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle) {
            const Vec3d& p = mesh.places[static_cast<std::size_t>(corner)];
            least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
            most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
        }
    Welder welder(std::max(1e-5 * length(most - least), 1e-30));
    std::vector<int> welded(mesh.places.size(), -1);
    std::map<std::pair<int, FlatPlace>, int> corners;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<int, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto given = static_cast<std::size_t>(mesh.triangles[t][k]);
            if (welded[given] < 0) {
                welded[given] = welder.weld(mesh.places[given] - least);
                if (welded[given] == static_cast<int>(found.first_place.size())) found.first_place.push_back(static_cast<int>(given));
            }
            const FlatPlace& uv = mesh.uv[static_cast<std::size_t>(mesh.uv_triangles[t][k])];
            const auto [at, fresh] = corners.try_emplace({welded[given], uv}, static_cast<int>(found.corners.size()));
            if (fresh) found.corners.push_back({welded[given], uv});
            triangle[k] = at->second;
        }
        found.triangles.push_back(triangle);
    }
    for (Vec3d& place : welder.places_) place += least;
    found.places = std::move(welder.places_);
}

/// Triangles that share a side are of one island.
void part(FlatIslands& found)
{
    std::vector<int> parents(found.triangles.size());
    std::iota(parents.begin(), parents.end(), 0);
    std::unordered_map<std::uint64_t, std::pair<int, int>> sides; // first triangle, how many
    for (int t = 0; t < static_cast<int>(found.triangles.size()); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& triangle = found.triangles[static_cast<std::size_t>(t)];
            const int a = triangle[k], b = triangle[(k + 1) % 3];
            const auto [side, fresh] = sides.try_emplace(key_of(std::min(a, b), std::max(a, b)), t, 0);
            if (++side->second.second == 3) ++found.shared_sides;
            if (!fresh) parents[static_cast<std::size_t>(root_of(parents, t))] = root_of(parents, side->second.first);
        }
    std::map<int, std::size_t> numbers;
    for (int t = 0; t < static_cast<int>(found.triangles.size()); ++t) {
        const auto [number, fresh] = numbers.try_emplace(root_of(parents, t), found.islands.size());
        if (fresh) found.islands.emplace_back();
        found.islands[number->second].triangles.push_back(t);
    }
}

/// Mirrors an island that is seen from inside, and finds the longest way round it.
void trace(FlatIslands& found, Island& island)
{
    const auto uv = [&found](int corner) -> FlatPlace& { return found.corners[static_cast<std::size_t>(corner)].uv; };
    const auto area = [&](int t) {
        const auto& [a, b, c] = found.triangles[static_cast<std::size_t>(t)];
        return twice_area(uv(a), uv(b), uv(c));
    };
    double sum = 0;
    for (const int t : island.triangles) sum += area(t);
    island.mirrored = sum < 0;
    if (island.mirrored) {
        std::vector<int> corners;
        for (const int t : island.triangles)
            corners.insert(corners.end(), found.triangles[static_cast<std::size_t>(t)].begin(),
                           found.triangles[static_cast<std::size_t>(t)].end());
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        for (const int corner : corners) uv(corner)[0] = -uv(corner)[0];
    }
    std::map<std::pair<int, int>, int> sides; // directed; how often
    for (const int t : island.triangles) {
        auto [a, b, c] = found.triangles[static_cast<std::size_t>(t)];
        if (area(t) < 0) {
            ++island.folded;
            std::swap(b, c);
        }
        for (const auto& side : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++sides[side];
    }
    std::multimap<int, int> next;
    for (const auto& [side, times] : sides)
        if (!sides.contains({side.second, side.first})) next.emplace(side.first, side.second);
    double largest = 0;
    int loops = 0;
    while (!next.empty()) {
        std::vector<int> loop;
        for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
            if (loop.empty()) loop.push_back(at->first);
            const int to = at->second;
            next.erase(at);
            if (to == loop.front()) break;
            loop.push_back(to);
        }
        double enclosed = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const FlatPlace &a = uv(loop[i]), &b = uv(loop[(i + 1) % loop.size()]);
            enclosed += a[0] * b[1] - a[1] * b[0];
        }
        if (loop.size() > 2) ++loops;
        if (std::abs(enclosed) > largest) {
            largest = std::abs(enclosed);
            island.loop = std::move(loop);
        }
    }
    island.holes = std::max(0, loops - 1);
}

} // namespace

FlatIslands islands_of(const FlatMesh& mesh, const std::string& name)
{
    FlatIslands found;
    weld(mesh, found);
    part(found);
    constexpr std::size_t most_islands = 500;
    if (found.islands.size() > most_islands)
        throw FileError(fmt::format("{}: The flat coordinates make {} islands; a garment has up to {} panels.", name, found.islands.size(),
                                    most_islands));
    for (Island& island : found.islands) trace(found, island);
    return found;
}

namespace {

constexpr double most_stretch = 1.25,
                 most_unlike_share = 0.1; // of worn cloth, and of all of it: beyond, islands have scales of their own; assumptions

/// m of a unit of an island's flat coordinates across and along, that give its sides their lengths in space by least squares; 0: none do.
std::array<double, 2> scales_of(const FlatIslands& islands, const Island& island)
{
    double xx = 0, xy = 0, yy = 0, sum_x = 0, sum_y = 0;
    for (const int t : island.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& triangle = islands.triangles[static_cast<std::size_t>(t)];
            const FlatCorner &a = islands.corners[static_cast<std::size_t>(triangle[k])],
                             &b = islands.corners[static_cast<std::size_t>(triangle[(k + 1) % 3])];
            const double space =
                length(islands.places[static_cast<std::size_t>(a.place)] - islands.places[static_cast<std::size_t>(b.place)]);
            if (!(space > 0)) continue;
            const double x = std::pow((a.uv[0] - b.uv[0]) / space, 2), y = std::pow((a.uv[1] - b.uv[1]) / space, 2);
            xx += x * x;
            xy += x * y;
            yy += y * y;
            sum_x += x;
            sum_y += y;
        }
    const double whole = xx * yy - xy * xy, across = sum_x * yy - sum_y * xy, along = sum_y * xx - sum_x * xy;
    if (!(whole > 0 && across > 0 && along > 0)) return {};
    return {std::sqrt(across / whole), std::sqrt(along / whole)};
}

/// m2 in space.
double area_of(const FlatIslands& islands, const Island& island)
{
    const auto place = [&](int corner) {
        return islands.places[static_cast<std::size_t>(islands.corners[static_cast<std::size_t>(corner)].place)];
    };
    double area = 0;
    for (const int t : island.triangles) {
        const auto& [a, b, c] = islands.triangles[static_cast<std::size_t>(t)];
        area += 0.5 * length(cross(place(b) - place(a), place(c) - place(a)));
    }
    return area;
}

/// Corners that two islands share go with the first.
void scale_islands(FlatIslands& islands, const std::vector<std::array<double, 2>>& by)
{
    std::vector<bool> done(islands.corners.size());
    for (std::size_t i = 0; i < by.size(); ++i)
        for (const int t : islands.islands[i].triangles)
            for (const int corner : islands.triangles[static_cast<std::size_t>(t)]) {
                const auto at = static_cast<std::size_t>(corner);
                for (std::size_t axis = 0; axis < 2 && !done[at]; ++axis) islands.corners[at].uv[axis] *= by[i][axis];
                done[at] = true;
            }
}

} // namespace

bool take_own_scales(FlatIslands& islands, double common)
{
    const auto is_unlike = [&](double own) { return own > most_stretch * common || own < common / most_stretch; };
    double all = 0, unlike = 0; // m2
    std::vector<std::array<double, 2>> scales;
    for (const Island& island : islands.islands) {
        std::array<double, 2> own = scales_of(islands, island);
        if (!(own[0] > 0)) own = {common, common};
        const double area = area_of(islands, island);
        all += area;
        if (is_unlike(own[0]) || is_unlike(own[1])) unlike += area;
        scales.push_back(own);
    }
    if (unlike <= most_unlike_share * all) return false;
    scale_islands(islands, scales);
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
