// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which triangles of a mesh hang together in flat coordinates, and the way round them: along sides that no two triangles share, however
// those lie or fold.
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
                    if (length(places_[cell->second] - place) <= tolerance_) return cell->second;
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
    while (parents[one] != one) {
        int& parent = parents[one];
        parent = parents[parent];
        one = parent;
    }
    return one;
}

void weld(const FlatMesh& mesh, FlatIslands& found)
{
    Vec3d least = mesh.places[mesh.triangles[0][0]], most = least;
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle) {
            const Vec3d& p = mesh.places[corner];
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
            const FlatPlace& uv = mesh.uv[mesh.uv_triangles[t][k]];
            const auto [at, fresh] = corners.try_emplace({welded[given], uv}, static_cast<int>(found.corners.size()));
            if (fresh) found.corners.push_back({welded[given], uv});
            triangle[k] = at->second;
        }
        found.triangles.push_back(triangle);
    }
    for (Vec3d& place : welder.places_) place += least;
    found.places = std::move(welder.places_);
}

/// What lies beyond the sides of triangles. Side 3 t + k goes from corner k of triangle t to the next.
class Sides {
public:
    explicit Sides(FlatIslands& found)
        : found_(found), beyond_(3 * found.triangles.size(), -1), seen_(found.triangles.size()), passed_(beyond_.size())
    {
    }

