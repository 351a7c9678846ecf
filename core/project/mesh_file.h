// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A textile as meshes and curves for other programs. Most formats are written piece by piece, so that memory follows the
// longest yarn or fibre and not the textile. Millimetres with z out of the top face, but GLB, glTF and Collada in metres and FBX in
// centimetres, with y out of it.
#pragma once

#include "core/project/export_options.h"

#include <filesystem>
#include <span>
#include <vector>

namespace hygroloom {

std::span<const MeshFormatTraits> mesh_formats();

/// By the file's ending. Throws Error naming the endings.
MeshFormat mesh_format_of(const std::filesystem::path& path);

/// What export_textile() would write, without making it.
ExportEstimate export_estimate(const Textile& textile, const Fabric& fabric, const ExportOptions& options, MeshFormat format);

/// All that an export writes, the asked-for one first. Those beside it (.mtl, .bin) take its name, of which long or odd parts are replaced.
std::vector<std::filesystem::path> files_of_export(const std::filesystem::path& path, const ExportEstimate& size);

/// What was written.
struct Exported {
    std::vector<std::filesystem::path> files; ///< the asked-for one first
    std::uintmax_t bytes = 0;
};

/// Yarns are named warp_000, weft_000 (not in PLY and STL) and have their own colours (not in STL). Everything goes to
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

} // namespace hygroloom
