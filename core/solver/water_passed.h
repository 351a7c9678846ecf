// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Water that passes between free liquid, pools and yarns.
#pragma once

#include "core/solver/caps.h"
#include "core/solver/steps/supply.h"
#include "core/solver/yarn_stock.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

/// Where the free liquid leaves the water that yarns absorb from it: quanta in the segments, and how far they lie.
struct WaterAbsorbed {
    Segments segments;
    int* reach = nullptr; ///< see Reach
};

/// Water that swollen yarns have no room for: a particle's from each of these segments, its surplus in work0.
struct WaterGivenBack {
    std::vector<int> segments;
};

/// What stands on the cloth, and where its water is kept in quanta: null of drops of particles.
struct StandingOnFace {
    std::vector<CapOnFace> caps;
    std::vector<std::int64_t*> water;
};

/// Liquid that comes without drops, in quanta. A pool is a cap on the base of a half ball of its volume, but never of less than a drop's.
struct Pools {
    std::vector<std::int64_t> standing; ///< in each pool
    ManyQuanta pumped;                  ///< into pools and as sweat
    ManyQuanta ran_off;                 ///< of sweat that found no room, and through holes
    bool came = false;                  ///< whether any pool got liquid in the last step

    bool any_stands() const
    {
        return std::any_of(standing.begin(), standing.end(), [](std::int64_t quanta) { return quanta > 0; });
    }
    /// Whether there is more of any than clings to the cloth: a ten billionth of all that came.
    bool feeds() const
    {
        const double clings = 1e-10 * pumped.mass();
        return std::any_of(standing.begin(), standing.end(),
                           [clings](std::int64_t quanta) { return static_cast<double>(quanta) * water_quantum > clings; });
    }
    /// What is pumped until a time, in the dt before it, s. Density in kg/m3.
    void fill(const Scene& scene, double time, double dt, double density)
    {
        came = false;
        for (std::size_t k = 0; k < standing.size(); ++k) {
            const ScenePool& pool = scene.supply.pools[k];
            const std::int64_t quanta = std::llround((pool.delivered(time) - pool.delivered(time - dt)) * density / water_quantum);
            standing[k] += quanta;
            pumped.add(quanta);
            came = came || quanta > 0;
        }
    }
    FedFace face_under(const Scene& scene, std::size_t k, double density) const
    {
        const int threads = scene.cloth.threads_per_cell;
        const double cell = std::max(scene.cloth.warp_pitch, scene.cloth.weft_pitch);
        return {scene.supply.pools[k].top, std::max(base(scene, k, density), cell / threads), scene.cloth.warp_pitch,
                scene.cloth.weft_pitch, threads};
    }
    /// m from the middle: a cell may be covered in part.
    static double reach(const Scene& scene, const FedFace& face)
    {
        const double cell = std::max(scene.cloth.warp_pitch, scene.cloth.weft_pitch);
        return scene.cloth.threads_per_cell > 1 ? face.radius + cell : face.radius;
    }
    /// m3/s: see WeighPool.
    static double weight_unit(const Scene& scene)
    {
        double most = 0;
        for (const YarnParameters& yarn : scene.cloth.yarns) most = std::max(most, yarn.face_conductance);
        for (const CrossingParameters& at : scene.cloth.crossing) most = std::max(most, at.between.face);
        return std::max(1e-300, 3.0 * most * Taker::most_pull * scene.cloth.crossings() * 0x1.0p-62);
    }
    /// As flow by suction sees it.
    StandingPool standing_pool(const Scene& scene, const ClimateParameters& climate) const
    {
        if (!feeds()) return {};
        const double radius = std::max(base(scene, 0, climate.density), scene.cloth.warp_pitch);
        const double height = cap_height(standing_volume(0, climate.density), radius);
        const double curvature = 2.0 * height / (radius * radius + height * height); // 1/m
        return {.stands = true,
                .pressure = 2.0 * climate.surface_tension * curvature + climate.density * gravity_acceleration * height,
                .face = scene.supply.pools[0].top ? 1 : 0};
    }

private:
    double standing_volume(std::size_t k, double density) const // m3
    {
        return static_cast<double>(standing[k]) * water_quantum / density;
    }
    static double half_ball(double volume) { return std::cbrt(1.5 * volume / pi); } // m, its radius
    double base(const Scene& scene, std::size_t k, double density) const            // m, its radius
    {
        return half_ball(std::max(standing_volume(k, density), scene.supply.pools[k].least));
    }
    /// m, of a ball's cap on a circle: volume = pi height (3 radius^2 + height^2) / 6.
    static double cap_height(double volume, double radius)
    {
        return 2.0 * radius * std::sinh(std::asinh(3.0 * volume / (pi * radius * radius * radius)) / 3.0);
    }
};

} // namespace hygroloom
