// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Several values of a project by their paths at once, and one as it stands; with_value() of project_file.h sets a single one.
#pragma once

#include "core/design/design.h"
#include "core/project/migrations.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hygroloom {

/// Paths and values as --set takes them, set one after the other; read strictly once all are set. Throws Error with a sentence.
Design with_values(const Design& design, const std::vector<std::pair<std::string, std::string>>& values);
/// The same of a project that lies there as JSON, which saves making it each time.
Design with_values(ProjectJson project, const std::vector<std::pair<std::string, std::string>>& values);

/// What stands at a path; null where the project leaves it out. Throws Error where there is no such path.
ProjectJson value_at(const Design& design, const std::string& path);

/// The first two of the paths, by their numbers, that are two ways to write one place; none: each has its own. Throws Error where there is
/// no such path.
std::optional<std::pair<std::size_t, std::size_t>> same_place(const Design& design, const std::vector<std::string>& paths);

/// The member of one of the project's lists that a path leads into: "fabrics", 1; nothing where it leads elsewhere. Throws Error where
/// there is no such path.
std::optional<std::pair<std::string, std::size_t>> member_at(const Design& design, const std::string& path);

} // namespace hygroloom
