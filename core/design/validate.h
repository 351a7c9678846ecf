// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is wrong with a design, in sentences. A wrong design is a list of issues, never an exception.
#pragma once

#include "core/design/fitted_fabric.h"
#include "core/design/issue.h"

namespace hygroloom {

/// Errors refuse a run; warnings and notes do not. In the order of the project file.
std::vector<Issue> validate(const Design& design);

/// The issues, and each fabric as it was fitted to find them.
struct Validation {
    std::vector<Issue> issues;
    std::vector<std::shared_ptr<const FittedFabric>> fabrics; ///< in the design's order; nullptr where a fabric or a material has an error
};
Validation validate_and_fit(const Design& design);

} // namespace hygroloom
