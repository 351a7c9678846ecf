// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/scene/liquid_bodies.h"

#include "core/base/units.h"
#include "core/geometry/textile.h"
#include "core/scene/pool_base.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

constexpr double density = 1000;  // kg/m3; of any liquid, near enough for a picture
constexpr double hangs = 0.5;     // s, a drop is shown before it falls
constexpr double nothing = 1e-12; // m3

/// Over a round base of a radius: h (3 a^2 + h^2) pi / 6 is the volume, which Cardano's formula solves for h.
double height_of_cap(double base, double volume)
{
    const double a2 = base * base, v = 3.0 * volume / pi;
    const double root = std::sqrt(v * v + a2 * a2 * a2);
    return std::cbrt(v + root) - std::cbrt(root - v);
}

/// See ScenePool: a half ball, but never narrower than one of the first drop.
FrameCap pool_on_top(double volume, const Experiment& experiment, double half_thickness)
{
    const double least =
        least_pool(cubic_metre_from_ul(experiment.volume_ul), drops_of_feed(experiment), cubic_metre_from_ul(hanging_drop_ul));
    FrameCap cap;
    cap.base = std::cbrt(1.5 * std::max(volume, least) / pi);
    cap.face = half_thickness;
    cap.height = height_of_cap(cap.base, volume);
    cap.volume = volume;
    return cap;
}

void add_drops_to_come(const Frame& frame, const Experiment& experiment, double half_thickness, std::vector<FrameCap>& bodies)
{
    std::vector<Droplet> drops = falling_drops(experiment);
    std::stable_sort(drops.begin(), drops.end(), [](const Droplet& a, const Droplet& b) { return a.time_s < b.time_s; });
    double came = 0; // m3, with the drops before this one
    for (const Droplet& drop : drops) {
        const double volume = cubic_metre_from_ul(drop.volume_ul), left = drop.time_s - frame.time;
        const bool is_there = frame.ledger.water_delivered / density > came + 0.5 * volume;
        came += volume;
        if (is_there || left < 0 || left > hangs || !(volume > 0)) continue;
        const double falls = std::min(left, drop.speed_m_s / gravity_acceleration); // s, already; before that it hangs
        const double over = metre_from_mm(drop.height_mm) + falls * (drop.speed_m_s - 0.5 * gravity_acceleration * falls);
        FrameCap ball{metre_from_mm(drop.at_mm[0]), metre_from_mm(drop.at_mm[1]), 0, half_thickness, 0, volume};
        ball.height = over + 2.0 * std::cbrt(3.0 * volume / (4.0 * pi));
        bodies.push_back(ball);
    }
}

} // namespace

std::vector<FrameCap> liquid_bodies(const Frame& frame, const Experiment& experiment, double half_thickness)
{
    std::vector<FrameCap> bodies;
    for (const FrameCap& cap : frame.caps)
        if (cap.height > 0 && cap.volume > 0) bodies.push_back(cap);
    const bool pool = experiment.type == ExperimentType::moisture_management || experiment.type == ExperimentType::horizontal_wicking;
    const double free = frame.ledger.water_free / density;
    if (pool && frame.caps.empty() && frame.positions.empty() && free > nothing)
        bodies.push_back(pool_on_top(free, experiment, half_thickness));
    add_drops_to_come(frame, experiment, half_thickness, bodies);
    return bodies;
}

} // namespace hygroloom
