// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One cell of a woven layer as it is drawn, in voxels: how far each lies outside the yarns. Lengths in m.
#pragma once

#include "core/geometry/textile.h"
#include "core/room/voxels.h"
#include "core/room/woven_cell.h"

namespace hygroloom {

/// x runs along the picks, y along the ends, z up; air lies above and below the cloth.
struct DrawnLayer {
    VoxelGrid grid;
    int margin = 0;                ///< layers of voxels above the cloth, and below it
    int per_end = 0, per_pick = 0; ///< voxels from end to end, and from pick to pick
    double dx = 0, dy = 0, dz = 0; ///< sides of a voxel: alike but for what makes them fit the pitches
    std::vector<float> outside;    ///< from each voxel's middle to the nearest skin of a yarn, less than 0 within one; at most reach
    std::vector<std::uint8_t> nearest_is_warp; ///< whether that yarn is an end
    double reach = 0;

    int ends() const { return grid.nx / per_end; }
    int picks() const { return grid.ny / per_pick; }
    WovenCell cell() const { return {ends(), picks(), grid.skew / per_pick}; }
    int first() const { return margin; } ///< layer of voxels of the cloth
    int last() const { return grid.nz - margin - 1; }
    double side() const; ///< of a voxel, the mean of its three
    /// Of a voxel's column, end x picks + pick.
    int crossing(int x, int y) const { return x / per_end * picks() + y / per_pick; }
};

/// m, of the cubes in which what is drawn is counted: the mean pitch, or twice the thickness where that is less.
double side_of_cube(const Textile& textile);
/// What is drawn of a crossing, with air above and below, in those.
double cubes_of_crossing(const Textile& textile);
/// How many voxels so many cubes are drawn in.
double voxels_of_period(double cubes, int voxels);

/// By how much yarns lie wider than their sections on either side, m: of ends, of picks.
struct Widening {
    double warp = 0, weft = 0;
};

/// The textile is one cell large, with such a shift. voxels: in the mean pitch at least; a thin layer has more, for half as many from face
/// to face, and a cell of more than a million of them has fewer.
DrawnLayer drawn_layer(const Textile& cell, int voxels, int shift = 0, const Widening& wider = {});

/// Of the cloth, what lies outside yarns that have grown so much; a voxel that a skin cuts counts in part.
double share_outside(const DrawnLayer& layer, double growth);

/// By how much the yarns must grow evenly, more than 0, or shrink, for this share of the layer to lie outside them: voxels and
/// sections between samples differ a little from the volumes.
double growth_to_share(const DrawnLayer& layer, double share);

/// What bounds the room at each crossing once the yarns have grown so much, m2: their skin where neither another yarn covers it nor it lies
/// on a face, and the openings of both faces.
struct RoomSkin {
    std::vector<double> warp, weft, faces;
};
RoomSkin skin_of_room(const Textile& cell, double growth, int shift = 0);

/// A room that air has come into.
struct PartlyFull {
    std::vector<std::uint8_t> air; ///< of each voxel
    double saturation = 1;         ///< of the room
};
/// As far as balls of this radius, m, find room between the yarns.
PartlyFull emptied_by_balls(const DrawnLayer& layer, double growth, double radius);
/// By balls of such a size that it is about half full.
PartlyFull half_full(const DrawnLayer& layer, double growth);

} // namespace hygroloom
