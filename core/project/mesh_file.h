// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A textile as meshes and curves for other programs. Most formats are written piece by piece, so that memory follows the
// longest yarn or fibre and not the textile. Millimetres with z out of the top face, but GLB, glTF, Collada and X3D in metres and FBX in
// centimetres, with y out of it.
#pragma once

#include "core/geometry/mesh_stream.h"

#include <filesystem>
#include <span>

namespace hygroloom {

enum class MeshFormat { obj, ply, stl, glb, gltf, fbx, three_mf, collada, x3d, bcc, usda };

/// What a format is called and what it holds.
struct MeshFormatTraits {
    MeshFormat format;
    const char* ending; ///< with its dot
    const char* name;
    bool curves;   ///< only
    bool lines;    ///< centrelines
    bool colors;   ///< of vertices
    bool streamed; ///< piece by piece
};
std::span<const MeshFormatTraits> mesh_formats();

/// By the file's ending. Throws Error naming the endings.
MeshFormat mesh_format_of(const std::filesystem::path& path);

struct ExportOptions {
    MeshRequest mesh;
    std::vector<float> saturation; ///< 0 .. 1 per segment, a water map in place of the yarns' colours; empty: none
    std::uint64_t largest_buffer = (std::uint64_t(1) << 31) - 1; ///< bytes of a .gltf's .bin: what readers with signed sizes take
};

struct ExportEstimate {
    std::size_t yarns = 0;
    std::size_t curves = 0;    ///< where yarns or fibres are written as lines
    std::size_t vertices = 0;  ///< exact; of curves, their points
    std::size_t triangles = 0; ///< exact; 0 of curves
    double bytes = 0;          ///< of all files: exact for binary formats that are streamed, else within a quarter
    double most_bytes = 0;     ///< that the disk must have room for
    double memory = 0;         ///< bytes: of the whole scene, or of the pieces in the making for formats that are streamed
    std::size_t files = 1;     ///< the asked-for one and those beside it
    std::string refusal;       ///< why it cannot be written, a sentence; empty when it can
};

/// What export_textile() would write, without making it.
ExportEstimate export_estimate(const Textile& textile, const Fabric& fabric, const ExportOptions& options, MeshFormat format);

/// All that an export writes, the asked-for one first. Those beside it (.mtl, .bin) take its name, of which long or odd parts are replaced.
std::vector<std::filesystem::path> files_of_export(const std::filesystem::path& path, const ExportEstimate& size);

/// What was written.
struct Exported {
    std::vector<std::filesystem::path> files; ///< the asked-for one first
    std::uintmax_t bytes = 0;
};

/// Gets the share done, 0 .. 1, and returns false to cancel.
using ExportProgress = std::function<bool(double share)>;

/// Yarns are named warp_000, weft_000 (not in PLY, STL and 3MF) and have their own colours (not in STL and 3MF). Everything goes to
/// temporary files, renamed at the end. fabric is the one the textile was built from. Throws Error with the estimate's refusal, FileError,
/// or Cancelled; no file is changed then, unless one of several files cannot be renamed after others were.
Exported export_textile(const Textile& textile, const Fabric& fabric, const ExportOptions& options, const std::filesystem::path& path,
                        const ExportProgress& progress = {});

/// So many repeats of the fabric along the weft and along the warp: of the weave and of the yarns' order together.
/// Throws Error when they have too many threads.
TextileRegion region_of_repeats(const Fabric& fabric, int across, int along);

/// What an undyed yarn looks like, and a dry segment.
constexpr Color undyed{233, 228, 218};
/// From dry to deep blue.
Color water_color(double saturation);

constexpr double most_crossings = 1e9;          ///< of one piece
constexpr double largest_stream_memory = 450e6; ///< bytes, of the pieces that are made at the same time
constexpr double largest_scene_memory = 400e6;  ///< bytes, of formats that are not streamed

} // namespace hygroloom
