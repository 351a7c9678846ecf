// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The skins of a textile's yarns as triangles: one tube per yarn, for pictures and for export.
// In metres, in the textile's axes. Yarns end half a pitch outside their last crossings, with flat caps unless they are to be open.
#pragma once

#include "core/geometry/textile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hygroloom {

/// One yarn's part of a mesh.
struct MeshGroup {
    std::string name; ///< "warp_000", "weft_012"
    YarnKind kind = YarnKind::warp;
    int yarn = 0;
    std::size_t first_vertex = 0;
    std::size_t vertices = 0;
    std::size_t first_index = 0;
    std::size_t indices = 0; ///< three per triangle
};

/// Flat arrays, as a graphics card takes them. Triangles run anticlockwise seen from outside.
struct YarnMesh {
    std::vector<float> positions;       ///< x y z per vertex, m
    std::vector<float> normals;         ///< x y z per vertex, unit, outwards
    std::vector<float> uvs;             ///< u along the yarn in crossings, v once round from the top
    std::vector<std::uint32_t> indices; ///< of vertices, three per triangle
    std::vector<int> segment_of_vertex; ///< the textile's segment, for colouring by a frame
    std::vector<MeshGroup> groups;      ///< all ends, then all picks
};

/// How large mesh_yarns() would be.
struct MeshSize {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
};
MeshSize mesh_size(const Textile& textile, int samples_per_crossing, int sides);

/// samples_per_crossing >= 1 rings per crossing, sides >= 3 round the yarn (a multiple of 4 keeps width and height exact).
/// Throws Error when the vertices are too many for 32-bit indices.
YarnMesh mesh_yarns(const Textile& textile, int samples_per_crossing, int sides);

/// "warp_000", "weft_012".
std::string yarn_name(YarnKind kind, int yarn);

/// Adds one yarn and its group.
void append_yarn(const Textile& textile, YarnKind kind, int yarn, int samples_per_crossing, int sides, YarnMesh& mesh, bool capped = true);

/// The middle line of one yarn.
struct MiddleLine {
    std::string name;             ///< as MeshGroup::name
    std::vector<float> positions; ///< x y z per point, m
};

/// The same points along the yarn as mesh_yarns() has rings.
MiddleLine yarn_line(const Textile& textile, YarnKind kind, int yarn, int samples_per_crossing);

/// All ends, then all picks.
std::vector<MiddleLine> yarn_lines(const Textile& textile, int samples_per_crossing);

/// A point of a section's skin, angle from the yarn's upward direction towards its across direction (+x of the warp, -y of the weft).
/// The middles of a racetrack's two flats stand at angle 0 and pi; its half circles at the angles between.
struct SectionPoint {
    double across = 0;        ///< m, from the centre
    double up = 0;            ///< m
    double normal_across = 0; ///< of the skin, unit
    double normal_up = 0;
};
SectionPoint section_point(double half_width, double half_height, double angle);

} // namespace hygroloom
