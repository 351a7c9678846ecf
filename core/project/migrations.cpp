// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/project/migrations.h"

namespace hygroloom {

const std::vector<Migration>& project_migrations()
{
    static const std::vector<Migration> steps; // version 1 is the first
    return steps;
}

void migrate_project(ProjectJson& project, int version, const std::vector<Migration>& steps)
{
    for (auto step = static_cast<std::size_t>(version - 1); step < steps.size(); ++step) steps[step](project);
    project["version"] = static_cast<int>(steps.size()) + 1;
}

} // namespace hygroloom
