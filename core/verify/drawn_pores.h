// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A fabric's pores as it is drawn, in voxels: between the fibres of a yarn's sections, and between the yarns of one repeat.
#pragma once

#include "core/geometry/textile.h"
#include "core/verify/morphology.h"

namespace hygroloom {

/// A fibre where it passes through a section, m: its middle from the section's, and the radius of a disc as large as its cut.
struct FibreCut {
    double x, y, radius;
};

/// A yarn's section at a crossing.
struct DrawnSection {
    double half_width = 0, half_height = 0; ///< m
    std::vector<FibreCut> fibres;
};

/// Sections of one yarn at successive crossings, with as many fibres as its packing needs at their own radius. The generator lets fibres
/// run through each other: where they do, the section holds less fibre than its packing says.
std::vector<DrawnSection> drawn_sections(Textile textile, YarnKind kind, int yarn, int sections);

/// Their pores, in no fibre and at least so far inside the outline; skin in m.
VoxelGrid grid_of_sections(const std::vector<DrawnSection>& sections, double voxel);
PoreImage image_of_sections(const std::vector<DrawnSection>& sections, double voxel, double skin);

/// The room between the yarns of a textile that is one repeat large: pores lie within the layer's thickness and in no yarn.
VoxelGrid grid_of_room(const Textile& textile, double voxel);
PoreImage image_of_room(const Textile& textile, double voxel);

} // namespace hygroloom
