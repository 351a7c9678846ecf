// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A drop over a plate of closed yarns, for tests of the free liquid.
#pragma once

#include "core/verify/set_ups.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hygroloom {

/// Gives the cloth closed yarns of these half heights, the same types in warp and weft, one after the other; they touch half-way.
inline void set_heights(Scene& scene, const std::vector<double>& half_heights)
{
    const std::size_t n = half_heights.size();
    scene.cloth.warp_types = static_cast<int>(n);
    scene.cloth.yarns.resize(2 * n, scene.cloth.yarns[0]);
    scene.cloth.shapes.clear();
    scene.cloth.crossing.clear();
    scene.cloth.half_thickness = 0;
    for (int line = 0; line < scene.cloth.ends + scene.cloth.picks; ++line) {
        const auto yarn = static_cast<std::size_t>(line < scene.cloth.ends ? line : line - scene.cloth.ends);
        scene.cloth.type[static_cast<std::size_t>(line)] = static_cast<std::uint8_t>(yarn % n + (line < scene.cloth.ends ? 0 : n));
    }
    for (double own : half_heights) {
        ContactShape shape{own, 1.47e-4, {}};
        for (double before : half_heights)
            for (double after : half_heights)
                for (double side : {1.0, -1.0})
                    for (double rise : {0.5 * (own + before), side * 0.5 * (own + after)})
                        for (double value : {rise, 0.0, own, shape.half_width}) shape.profiles.push_back(static_cast<float>(value));
        scene.cloth.shapes.push_back(shape);
        for (double other : half_heights) {
            scene.cloth.crossing.push_back({0, 0, 0, 0.5 * (own + other), 0.5 * (own + other)});
            scene.cloth.half_thickness = std::max(scene.cloth.half_thickness, 0.5 * (own + other) + own);
        }
    }
    for (std::size_t i = 0; i < n; ++i) scene.cloth.shapes.push_back(scene.cloth.shapes[i]);
}

inline Scene drop_over_plate(double volume, double height, double speed, int particles, const std::vector<double>& half_heights = {5e-5})
{
    Scene scene = bare_scene(80, 80, 3e-4, 293.15);
    scene.cloth.shift.assign(static_cast<std::size_t>(scene.cloth.segments()), 0.0f);
    set_heights(scene, half_heights);
    const double radius = std::cbrt(3 * volume / (4 * pi));
    scene.supply.droplets.push_back({0, volume, {0, 0, scene.cloth.half_thickness + height + radius}, speed});
    scene.rules.particles_per_droplet = particles;
    return scene;
}

} // namespace hygroloom
