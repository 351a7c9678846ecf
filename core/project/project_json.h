// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Between the JSON of a project and its design. For project_file.cpp and for tests; others use project_file.h.
#pragma once

#include "core/design/design.h"
#include "core/design/draft.h"
#include "core/project/migrations.h"

namespace hygroloom {

/// Checks format and version, migrates, reads strictly. Throws FileError.
Design design_from_json(ProjectJson project, const std::string& file, const std::vector<Migration>& steps = project_migrations());

/// In the newest version, keys in the format's order.
ProjectJson json_from_design(const Design& design);

/// Strictly; throws FileError with the place.
Yarn yarn_from_json(const ProjectJson& value, const std::string& file, const std::string& path);
/// A weave by its pattern, rows or draft. Throws FileError.
Weave weave_from_json(const ProjectJson& value, const std::string& file, const std::string& path);

/// A weave's draft; shafts, treadles and their lists count from 1 there. Throws FileError, also for what fault_in() finds.
Draft draft_from_json(const ProjectJson& value, const std::string& file, const std::string& path);
ProjectJson json_from_draft(const Draft& draft);

/// An experiment on a garment, which stands among the others. Throws FileError.
bool is_wear(const ProjectJson& experiment);
WearExperiment wear_from_json(const ProjectJson& value, const std::string& file, const std::string& path);
ProjectJson json_from_wear(const WearExperiment& wear);

/// A garment. Throws FileError.
Garment garment_from_json(const ProjectJson& value, const std::string& file, const std::string& path);
ProjectJson json_from_garment(const Garment& garment);

/// Two-space indent, lists of plain values on one line. Throws Error when a number is not finite or a text is not UTF-8.
std::string text_from_json(const ProjectJson& project);

} // namespace hygroloom
