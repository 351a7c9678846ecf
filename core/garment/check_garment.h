// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is wrong with a project's garments beyond the project's own text: with the files that they name, and names that their patterns lack.
#pragma once

#include "core/design/design.h"
#include "core/design/issue.h"
#include "core/garment/pattern.h"

#include <optional>

namespace hygroloom {

/// Panels and seams that a garment names and its pattern does not have, as warnings; where: of the garment, such as garments[0].
std::vector<Issue> misnamed_in(const Garment& garment, const GarmentPattern& pattern, const Place& where);

struct GarmentCheck {
    std::vector<Issue> issues;                           ///< files that cannot be read are errors
    std::vector<std::optional<GarmentPattern>> patterns; ///< of each garment; none: it could not be read
};
/// Reads each garment's pattern and table of sweat, and each wear experiment's rates over time. base: folder of the project. What known
/// holds errors about is not read.
GarmentCheck check_garments(const Design& design, const std::filesystem::path& base, const std::vector<Issue>& known);

} // namespace hygroloom
