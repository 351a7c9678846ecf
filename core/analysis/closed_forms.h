// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Closed-form results that a run must approach at any resolution.
#pragma once

#include "core/run/runner.h"

#include <map>
#include <string>

namespace hygroloom {

/// Of a run in air that stays the same, by the keys of outcomes_of(): the regain in equilibrium with the air (conditioning); the
/// temperature at which the air warms a wet sheet as fast as evaporation cools it, and the rate then, off both faces (drying; none where
/// the fibres hold so much that the sheet is no longer wet at the end of the constant-rate period).
std::map<std::string, double> closed_forms(const RunRecord& run);

} // namespace hygroloom
