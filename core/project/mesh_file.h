// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Meshes and centrelines of yarns for other programs, through Assimp. OBJ, PLY and STL in mm with z out of the fabric; GLB in metres with y
// out of it.
#pragma once

#include "core/geometry/mesh.h"

#include <filesystem>

namespace hygroloom {

enum class MeshFormat { obj, ply, stl, glb };

/// By the file's ending. Throws Error naming the endings.
MeshFormat mesh_format_of(const std::filesystem::path& path);

enum class MeshDetail { centreline, yarn };

struct MeshFileSize {
    std::size_t yarns = 0;
    std::size_t vertices = 0;
    std::size_t triangles = 0; ///< or pieces of line
    double bytes = 0;          ///< of the file, within a factor of 1.5
};

struct MeshOptions {
    MeshDetail detail = MeshDetail::yarn;
    int samples_per_crossing = 12;
    int sides = 12;
};

/// What write_mesh() would write, without building it.
MeshFileSize mesh_file_size(const Textile& textile, MeshFormat format, const MeshOptions& options);

constexpr double largest_mesh_bytes = 2e9;

/// One group (OBJ), node (GLB) or part (STL, PLY) per yarn, named warp_000, weft_000. Written to a temporary file and renamed.
/// Throws Error when the format cannot hold it or it would be larger than largest_mesh_bytes, FileError when it cannot be written.
void write_mesh(const Textile& textile, const MeshOptions& options, const std::filesystem::path& path);

} // namespace hygroloom
