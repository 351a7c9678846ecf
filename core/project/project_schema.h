// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The JSON schema of project files.
#pragma once

#include "core/project/migrations.h"

namespace hygroloom {

/// What resources/schema says of objects and lists, with the rows of fields that it names filled in.
ProjectJson project_schema();

} // namespace hygroloom
