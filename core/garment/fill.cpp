// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Ears are cut off the outline; edges are flipped until no circle through a triangle holds another place (Lawson 1977); the grid's places
// are then put in one by one, with flips round each.
#include "core/garment/fill.h"

#include "core/garment/ears.h"
#include "core/garment/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace hygroloom {

namespace {

constexpr double usual_spacing = 0.01;         // m
constexpr double most_places = 60000;          // of all panels' grids
constexpr std::size_t most_work = 200'000'000; // comparisons of all outlines
constexpr double most_filled_places = 20000;   // of a panel

/// Whether d lies inside the circle through a, b, c, which go round counter-clockwise.
bool in_circle(const FlatPlace& a, const FlatPlace& b, const FlatPlace& c, const FlatPlace& d)
{
    const double ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1], cx = c[0] - d[0], cy = c[1] - d[1];
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const double found = ax * (by * cc - bb * cy) - ay * (bx * cc - bb * cx) + aa * (bx * cy - by * cx);
    return found > 1e-12 * (aa * bb + bb * cc + cc * aa); // four places on a circle stay as they are
}

class Triangulation {
public:
    Triangulation(std::vector<FlatPlace> outline, double spacing) : places_(std::move(outline)), spacing_(spacing) {}

    bool cut(std::size_t& work) { return cut_ears(places_, corners_, work); }
    void join();
    void flip_all();
    void insert(const FlatPlace& place);
    FilledPanel result(bool whole) && { return {std::move(places_), std::move(corners_), whole}; }

private:
    const FlatPlace& at(int place) const { return places_[place]; }
    int containing(const FlatPlace& place);
    void flip_from(int triangle, int corner);
    int corner_towards(int triangle, int other) const;
    /// A triangle, where there is one, has another beyond the side over which the first was.
    void turn_to(int triangle, int from, int to)
    {
        if (triangle < 0) return;
        const int corner = corner_towards(triangle, from);
        if (corner < 3) beyond_[triangle][corner] = to;
    }

    std::vector<FlatPlace> places_;
    double spacing_;
    std::vector<std::array<int, 3>> corners_;
    std::vector<std::array<int, 3>> beyond_; ///< the triangle over the side that lies opposite each corner; -1: the outline
    int last_ = 0;
    std::vector<std::array<int, 2>> waiting_;
};

void Triangulation::join()
{
    beyond_.assign(corners_.size(), {-1, -1, -1});
    std::map<std::pair<int, int>, std::pair<int, int>> sides;
    for (int t = 0; t < static_cast<int>(corners_.size()); ++t)
        for (int k = 0; k < 3; ++k) {
            const auto& corner = corners_[t];
            const int from = corner[static_cast<std::size_t>((k + 1) % 3)], to = corner[static_cast<std::size_t>((k + 2) % 3)];
            sides[{from, to}] = {t, k};
            const auto other = sides.find({to, from});
            if (other == sides.end()) continue;
            beyond_[t][k] = other->second.first;
            beyond_[other->second.first][other->second.second] = t;
        }
}

int Triangulation::corner_towards(int triangle, int other) const
{
    const auto& beyond = beyond_[triangle];
    return static_cast<int>(std::find(beyond.begin(), beyond.end(), other) - beyond.begin());
}

/// Flips the side opposite a corner where the place beyond lies in the circle, and what that disturbs.
void Triangulation::flip_from(int triangle, int corner)
{
    waiting_.push_back({triangle, corner});
    std::size_t flips = 0;
    while (!waiting_.empty()) {
        const auto [t, k] = waiting_.back();
        waiting_.pop_back();
        const int u = beyond_[t][k];
        if (u < 0 || ++flips > 100000) continue;
        const int m = corner_towards(u, t);
        if (m > 2) continue;
        auto &own = corners_[t], &other = corners_[u];
        auto &own_beyond = beyond_[t], &other_beyond = beyond_[u];
        const auto k1 = static_cast<std::size_t>((k + 1) % 3), k2 = static_cast<std::size_t>((k + 2) % 3);
        const auto m1 = static_cast<std::size_t>((m + 1) % 3), m2 = static_cast<std::size_t>((m + 2) % 3);
        const int a = own[k], b = own[k1], c = own[k2], d = other[m];
        if (!in_circle(at(a), at(b), at(c), at(d))) continue;
        if (!(twice_area(at(a), at(b), at(d)) > 0 && twice_area(at(a), at(d), at(c)) > 0)) continue;
        // a-b-c and d-c-b become a-b-d and a-d-c.
        const int over_ab = own_beyond[k2], over_ca = own_beyond[k1], over_bd = other_beyond[m1], over_dc = other_beyond[m2];
        own = {a, b, d};
        own_beyond = {over_bd, u, over_ab};
        other = {a, d, c};
        other_beyond = {over_dc, over_ca, t};
        turn_to(over_bd, u, t);
        turn_to(over_ca, t, u);
        for (const std::array<int, 2> side : {std::array{t, 0}, std::array{t, 2}, std::array{u, 0}, std::array{u, 1}})
            waiting_.push_back(side);
    }
}

void Triangulation::flip_all()
{
    for (int t = 0; t < static_cast<int>(corners_.size()); ++t)
        for (int k = 0; k < 3; ++k) flip_from(t, k);
}

