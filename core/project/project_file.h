// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The project file .hygro: strict, versioned JSON, written atomically.
#pragma once

#include "core/design/validate.h"

#include <filesystem>
#include <string_view>

namespace hygroloom {

constexpr int project_version = 1;
constexpr std::size_t largest_project_bytes = 64u << 20;

/// Reads and checks the form of a project (types, known keys, version); values are for validate().
/// Throws FileError: file, line and column or path, what is wrong, what is allowed, what was given.
Design read_project(const std::filesystem::path& path);

/// The same from text; name stands for the file in messages.
Design parse_project(std::string_view text, const std::string& name);

/// Writes to a temporary file beside the target, syncs, renames; the previous version stays as path + "~".
/// Throws FileError; the target is then unchanged.
void write_project(const Design& design, const std::filesystem::path& path);

/// The exact text write_project() writes: two-space indent, keys in the format's order, defaults left out only where optional.
std::string format_project(const Design& design);

/// Sets one value by its path, as --set does: "fabrics[0].contact_angle_deg", "60"; names work as indices:
/// "experiments.one drop.duration_s". Throws Error with a sentence. The result is re-read strictly, so a wrong key or type is refused.
Design with_value(const Design& design, const std::string& path, const std::string& value);

} // namespace hygroloom
