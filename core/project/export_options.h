// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What an export may be asked for, and what it is expected to come to.
#pragma once

#include "core/geometry/mesh_stream.h"

#include <functional>
#include <string>
#include <vector>

namespace hygroloom {

enum class MeshFormat { obj, ply, stl, glb, gltf, fbx, collada, bcc, usda };

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

/// Gets the share done, 0 .. 1, and returns false to cancel.
using ExportProgress = std::function<bool(double share)>;

constexpr double most_crossings = 1e9;          ///< of one piece
constexpr double largest_stream_memory = 450e6; ///< bytes, of the pieces that are made at the same time
constexpr double largest_scene_memory = 400e6;  ///< bytes, of formats that are not streamed

} // namespace hygroloom
