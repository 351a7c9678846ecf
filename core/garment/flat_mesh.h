// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Meshes in space that have flat coordinates, and the islands that those make.
#pragma once

#include "core/garment/pattern.h"

#include <string_view>

namespace hygroloom {

constexpr std::size_t most_mesh_places = 3'000'000, most_mesh_triangles = 4'000'000;

/// A mesh as a file has it. Of each triangle the places and the flat coordinates are counted apart.
struct FlatMesh {
    std::vector<Vec3d> places;
    std::vector<FlatPlace> uv;
    std::vector<std::array<int, 3>> triangles, uv_triangles;
    std::vector<int> label;          ///< of each triangle among labels, -1: none
    std::vector<std::string> labels; ///< of groups, objects or materials
    double metre = 0;                ///< of the unit of places; 0: the format does not say
    std::vector<std::string> issues;
};

/// The text of an OBJ file. Throws FileError.
FlatMesh mesh_from_obj(std::string_view text, const std::string& name);
/// A PLY file's bytes. Throws FileError.
FlatMesh mesh_from_ply(std::string_view bytes, const std::string& name);
/// A glTF file (.gltf, .glb). Throws FileError.
FlatMesh mesh_from_gltf(const std::filesystem::path& path);
/// A file that a foreign library reads, in a process of its own. format: "fbx" or "dae". Throws FileError, and Cancelled within 0.1 s of
/// being asked.
FlatMesh mesh_apart(const std::filesystem::path& path, const std::string& format, const Asked& cancelled);

/// A place of an island's flat coordinates.
struct FlatCorner {
    int place = 0; ///< of the welded mesh
    FlatPlace uv{};
};

/// Triangles that hang together in flat coordinates, turned so that they are seen from outside.
struct Island {
    std::vector<int> triangles; ///< of the mesh
    std::vector<int> loop;      ///< corners round it, counter-clockwise
    bool mirrored = false;      ///< its flat coordinates had to be mirrored
    int folded = 0, holes = 0;  ///< triangles that lie the other way round in flat coordinates; loops inside
    int turned = 0;             ///< triangles that the file has the other way round than their neighbours
};

struct FlatIslands {
    std::vector<Vec3d> places; ///< welded, m
    std::vector<FlatCorner> corners;
    std::vector<std::array<int, 3>> triangles; ///< by corner; counter-clockwise as seen from outside
    std::vector<Island> islands;
    std::vector<int> first_place; ///< of the file, of each welded place
    int shared_sides = 0;         ///< sides of more than two triangles
    int doubled = 0;              ///< triangles left out, for they lie on others with the same corners
};

/// Welds places that lie within a hundred-thousandth of the mesh's size and finds the islands. Islands below least triangles are kept too.
FlatIslands islands_of(const FlatMesh& mesh, const std::string& name);

/// m in space of a unit of flat coordinates.
struct FlatScale {
    double middle = 0; ///< half of the cloth has less; 0: the flat coordinates have no size
    double spread = 0; ///< half of the cloth differs by more, relative to the middle
};
/// Along both axes, weighed by flat area within an island and by area in space among islands, so that no single place decides.
FlatScale common_scale(const FlatIslands& islands);

/// Scales the flat coordinates to m, each island's by its own lengths in space, across and along, where islands differ from the common
/// scale (m per unit) by more than cloth stretches. Returns whether they do. Precondition: places are in m.
bool take_own_scales(FlatIslands& islands, double common);

/// m2 in space, of places in m.
double area_in_space(const FlatIslands& islands, const Island& island);

/// The middle of some numbers; 0 of none.
double median_of(std::vector<double> numbers);
/// The median distance from the median, relative to it.
double spread_of(const std::vector<double>& numbers);

} // namespace hygroloom
