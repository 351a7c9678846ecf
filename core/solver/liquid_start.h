// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What follows from a scene for its free liquid before the first step: the particles' size and number, their rules, cells and room.
#pragma once

#include "core/solver/steps/liquid_control.h"

namespace hygroloom::inline HL_PRECISION {

/// The particles of a scene's free liquid. All weigh the same; a drop's number of them goes with its volume.
struct LiquidStart {
    int room = 0;                ///< most particles that there may be; 0: the scene has no free liquid
    double volume = 0;           ///< m3, of one
    Real mass = 0;               ///< kg, of one
    double lattice_spacing = 0;  ///< m, before it is rounded to a particle's numbers
    Real spacing = 0;            ///< m
    Real support = 0, reach = 0; ///< m, of the kernels of pressure and of the surface

    std::size_t particles_of(double of_volume) const;
};
LiquidStart liquid_start(const Scene& scene);

/// What stays the same for the liquid's steps.
LiquidRules liquid_rules(const Scene& scene, const LiquidStart& start);
/// Their step is not set.
LiquidParameters liquid_parameters(const Scene& scene, const LiquidStart& start);
/// Cells of half the surface's reach, for all the space that liquid may be in; their arrays are not set.
CellGrid grid_about(const Scene& scene, const LiquidStart& start);
/// As far as drops reach while they fall, and a little farther. Liquid that is there from the start may be anywhere beside the sample.
Room room_about_sample(const Scene& scene);

std::vector<Vec3> rounded(const std::vector<Vec3d>& values);

} // namespace hygroloom::inline HL_PRECISION
