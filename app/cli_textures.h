// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// export --textures: a fabric's repeat as pictures.
#pragma once

#include "app/cli.h"

#include "core/project/texture_files.h"

namespace hygroloom {

/// Writes to the folder, which is made, and prints what was written.
int export_textures(const ProjectOptions& options, const TextureRequest& request, const std::string& folder);

} // namespace hygroloom
