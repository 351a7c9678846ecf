// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Full morphology (Hilpert and Miller 2001): what a room of voxels holds at a suction, from balls that fit into it. Lengths in voxels.
#pragma once

#include "core/room/voxels.h"

namespace hygroloom {

/// Air comes from outside; only pores are counted.
enum class Voxel : std::uint8_t { solid, outside, pore };

struct PoreImage {
    VoxelGrid grid;
    std::vector<Voxel> voxels;
};

/// For each voxel the largest squared distance that a ball can keep to all solids on its way there from outside; 0 where none comes.
std::vector<int> squared_ways_in(const PoreImage& image, const std::vector<int>& to_solid);

/// What pores hold while balls of one radius keep the liquid out.
struct MorphologyPoint {
    double radius = 0;
    double saturation = 0; ///< of the pores
    bool spans = false;    ///< the liquid hangs together from a repeat to the next; not looked for in sections
};

/// Filling: air stays wherever a ball fits. Emptying: it comes to where a ball gets from outside. Radii fall by one ratio from the largest
/// ball on the grid to 1.5 voxels; both curves end where pores are empty.
struct MorphologyCurves {
    double pores = 0; ///< voxels
    std::vector<MorphologyPoint> filling, emptying;
};
MorphologyCurves morphology_curves(const PoreImage& image, int radii);

/// Radius at which a curve holds this much, between its points as a power law. NaN where the curve does not reach it.
double radius_at(const std::vector<MorphologyPoint>& curve, double saturation);

/// Brooks and Corey's curve through the points of a curve that hold 0.2 to 0.8: by least squares of the logarithms. NaN with less than
/// three.
struct BrooksCorey {
    double entry_radius = 0; ///< where it comes to 1
    double shape = 0;
};
BrooksCorey fitted_to(const std::vector<MorphologyPoint>& curve);

} // namespace hygroloom
