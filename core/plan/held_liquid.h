// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Drops on a sample that may be too small for them: what stays, how it swings, and how long the rest takes to be gone.
#pragma once

#include "core/base/units.h"
#include "core/physics/liquid.h"
#include "core/plan/model_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hygroloom {

/// m, of a ball of the largest drop's volume.
inline double diameter_of_largest(const SceneCounts& scene) { return std::cbrt(6.0 * scene.largest_drop / pi); }

/// m, of a rectangle with the sample's area and edge; without end where they are not known.
inline double narrow_side(const SceneCounts& scene)
{
    if (scene.sample_area <= 0) return std::numeric_limits<double>::infinity();
    const double mean = 0.25 * scene.sample_edge;
    return mean - std::sqrt(std::max(0.0, mean * mean - scene.sample_area));
}

/// m, as high as a puddle stands under an acceleration (m/s2): twice the capillary length.
inline double puddle_height(const SceneCounts& scene, double acceleration) { return 2.0 * std::sqrt(scene.capillarity / acceleration); }

/// m3, that a sample holds under an acceleration (m/s2): a puddle, and what hangs at its edge, tension over weight.
inline double most_held(const SceneCounts& scene, double acceleration)
{
    return puddle_height(scene, acceleration) * scene.sample_area + scene.capillarity / acceleration * scene.sample_edge;
}

/// m/s2, by which a landing drop sweeps its liquid off the sample: its weight, and where it is wider than the sample, what stops it within
/// its own diameter.
inline double landing_acceleration(const SceneCounts& scene)
{
    const double wide = diameter_of_largest(scene);
    return gravity_acceleration + (wide > narrow_side(scene) ? scene.landing_speed * scene.landing_speed / wide : 0.0);
}

/// Of all drops' volume, what can stay on the sample. Particles this far apart (m) neither stand on a narrower sample nor in a lower
/// puddle.
inline double share_that_stays(const SceneCounts& scene, double spacing)
{
    const double narrow = narrow_side(scene), all = scene.drops * scene.drop_volume;
    if (!std::isfinite(narrow) || all <= 0) return 1.0;
    const double acceleration = landing_acceleration(scene);
    if (narrow < spacing || puddle_height(scene, acceleration) < spacing) return 0.0;
    return std::min(1.0, most_held(scene, acceleration) / all);
}

/// Until a drop that does not stay has gone by and is no longer followed, s.
inline double falls_past_in(const SceneCounts& scene)
{
    constexpr double followed = 5e-3; // m below the cloth
    const double v = scene.landing_speed, way = diameter_of_largest(scene) + followed;
    return (std::sqrt(v * v + 2.0 * gravity_acceleration * way) - v) / gravity_acceleration;
}

/// Of a drop, what clings to a sample on which nothing stays: no more than is not swept off as it lands. The most was set on 78 random
/// drops, of which 15 instead of 18 were missed by more than a factor of 3 then; of 64 others, 17 instead of 18.
inline double clings_of(const SceneCounts& scene)
{
    constexpr double most = 0.3;
    return std::min(most, most_held(scene, landing_acceleration(scene)) / std::max(1e-18, scene.drop_volume));
}

/// Until yarns have absorbed that, s; where they absorb nothing it clings to the end.
inline double clings_for(const SceneCounts& scene)
{
    if (scene.uptake <= 0) return scene.duration;
    return std::max(falls_past_in(scene), clings_of(scene) * scene.drop_volume / scene.uptake);
}

/// In which a drop's liquid swings once, s.
inline double swing_of(const SceneCounts& scene, double volume)
{
    return capillary_time(volume, 1.0, scene.capillarity); // tension over density
}

/// Until cloth with the closure pores has absorbed a drop, s: some swings, and longer where the cloth under it must hand liquid on that it
/// cannot hold. Set on the absorbency times of 54 drops, of which half come out within a factor of 1.5. Steps depend less on it.
inline double absorbed_by_suction_in(const SceneCounts& scene)
{
    constexpr double swings = 9.8, uptakes = 0.155, power = 1.5;
    const double drop = std::max(1e-18, scene.drop_volume);
    const double times_its_room = std::cbrt(drop) / std::max(1e-12, scene.pores * scene.drop_base);
    return swings * swing_of(scene, drop) + uptakes * drop / scene.uptake * std::pow(times_its_room, power);
}

/// Until cloth with the closure paper has absorbed a drop, s.
inline double absorbed_by_diffusion_in(const SceneCounts& scene)
{
    constexpr double uptakes = 0.68; // of its volume over the cloth's uptake
    return uptakes * std::max(1e-18, scene.drop_volume) / scene.uptake;
}

/// In which the largest swings once, as far as it stays, s.
inline double swing_of_largest(const SceneCounts& scene, double stays)
{
    return swing_of(scene, std::max(1e-18, std::min(scene.largest_drop, stays * scene.drops * scene.drop_volume)));
}

/// Of what stays of the drops, the share that the sample's pores can hold.
inline double share_with_room(const SceneCounts& scene, double stays)
{
    return scene.sample_area > 0 ? std::min(1.0, scene.pores * scene.sample_area / (stays * scene.drops * scene.drop_volume)) : 1.0;
}

} // namespace hygroloom