/// The triangle round a place, or -1. It walks there from the last, for places come in rows.
int Triangulation::containing(const FlatPlace& place)
{
    int t = last_;
    for (int steps = 0; steps < 1000 && t >= 0; ++steps) {
        const auto& corner = corners_[t];
        int out = -1;
        for (int k = 0; k < 3 && out < 0; ++k)
            if (twice_area(at(corner[static_cast<std::size_t>((k + 1) % 3)]), at(corner[static_cast<std::size_t>((k + 2) % 3)]), place) < 0)
                out = k;
        if (out < 0) return t;
        t = beyond_[t][out];
    }
    for (t = 0; t < static_cast<int>(corners_.size()); ++t) { // the way is barred by the outline
        const auto& corner = corners_[t];
        bool inside = true;
        for (std::size_t k = 0; k < 3 && inside; ++k) inside = twice_area(at(corner[k]), at(corner[(k + 1) % 3]), place) >= 0;
        if (inside) return t;
    }
    return -1;
}

void Triangulation::insert(const FlatPlace& place)
{
    const int t = containing(place);
    if (t < 0) return;
    last_ = t;
    const std::array<int, 3> corner = corners_[t], beyond = beyond_[t];
    for (std::size_t k = 0; k < 3; ++k) {
        const FlatPlace &a = at(corner[k]), &b = at(corner[(k + 1) % 3]);
        const double side = std::hypot(b[0] - a[0], b[1] - a[1]);
        const bool rim = beyond[(k + 2) % 3] < 0;
        if (twice_area(a, b, place) < (rim ? 0.4 : 0.01) * spacing_ * side) return; // it lies on the side, or near the outline
    }
    const int p = static_cast<int>(places_.size()), u = static_cast<int>(corners_.size()), v = u + 1;
    places_.push_back(place);
    corners_[t] = {p, corner[1], corner[2]};
    corners_.push_back({corner[0], p, corner[2]});
    corners_.push_back({corner[0], corner[1], p});
    beyond_[t] = {beyond[0], u, v};
    beyond_.push_back({t, beyond[1], v});
    beyond_.push_back({t, u, beyond[2]});
    turn_to(beyond[1], t, u);
    turn_to(beyond[2], t, v);
    flip_from(t, 0);
    flip_from(u, 1);
    flip_from(v, 2);
}

/// The outline with places at most a spacing apart, none twice in a row.
std::vector<FlatPlace> divided(const std::vector<FlatPlace>& outline, double spacing)
{
    std::vector<FlatPlace> places;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const FlatPlace &a = outline[i], &b = outline[(i + 1) % outline.size()];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        if (length < 1e-9) continue;
        const int parts = std::max(1, static_cast<int>(std::ceil(length / spacing - 1e-6)));
        for (int k = 0; k < parts; ++k) {
            const double share = static_cast<double>(k) / parts;
            places.push_back({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])});
        }
    }
    return places;
}

/// Where a row crosses the outline, in order.
std::vector<double> crossings(const std::vector<FlatPlace>& outline, double y)
{
    std::vector<double> found;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const FlatPlace &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if ((a[1] > y) != (b[1] > y)) found.push_back(a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]));
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace

FilledPanel filled(const PatternPanel& panel, double spacing, std::size_t& work)
{
    if (perimeter_of(panel) > most_filled_places * spacing) return {{}, {}, false};
    const std::vector<FlatPlace> outline = divided(outline_of(panel), spacing);
    if (outline.size() < 3 || static_cast<double>(outline.size()) > most_filled_places) return {{}, {}, false};
    double least = outline[0][1], most = least;
    for (const FlatPlace& place : outline) {
        least = std::min(least, place[1]);
        most = std::max(most, place[1]);
    }
    Triangulation triangles(outline, spacing);
    if (!triangles.cut(work)) return {{}, {}, false};
    triangles.join();
    triangles.flip_all();
    int row = 0;
    const double step = spacing * std::sqrt(0.75); // rows of equilateral triangles
    for (double y = least + 0.37 * step; y < most; y += step, ++row) {
        const std::vector<double> rims = crossings(outline, y);
        for (std::size_t i = 0; i + 1 < rims.size(); i += 2) {
            const double shift = (row % 2 ? 0.23 : 0.73) * spacing;
            for (double x = std::ceil((rims[i] - shift) / spacing) * spacing + shift; x < rims[i + 1]; x += spacing)
                triangles.insert({x, y});
        }
    }
    return std::move(triangles).result(true);
}

double fill_spacing(const GarmentPattern& pattern)
{
    double area = 0;
    for (const PatternPanel& panel : pattern.panels) area += area_of(panel);
    return std::max(usual_spacing, std::sqrt(area / most_places));
}

void make_shape(GarmentPattern& pattern, const std::function<Vec3d(int, const FlatPlace&)>& to_space)
{
    const double spacing = fill_spacing(pattern);
    std::size_t work = most_work;
    pattern.shape = {};
    for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
        const PatternPanel& panel = pattern.panels[p];
        const FilledPanel flat = filled(panel, spacing, work);
        if (!flat.whole)
            pattern.issues.push_back(fmt::format(
                "The panel \"{}\" cannot be filled, since its outline crosses itself or is too large; it is not shown.", panel.name));
        const int first = static_cast<int>(pattern.shape.flat.size());
        for (const FlatPlace& place : flat.flat) {
            pattern.shape.flat.push_back(place);
            pattern.shape.places.push_back(to_space(p, place));
        }
        for (const auto& [a, b, c] : flat.triangles) {
            pattern.shape.triangles.push_back({first + a, first + b, first + c});
            pattern.shape.panel.push_back(p);
        }
    }
}

void make_flat_shape(GarmentPattern& pattern)
{
    make_shape(pattern, [&pattern](int panel, const FlatPlace& flat) { return in_space(pattern.panels[panel], flat); });
}

} // namespace hygroloom