    /// Pairs sides, those that go opposite ways first, and makes islands of triangles that share one.
    void join();
    /// Turns an island's triangles to the way round that most have; where that cannot be, as on a Moebius strip, they part.
    void orient(Island& island);
    /// Goes round an island along the sides that have no partner.
    std::vector<std::vector<int>> loops(const Island& island);

private:
    struct Side {
        std::uint64_t ends;
        int number;
        bool operator<(const Side& other) const { return std::pair(ends, number) < std::pair(other.ends, other.number); }
    };
    std::array<int, 3>& triangle(int t) const { return found_.triangles[t]; }
    int from(int side) const { return triangle(side / 3)[side % 3]; }
    int& beyond(int side) { return beyond_[side]; }
    int beyond(int side) const { return beyond_[side]; }
    static int next(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
    std::vector<bool> counting() const;
    void pair(std::vector<int> sharing);
    void turn_over(int t);

    FlatIslands& found_;
    std::vector<int> beyond_;  ///< of each side the side of another triangle with the same ends; -1: none
    std::vector<bool> seen_;   ///< of each triangle: it was oriented
    std::vector<bool> passed_; ///< of each side: a loop goes along it
};

/// Which triangles count: their corners differ, and no earlier one has the same.
std::vector<bool> Sides::counting() const
{
    std::vector<std::pair<std::array<int, 3>, int>> all;
    for (int t = 0; t < static_cast<int>(found_.triangles.size()); ++t) {
        all.emplace_back(triangle(t), t);
        std::sort(all.back().first.begin(), all.back().first.end());
    }
    std::sort(all.begin(), all.end());
    std::vector<bool> counts(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::array<int, 3>& corners = all[i].first;
        if (corners[0] == corners[1] || corners[1] == corners[2]) continue;
        if (i > 0 && all[i - 1].first == corners)
            ++found_.doubled;
        else
            counts[all[i].second] = true;
    }
    return counts;
}

void Sides::pair(std::vector<int> sharing)
{
    while (sharing.size() > 1) {
        auto other = std::find_if(sharing.begin() + 1, sharing.end(), [&](int side) { return from(side) != from(sharing[0]); });
        if (other == sharing.end()) other = sharing.begin() + 1;
        beyond(sharing[0]) = *other;
        beyond(*other) = sharing[0];
        sharing.erase(other);
        sharing.erase(sharing.begin());
    }
}

void Sides::join()
{
    const std::vector<bool> counts = counting();
    std::vector<Side> sides;
    for (int side = 0; side < static_cast<int>(beyond_.size()); ++side) {
        if (!counts[side / 3]) continue;
        const auto [a, b] = std::minmax({from(side), from(next(side))});
        sides.push_back({key_of(a, b), side});
    }
    std::sort(sides.begin(), sides.end());
    std::vector<int> parents(counts.size()), sharing;
    std::iota(parents.begin(), parents.end(), 0);
    for (auto side = sides.begin(); side != sides.end();) {
        sharing.clear();
        const auto first = side;
        for (; side != sides.end() && side->ends == first->ends; ++side) {
            sharing.push_back(side->number);
            parents[static_cast<std::size_t>(root_of(parents, side->number / 3))] = root_of(parents, first->number / 3);
        }
        found_.shared_sides += sharing.size() > 2;
        pair(sharing);
    }
    std::map<int, std::size_t> numbers;
    for (int t = 0; t < static_cast<int>(found_.triangles.size()); ++t) {
        if (!counts[t]) continue;
        const auto [number, fresh] = numbers.try_emplace(root_of(parents, t), found_.islands.size());
        if (fresh) found_.islands.emplace_back();
        found_.islands[number->second].triangles.push_back(t);
    }
}

void Sides::turn_over(int t)
{
    std::swap(triangle(t)[1], triangle(t)[2]);
    std::swap(beyond(3 * t), beyond(3 * t + 2));
    for (const int side : {3 * t, 3 * t + 2})
        if (beyond(side) >= 0) beyond(beyond(side)) = side;
}

void Sides::orient(Island& island)
{
    for (const int first : island.triangles) {
        if (seen_[first]) continue;
        std::vector<int> piece{first}, turned;
        seen_[first] = true;
        for (std::size_t i = 0; i < piece.size(); ++i)
            for (int side = 3 * piece[i]; side < 3 * piece[i] + 3; ++side) {
                if (beyond(side) < 0) continue;
                const int across = beyond(side), other = across / 3;
                const bool against = from(across) == from(side); // both go the same way along it
                if (seen_[other]) {
                    if (against) beyond(across) = beyond(side) = -1;
                    continue;
                }
                if (against) {
                    turn_over(other);
                    turned.push_back(other);
                }
                seen_[other] = true;
                piece.push_back(other);
            }
        if (2 * turned.size() > piece.size()) {
            for (const int t : piece) turn_over(t);
            turned.resize(piece.size() - turned.size());
        }
        island.turned += static_cast<int>(turned.size());
    }
}

std::vector<std::vector<int>> Sides::loops(const Island& island)
{
    std::vector<std::vector<int>> all;
    for (const int t : island.triangles)
        for (int first = 3 * t; first < 3 * t + 3; ++first) {
            if (beyond(first) >= 0 || passed_[first]) continue;
            all.emplace_back();
            for (int side = first; !passed_[side];) {
                passed_[side] = true;
                all.back().push_back(from(side));
                for (side = next(side); beyond(side) >= 0;) side = next(beyond(side)); // round the corner, triangle by triangle
            }
        }
    return all;
}

/// Gives each island corners of its own, where two touch in one.
void part_corners(FlatIslands& found)
{
    std::vector<int> owner(found.corners.size(), -1);
    for (int i = 0; i < static_cast<int>(found.islands.size()); ++i) {
        std::map<int, int> copies;
        for (const int t : found.islands[i].triangles)
            for (int& corner : found.triangles[t]) {
                if (owner[corner] < 0) owner[corner] = i;
                if (owner[corner] == i) continue;
                const auto [copy, fresh] = copies.try_emplace(corner, static_cast<int>(found.corners.size()));
                if (fresh) {
                    found.corners.push_back(found.corners[corner]);
                    owner.push_back(i);
                }
                corner = copy->second;
            }
    }
}

/// Mirrors an island that is seen from inside, and finds the longest way round it.
void trace(FlatIslands& found, Island& island, Sides& sides)
{
    const auto uv = [&found](int corner) -> FlatPlace& { return found.corners[corner].uv; };
    const auto area = [&](int t) {
        const auto& [a, b, c] = found.triangles[t];
        return twice_area(uv(a), uv(b), uv(c));
    };
    double sum = 0;
    for (const int t : island.triangles) sum += area(t);
    island.mirrored = sum < 0;
    if (island.mirrored) {
        std::vector<int> corners;
        for (const int t : island.triangles) corners.insert(corners.end(), found.triangles[t].begin(), found.triangles[t].end());
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        for (const int corner : corners) uv(corner)[0] = -uv(corner)[0];
    }
    for (const int t : island.triangles) island.folded += area(t) < 0;
    double largest = 0;
    std::vector<std::vector<int>> loops = sides.loops(island);
    for (std::vector<int>& loop : loops) {
        double enclosed = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const FlatPlace &a = uv(loop[i]), &b = uv(loop[(i + 1) % loop.size()]);
            enclosed += a[0] * b[1] - a[1] * b[0];
        }
        if (loop.size() > 2) ++island.holes;
        if (std::abs(enclosed) <= largest) continue;
        largest = std::abs(enclosed);
        if (enclosed < 0) std::reverse(loop.begin(), loop.end());
        island.loop = std::move(loop);
    }
    island.holes = std::max(0, island.holes - 1);
}

} // namespace

FlatIslands islands_of(const FlatMesh& mesh, const std::string& name)
{
    FlatIslands found;
    weld(mesh, found);
    Sides sides(found);
    sides.join();
    constexpr std::size_t most_islands = 500;
    if (found.islands.size() > most_islands)
        throw FileError(fmt::format("{}: The flat coordinates make {} islands; a garment has up to {} panels.", name, found.islands.size(),
                                    most_islands));
    part_corners(found);
    for (Island& island : found.islands) {
        sides.orient(island);
        trace(found, island, sides);
    }
    return found;
}

} // namespace hygroloom
