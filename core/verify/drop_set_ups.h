// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Scenes of free water away from the cloth, and what their frames show.
#pragma once

#include "core/scene/frame.h"
#include "core/scene/scene.h"
#include "core/solver/drop_shapes.h"

#include <vector>

namespace hygroloom {

constexpr double plate_height = 5e-3; // m, over the piece of cloth that every scene has

/// Free water over a small piece of cloth that it never meets; volumes in m3, temperatures in K.
Scene scene_with(const std::vector<Vec3d>& places, double particle_volume, double temperature);
/// angle: contact angle of the plate, rad.
void put_on_plate(Scene& scene, double angle);
/// Moves the places a little off their lattice.
void disturb(std::vector<Vec3d>& places, double spacing, std::uint64_t seed = 1);

/// A ball high over the plate and the cloth.
Scene ball(int particles, double radius, double temperature, std::uint64_t seed = 1);

/// A drop on a plate, in the shape of a weightless drop at the angle it starts with.
struct PlateCap {
    double volume;        ///< m3
    double start_angle;   ///< rad
    double contact_angle; ///< of the plate, rad
};
Scene cap_on_plate(int particles, const PlateCap& cap, double temperature);

Vec3d place(const Frame& frame, std::size_t particle);
Vec3d velocity(const Frame& frame, std::size_t particle);
Vec3d middle(const Frame& frame);
Vec3d mean_velocity(const Frame& frame);
/// Root mean square of the velocities over their mean, m/s.
double agitation(const Frame& frame);

/// The drop on a plate of that height, m, with the same middle over it and the same mean square distance from its axis, in the mean of
/// frames; nothing where their middle lies under the plate.
DropOnPlate shape_over(double floor, const std::vector<Frame>& frames, double weight);

/// Evenly from first to last.
std::vector<double> times_between(double first, double last, int count);

} // namespace hygroloom
