// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/droplet.h"

#include <algorithm>
#include <cmath>

namespace hygroloom::inline HL_PRECISION {

std::vector<Vec3d> droplet_lattice(int count, double spacing)
{
    const int reach = static_cast<int>(std::ceil(std::cbrt(count * 0.2387) + 2.0)); // radius of the ball of that volume, and a margin
    std::vector<Vec3d> places;
    for (int k = -reach; k < reach; ++k)
        for (int j = -reach; j < reach; ++j)
            for (int i = -reach; i < reach; ++i) places.push_back({i + 0.5, j + 0.5, k + 0.5});
    // A point off every symmetry plane breaks ties the same way everywhere.
    const Vec3d middle{1e-3, 2e-3, 3e-3};
    const auto distance = [&](const Vec3d& p) { return dot(p - middle, p - middle); };
    std::nth_element(places.begin(), places.begin() + count, places.end(),
                     [&](const Vec3d& a, const Vec3d& b) { return distance(a) < distance(b); });
    places.resize(static_cast<std::size_t>(count));
    std::sort(places.begin(), places.end(), [](const Vec3d& a, const Vec3d& b) {
        return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
    });
    for (Vec3d& p : places) p = spacing * p;
    return places;
}

double height_clear_of(std::span<const Vec3> particles, const Vec3d& centre, double radius, double spacing)
{
    double height = centre.z;
    for (const Vec3& p : particles)
        if (std::hypot(static_cast<double>(p.x) - centre.x, static_cast<double>(p.y) - centre.y) <= radius + spacing)
            height = std::max(height, static_cast<double>(p.z) + spacing + radius);
    return height;
}

} // namespace hygroloom::inline HL_PRECISION
