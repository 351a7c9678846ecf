// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is wrong at one place of a design.
#pragma once

#include "core/base/message.h"
#include "core/design/place.h"

#include <algorithm>
#include <string>
#include <vector>

namespace hygroloom {

enum class Severity { note, warning, error };

struct Issue {
    Severity severity = Severity::error;
    std::string code; ///< stable, for programs: "range", "unknown_material", "ends_do_not_fit", ...
    Place where;
    Message message; ///< what, allowed range, what was given

    std::string text() const { return english(message); }
};

/// nullptr: there is none. Points into the list.
inline const Issue* first_error(const std::vector<Issue>& issues)
{
    const auto found = std::find_if(issues.begin(), issues.end(), [](const Issue& issue) { return issue.severity == Severity::error; });
    return found == issues.end() ? nullptr : &*found;
}
const Issue* first_error(std::vector<Issue>&&) = delete; // it would point into what is gone

inline bool has_error(const std::vector<Issue>& issues) { return first_error(issues) != nullptr; }

} // namespace hygroloom
