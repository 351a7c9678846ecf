// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the program hygroloom-mesh says of a file: its mesh, or why there is none.
#pragma once

#include "core/garment/flat_mesh.h"

namespace hygroloom {

constexpr std::size_t most_answer_bytes = 256u << 20; ///< of a mesh as large as one may be

std::string answer_bytes(const FlatMesh& mesh);
std::string refusal_bytes(const std::string& sentence);

/// The mesh; trusts nothing: counts, indices, numbers and texts are checked. Throws FileError with the sentence of a refusal, or one that
/// says that the answer makes no sense; each begins with the file's name.
FlatMesh mesh_from_answer(std::string_view bytes, const std::string& name);

} // namespace hygroloom
