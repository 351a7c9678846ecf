// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/stain_shape.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

using Point = std::array<double, 2>;
constexpr int sectors = 72;

double middle_of(int sector) { return (2 * sector + 1) * pi / sectors - pi; } // rad

/// The amplitude of cos 4 phi in a radius by sectors, over the mean radius.
template <typename Radius> double four_fold(const Radius& radius)
{
    double sum = 0, part = 0;
    for (int k = 0; k < sectors; ++k) {
        sum += radius(k);
        part += radius(k) * std::cos(4 * middle_of(k));
    }
    return 2 * part / sum;
}

/// By the monotone chain (Andrew 1979); of the shoelace formula.
double area_of_hull(std::vector<Point> points)
{
    std::sort(points.begin(), points.end());
    std::vector<Point> hull;
    const auto turns_left = [](const Point& a, const Point& b, const Point& c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
    };
    for (int side = 0; side < 2; ++side) {
        const std::size_t begins = hull.size();
        for (const Point& p : points) {
            while (hull.size() >= begins + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back(); // the other side begins with it
        std::reverse(points.begin(), points.end());
    }
    double twice = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point &a = hull[i], &b = hull[(i + 1) % hull.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return 0.5 * twice;
}

} // namespace

std::optional<StainShape> stain_shape(const std::vector<Point>& places, double cell_x, double cell_y)
{
    constexpr std::size_t least = 12;
    constexpr int parts = 4; // of a cell along each axis
    if (places.size() < least) return std::nullopt;
    Point middle{0, 0};
    for (const Point& p : places)
        for (std::size_t axis : {0, 1}) middle[axis] += p[axis] / static_cast<double>(places.size());
    std::array<double, sectors> areas{}; // m2
    Point squares{cell_x * cell_x / 12, cell_y * cell_y / 12};
    std::vector<Point> corners;
    for (const Point& p : places) {
        const double x = p[0] - middle[0], y = p[1] - middle[1];
        squares[0] += x * x / static_cast<double>(places.size());
        squares[1] += y * y / static_cast<double>(places.size());
        for (double side : {-0.5, 0.5})
            for (double tip : {-0.5, 0.5}) corners.push_back({x + side * cell_x, y + tip * cell_y});
        for (int k = 0; k < parts * parts; ++k) {
            const double angle = std::atan2(y + ((k / parts + 0.5) / parts - 0.5) * cell_y, x + ((k % parts + 0.5) / parts - 0.5) * cell_x);
            const auto sector = static_cast<std::size_t>((angle / (2 * pi) + 0.5) * sectors) % sectors;
            areas[sector] += cell_x * cell_y / (parts * parts);
        }
    }
    const double across = std::sqrt(squares[0]), along = std::sqrt(squares[1]);
    const double outline = four_fold([&](int k) { return std::sqrt(areas[static_cast<std::size_t>(k)]); });
    const double ellipse =
        four_fold([&](int k) { return 1 / std::hypot(std::cos(middle_of(k)) / across, std::sin(middle_of(k)) / along); });
    const double area = cell_x * cell_y * static_cast<double>(places.size());
    return StainShape{std::max(across, along) / std::min(across, along), outline - ellipse, area / area_of_hull(std::move(corners))};
}

} // namespace hygroloom
