// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is wrong with a design, in sentences. A wrong design is a list of issues, never an exception.
#pragma once

#include "core/design/design.h"
#include "core/design/issue.h"

namespace hygroloom {

/// Errors refuse a run; warnings and notes do not. In the order of the project file.
std::vector<Issue> validate(const Design& design);

} // namespace hygroloom
