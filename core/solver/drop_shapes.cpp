// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/drop_shapes.h"

#include "core/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {
namespace {

/// Along the outline from the top: distance from the axis, depth, angle with the plate, and integrals over the volume above.
enum { radius, depth, angle, volume, depth_moment, square_moment, quantities };
using Outline = std::array<double, quantities>;

Outline slope(const Outline& at, double top_curvature, double weight)
{
    const double up = std::sin(at[angle]), out = std::cos(at[angle]);
    const double around = at[radius] > 0 ? up / at[radius] : top_curvature; // the other curvature
    const double disc = pi * at[radius] * at[radius] * up;
    return {out, up, 2.0 * top_curvature + weight * at[depth] - around, disc, disc * at[depth], disc * 0.5 * at[radius] * at[radius]};
}

Outline sum(const Outline& a, double factor, const Outline& b)
{
    Outline result;
    for (std::size_t i = 0; i < quantities; ++i) result[i] = a[i] + factor * b[i];
    return result;
}

/// Runge and Kutta's fourth order.
Outline step(const Outline& at, double way, double top_curvature, double weight)
{
    const auto of = [&](const Outline& place) { return slope(place, top_curvature, weight); };
    const Outline a = of(at), b = of(sum(at, 0.5 * way, a)), c = of(sum(at, 0.5 * way, b)), d = of(sum(at, way, c));
    return sum(sum(sum(sum(at, way / 6.0, a), way / 3.0, b), way / 3.0, c), way / 6.0, d);
}

/// Where a falling function of a positive number takes a value; it lies near or below the guess.
template <typename F> double where_falls_to(double value, double guess, const F& function)
{
    double low = guess, high = guess;
    while (function(high) > value) high *= 2.0;
    while (low > 1e-100 && function(low) < value) low *= 0.5;
    for (int k = 0; k < 60; ++k) {
        const double middle = std::sqrt(low * high);
        (function(middle) > value ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

} // namespace

std::vector<DropOnPlate> drops_of_top(double top_curvature, std::span<const double> contact_angles, double weight)
{
    const double longest = 0.02 / (top_curvature + std::sqrt(weight));
    std::vector<DropOnPlate> drops;
    Outline at{};
    for (double wanted : contact_angles) {
        for (double left = wanted - at[angle]; std::abs(left) > 1e-12; left = wanted - at[angle])
            at = step(at, std::min(longest, left / slope(at, top_curvature, weight)[angle]), top_curvature, weight);
        drops.push_back({at[volume], at[radius], at[depth], at[depth] - at[depth_moment] / at[volume], at[square_moment] / at[volume],
                         wanted, top_curvature});
    }
    return drops;
}

DropOnPlate drop_of_top(double top_curvature, double contact_angle, double weight)
{
    return drops_of_top(top_curvature, std::array{contact_angle}, weight)[0];
}

DropOnPlate drop_of_volume(double volume, double contact_angle, double weight)
{
    const auto of = [&](double top_curvature) { return drop_of_top(top_curvature, contact_angle, weight); };
    return of(where_falls_to(volume, 1.0 / std::cbrt(volume), [&](double c) { return of(c).volume; }));
}

DropOnPlate drop_like(double middle, double square, double weight)
{
    // With its middle that high, a drop is the wider the smaller its angle; heavy ones of small angles are never that high.
    const double flattest = 1e-6 * std::sqrt(weight);
    double low = 1e-3, high = pi - 1e-3;
    DropOnPlate drop;
    for (int k = 0; k < 45; ++k) {
        const double between = 0.5 * (low + high);
        const auto of = [&](double top_curvature) { return drop_of_top(top_curvature, between, weight); };
        const bool may_be = !(weight > 0) || of(flattest).middle > middle;
        if (may_be) drop = of(where_falls_to(middle, 1.0 / middle, [&](double c) { return of(c).middle; }));
        (!may_be || drop.square > square ? low : high) = between;
    }
    return drop;
}

} // namespace hygroloom
