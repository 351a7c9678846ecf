// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/solver/cap_shapes.h"

#include "core/base/units.h"
#include "core/physics/caps.h"
#include "core/solver/drop_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {
namespace {

constexpr double smallest = 1e-4; // volume in cubed capillary lengths
constexpr int volumes = 97, per_decade = 16;
constexpr int angles = 87;
constexpr double first_angle = pi / 45, angle_step = pi / 90; // 4 to 176 degrees

double angle_of(int k) { return first_angle + k * angle_step; }
double volume_of(int k) { return smallest * std::pow(10.0, double(k) / per_decade); }

/// Where a number lies among equally spaced ones, and how far towards the next.
struct Spot {
    int at;
    double part;
};
Spot spot_of(double steps, int count)
{
    const double inside = std::clamp(steps, 0.0, count - 1.0);
    const int at = std::min(static_cast<int>(inside), count - 2);
    return {at, inside - at};
}

/// Outlines of all the drops that the table may need, from the flattest top to the most curved.
std::vector<std::vector<DropOnPlate>> outlines()
{
    constexpr double flattest = 1e-10, ratio = 1.1, most_curved = 1e2; // over the capillary length
    std::array<double, angles> wanted{};
    for (int k = 0; k < angles; ++k) wanted[static_cast<std::size_t>(k)] = angle_of(k);
    std::vector<std::vector<DropOnPlate>> found;
    for (double curvature = flattest; curvature < most_curved; curvature *= ratio) found.push_back(drops_of_top(curvature, wanted, 1.0));
    return found;
}

} // namespace

const CapShapes& CapShapes::table()
{
    static const CapShapes only;
    return only;
}

CapShapes::Beside CapShapes::between(const Beside& a, const Beside& b, double part)
{
    const auto mix = [part](double from, double to) { return from + part * (to - from); };
    return {mix(a.base, b.base), mix(a.height, b.height), mix(a.curvature, b.curvature)};
}

CapShapes::CapShapes() : rows_(volumes, std::vector<Beside>(angles))
{
    const std::vector<std::vector<DropOnPlate>> all = outlines();
    for (int k = 0; k < angles; ++k) {
        const auto a = static_cast<std::size_t>(k);
        const auto beside = [](const DropOnPlate& drop) -> Beside {
            const double ball = cap_base(drop.volume, drop.contact_angle);
            return {std::log(drop.base_radius / ball), std::log(drop.height / (ball * cap_steepness(drop.contact_angle))),
                    std::log(drop.top_curvature / std::sin(drop.contact_angle) * ball)};
        };
        std::size_t row = 1; // volumes fall from row to row
        for (int v = volumes - 1; v >= 0; --v) {
            const double volume = volume_of(v);
            while (row + 1 < all.size() && all[row][a].volume > volume) ++row;
            const DropOnPlate &larger = all[row - 1][a], &smaller = all[row][a];
            const double part = std::log(larger.volume / volume) / std::log(larger.volume / smaller.volume);
            rows_[static_cast<std::size_t>(v)][a] = between(beside(larger), beside(smaller), std::clamp(part, 0.0, 1.0));
        }
    }
}

CapShapes::Beside CapShapes::beside(double cubed, double angle) const
{
    const Spot v = spot_of(std::log10(cubed / smallest) * per_decade, volumes);
    Spot a = spot_of((angle - first_angle) / angle_step, angles);
    if (a.at == 0) a.part = std::log1p(a.part * angle_step / first_angle) / std::log1p(angle_step / first_angle); // puddles go with a power
    const auto row = [&](int at) {
        const std::vector<Beside>& of = rows_[static_cast<std::size_t>(at)];
        return between(of[static_cast<std::size_t>(a.at)], of[static_cast<std::size_t>(a.at) + 1], a.part);
    };
    return between(row(v.at), row(v.at + 1), v.part);
}

double CapShapes::base(double volume, double angle, double weight) const
{
    return cap_base(volume, angle) * std::exp(beside(volume * std::pow(weight, 1.5), angle).base);
}

CapShape CapShapes::shape(double volume, double base, double weight) const
{
    double low = 1e-3, high = pi - 1e-3; // the base shrinks as the angle grows
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        (this->base(volume, middle, weight) > base ? low : high) = middle;
    }
    const double angle = 0.5 * (low + high), ball = cap_base(volume, angle);
    const Beside found = beside(volume * std::pow(weight, 1.5), angle);
    return {angle, ball * cap_steepness(angle) * std::exp(found.height), std::sin(angle) / ball * std::exp(found.curvature)};
}

} // namespace hygroloom
