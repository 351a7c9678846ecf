// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Meshes that Assimp reads.
#pragma once

#include "core/garment/flat_mesh.h"

namespace hygroloom {

/// A file's bytes. format: "fbx" or "dae". Opens no other file. Throws FileError.
FlatMesh mesh_by_assimp(std::string_view bytes, const std::string& format, const std::string& name);

} // namespace hygroloom
