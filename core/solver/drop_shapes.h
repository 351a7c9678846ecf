// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A drop at rest on a plate, with gravity or without: Young and Laplace's equation from the top down (Bashforth and Adams 1883).
#pragma once

#include <span>
#include <vector>

namespace hygroloom {

/// Lengths in m.
struct DropOnPlate {
    double volume = 0;      ///< m3
    double base_radius = 0; ///< where it touches the plate
    double height = 0;
    double middle = 0;        ///< height of its centre of mass over the plate
    double square = 0;        ///< mean square of the distance from its axis, m2
    double contact_angle = 0; ///< rad
    double top_curvature = 0; ///< 1/m
};

/// By the curvature of its top, 1/m, the angle in rad from 0 to pi, and weight: density x gravity / surface tension, 1/m2, 0 for a cap of a
/// ball. Relative error below 1e-6.
DropOnPlate drop_of_top(double top_curvature, double contact_angle, double weight);

/// The same for several angles in rising order, which are parts of one outline.
std::vector<DropOnPlate> drops_of_top(double top_curvature, std::span<const double> contact_angles, double weight);

/// By its volume.
DropOnPlate drop_of_volume(double volume, double contact_angle, double weight);

/// The one whose middle stands that high and whose particles are that far from the axis.
DropOnPlate drop_like(double middle, double square, double weight);

} // namespace hygroloom
