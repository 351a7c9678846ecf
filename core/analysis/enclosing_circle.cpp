// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Welzl's move-to-front method without recursion: each point outside the circle so far lies on the new one.
#include "core/analysis/metrics.h"

#include "core/base/random.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

using Point = std::array<double, 2>;

bool contains(const Circle& c, const Point& p)
{
    const double x = p[0] - c.x, y = p[1] - c.y, reach = c.radius * (1.0 + 1e-12) + 1e-15;
    return x * x + y * y <= reach * reach;
}

Circle circle_through(const Point& a, const Point& b)
{
    return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * std::hypot(a[0] - b[0], a[1] - b[1])};
}

Circle circle_through(const Point& a, const Point& b, const Point& c)
{
    const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
    const double twice_area = 2.0 * (bx * cy - by * cx);
    if (std::abs(twice_area) <= 1e-14 * (bx * bx + by * by + cx * cx + cy * cy)) { // on one line: the two farthest apart
        Circle widest = circle_through(a, b);
        for (const Circle& other : {circle_through(a, c), circle_through(b, c)})
            if (other.radius > widest.radius) widest = other;
        return widest;
    }
    const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    const double x = (cy * b2 - by * c2) / twice_area, y = (bx * c2 - cx * b2) / twice_area;
    return {a[0] + x, a[1] + y, std::hypot(x, y)};
}

} // namespace

Circle smallest_enclosing_circle(const std::vector<Point>& given)
{
    if (given.empty()) return {0, 0, -1};
    std::vector<Point> points = given;
    for (std::size_t i = points.size() - 1; i > 0; --i) std::swap(points[i], points[random_bits(1, 0, i) % (i + 1)]);

    Circle circle{points[0][0], points[0][1], 0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (contains(circle, points[i])) continue;
        circle = {points[i][0], points[i][1], 0};
        for (std::size_t j = 0; j < i; ++j) {
            if (contains(circle, points[j])) continue;
            circle = circle_through(points[i], points[j]);
            for (std::size_t k = 0; k < j; ++k)
                if (!contains(circle, points[k])) circle = circle_through(points[i], points[j], points[k]);
        }
    }
    return circle;
}

} // namespace hygroloom
