// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How projects of older versions become today's. Each step turns version n into n + 1 and is never changed once released.
#pragma once

#include <nlohmann/json.hpp>

#include <vector>

namespace hygroloom {

using ProjectJson = nlohmann::ordered_json;
using Migration = void (*)(ProjectJson&);

/// Step i turns version i + 1 into i + 2; there are project_version - 1 of them.
const std::vector<Migration>& project_migrations();

/// Runs the steps from a version on, and sets "version" to the newest. Precondition: 1 <= version <= steps.size() + 1.
void migrate_project(ProjectJson& project, int version, const std::vector<Migration>& steps);

} // namespace hygroloom
