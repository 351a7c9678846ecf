// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/cap_room.h"

#include "core/physics/caps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {
namespace {

double ball_of(double volume) { return std::cbrt(3.0 * volume / (4.0 * pi)); }

/// Of a drop that shows an angle, m, at most: of a ball's cap, or of a puddle with its rim. Shapes between the two (Young and Laplace) are
/// wider than both by up to 9.4 %, at 5 degrees and 25 ul of water.
double base_at(double volume, double angle, const LiquidAt& liquid)
{
    constexpr double between = 1.1;
    const double length = std::sqrt(liquid.surface_tension / (liquid.density * gravity_acceleration)); // capillary
    const double puddle = std::sqrt(volume / (pi * 2.0 * length * std::sin(0.5 * angle))) + 0.5 * length;
    return between * std::max(cap_base(volume, angle), puddle);
}

/// Drops that may become one, and the rectangle about their middles. m, m3
struct JoinedDrops {
    std::array<double, 2> least{}, most{};
    double volume = 0, base = 0;
};

double gap(const JoinedDrops& a, const JoinedDrops& b)
{
    double squared = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const double apart = std::max({0.0, a.least[k] - b.most[k], b.least[k] - a.most[k]});
        squared += apart * apart;
    }
    return std::sqrt(squared);
}

/// Joins what can touch until nothing more can. base_of: of a volume.
template <typename BaseOf> void join(std::vector<JoinedDrops>& all, const BaseOf& base_of)
{
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (i == k || gap(all[i], all[k]) > all[i].base + all[k].base) continue;
            JoinedDrops &into = all[i], &from = all[k];
            for (std::size_t axis = 0; axis < 2; ++axis) {
                into.least[axis] = std::min(into.least[axis], from.least[axis]);
                into.most[axis] = std::max(into.most[axis], from.most[axis]);
            }
            into.volume += from.volume;
            into.base = std::max({into.base, from.base, base_of(into.volume)});
            all.erase(all.begin() + static_cast<std::ptrdiff_t>(k));
            return join(all, base_of);
        }
}

} // namespace

double largest_cap_base(double volume, double advancing, const LiquidAt& liquid, double duration)
{
    constexpr double step = 0.98; // of the angle
    // A line that goes on in steps is ahead of one that slows down all the time by about half a step for each e-fold of its speed. A 32nd
    // of a step of the yarns of 1 s at most, over 32 e-folds: half a second.
    constexpr double ahead = 0.5; // s
    double angle = std::max(advancing, 0.5 * pi);
    for (double time = 0; angle > advancing && time <= duration + ahead;) {
        const double next = std::max(advancing, step * angle);
        const double speed = speed_of_contact_line(liquid.surface_tension, liquid.viscosity, angle, advancing);
        time += (base_at(volume, next, liquid) - base_at(volume, angle, liquid)) / speed;
        angle = next;
    }
    return base_at(volume, angle, liquid);
}

std::string why_no_cap(const Experiment& experiment, const Bounds& b)
{
    constexpr double most_volume_ul = 2000; // for which shapes are tabled
    constexpr std::size_t most_drops = 200; // each is looked at from every crossing
    if (experiment.closure != Closure::pores) return "Caps give their liquid by suction, which only the closure pores has.";
    const std::vector<Droplet> drops = falling_drops(experiment);
    if (drops.size() > most_drops) return fmt::format("More than {} drops fall.", most_drops);

    const double advancing = radian_from_degree(b.advancing_deg), tension = b.liquid.surface_tension, density = b.liquid.density;
    const auto base_of = [&](double volume) { return largest_cap_base(volume, advancing, b.liquid, experiment.duration_s); };
    std::vector<JoinedDrops> groups;
    for (const Droplet& drop : drops) {
        const double volume = cubic_metre_from_ul(drop.volume_ul), ball = ball_of(volume);
        const double speed = std::sqrt(drop.speed_m_s * drop.speed_m_s + 2.0 * gravity_acceleration * metre_from_mm(drop.height_mm));
        if (splashes(tension, b.liquid.viscosity, density, ball, speed))
            return fmt::format("A drop lands with {:.3g} m/s and may splash.", speed);
        if (const double strikes = 0.5 * density * speed * speed; !(b.uptake > 0) && strikes > b.holes_hold) // others draw it in from below
            return fmt::format("A drop lands with {:.3g} m/s: its pressure of {:.3g} Pa may drive it through the holes between the yarns, "
                               "which bear {:.3g} Pa.",
                               speed, strikes, b.holes_hold);
        const std::array<double, 2> at{metre_from_mm(drop.at_mm[0]), metre_from_mm(drop.at_mm[1])};
        groups.push_back({at, at, volume, std::max(base_of(volume), impact_base(tension, density, ball, speed))});
    }
    join(groups, base_of);
    const auto [width, height] = sample_extent_mm(experiment);
    const std::array<double, 2> half{metre_from_mm(0.5 * width), metre_from_mm(0.5 * height)};
    for (const JoinedDrops& group : groups) {
        if (group.volume > cubic_metre_from_ul(most_volume_ul))
            return fmt::format("Drops of more than {:g} µl together are no cap.", most_volume_ul);
        for (std::size_t k = 0; k < 2; ++k)
            if (group.most[k] + group.base > half[k] || group.least[k] - group.base < -half[k])
                return "A drop may reach over the sample's edge.";
    }
    return "";
}

} // namespace hygroloom
