// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/garment/outline.h"

#include "core/base/units.h"

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int most_pieces = 4096;
constexpr std::size_t most_comparisons = 50'000'000;

double distance(const FlatPlace& a, const FlatPlace& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

double off_chord(const FlatPlace& a, const FlatPlace& b, const FlatPlace& p)
{
    const double chord = distance(a, b);
    if (chord == 0) return distance(a, p);
    return std::abs((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / chord;
}

double side_of(const FlatPlace& a, const FlatPlace& b, const FlatPlace& p)
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

bool cross(const FlatPlace& a, const FlatPlace& b, const FlatPlace& c, const FlatPlace& d)
{
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

} // namespace

std::vector<FlatPlace> flattened(const std::function<FlatPlace(double)>& curve)
{
    std::vector<FlatPlace> places;
    for (int pieces = 1; pieces <= most_pieces; pieces *= 2) {
        places.clear();
        for (int i = 0; i <= pieces; ++i) places.push_back(curve(static_cast<double>(i) / pieces));
        double off = 0;
        // At a quarter as well: an S-shaped piece passes through the middle of its chord.
        for (int i = 0; i < pieces; ++i)
            for (const double part : {0.25, 0.5, 0.75})
                off = std::max(off, off_chord(places[i], places[static_cast<std::size_t>(i) + 1], curve((i + part) / pieces)));
        if (pieces > 1 && off <= 0.5 * flattening_m) break;
    }
    return places;
}

std::vector<FlatPlace> flattened_bezier(const FlatPlace& from, const std::vector<FlatPlace>& controls, const FlatPlace& to)
{
    std::vector<FlatPlace> all{from};
    all.insert(all.end(), controls.begin(), controls.end());
    all.push_back(to);
    return flattened([&all](double t) {
        std::vector<FlatPlace> places = all; // de Casteljau
        for (std::size_t left = places.size() - 1; left > 0; --left)
            for (std::size_t i = 0; i < left; ++i)
                for (std::size_t axis = 0; axis < 2; ++axis) places[i][axis] += t * (places[i + 1][axis] - places[i][axis]);
        return t == 1 ? all.back() : places[0];
    });
}

std::vector<FlatPlace> flattened_arc(const FlatPlace& from, const FlatPlace& to, double radius, bool large, bool to_the_right)
{
    const double chord = distance(from, to), half = 0.5 * chord;
    const double r = std::max(radius, half);
    const FlatPlace along{(to[0] - from[0]) / chord, (to[1] - from[1]) / chord};
    const double turn = 2 * (large ? pi - std::asin(half / r) : std::asin(half / r));
    const double side = to_the_right ? -1 : 1;
    // Begin and end lie at turn/2 either way of the top of the arc, which is over the middle of the chord.
    const double height = r * std::cos(0.5 * turn);
    return flattened([=](double t) {
        if (t == 0) return from;
        if (t == 1) return to;
        const double angle = (t - 0.5) * turn;
        const double a = half + r * std::sin(angle), b = side * (r * std::cos(angle) - height);
        return FlatPlace{from[0] + a * along[0] - b * along[1], from[1] + a * along[1] + b * along[0]};
    });
}

std::vector<FlatPlace> outline_of(const PatternPanel& panel)
{
    std::vector<FlatPlace> outline;
    for (const PanelEdge& edge : panel.edges) outline.insert(outline.end(), edge.places.begin(), edge.places.end() - 1);
    return outline;
}

double length_of(const PanelEdge& edge)
{
    double length = 0;
    for (std::size_t i = 1; i < edge.places.size(); ++i) length += distance(edge.places[i - 1], edge.places[i]);
    return length;
}

double signed_area(const std::vector<FlatPlace>& outline)
{
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const FlatPlace &a = outline[i], &b = outline[(i + 1) % outline.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return 0.5 * twice;
}

bool crosses_itself(const std::vector<FlatPlace>& outline, std::size_t& done)
{
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i + 2 < count; ++i) {
        const FlatPlace &a = outline[i], &b = outline[i + 1];
        for (std::size_t k = i + 2; k < count; ++k) {
            if (++done > most_comparisons) return false;
            if (i == 0 && k + 1 == count) continue; // they share the first place
            if (cross(a, b, outline[k], outline[(k + 1) % count])) return true;
        }
    }
    return false;
}

double area_of(const PatternPanel& panel) { return std::abs(signed_area(outline_of(panel))); }

double perimeter_of(const PatternPanel& panel)
{
    double length = 0;
    for (const PanelEdge& edge : panel.edges) length += length_of(edge);
    return length;
}

} // namespace hygroloom
