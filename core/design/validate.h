// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is wrong with a design, in sentences. A wrong design is a list of issues, never an exception.
#pragma once

#include "core/design/design.h"

namespace hygroloom {

enum class Severity { note, warning, error };

struct Issue {
    Severity severity = Severity::error;
    std::string code;  ///< stable, for programs: "range", "unknown_material", "ends_do_not_fit", ...
    std::string where; ///< path into the project: "fabrics[0].warp.diameter_mm"
    std::string text;  ///< what, allowed range, what was given
};

/// Errors refuse a run; warnings and notes do not. In the order of the project file.
std::vector<Issue> validate(const Design& design);

bool has_error(const std::vector<Issue>& issues);

} // namespace hygroloom
