// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether yarns side by side are simulated as one.
#pragma once

#include "core/plan/model_plan.h"

namespace hygroloom {

/// Fills in the crossings per cell. Returns a sentence, with a space before it, where they are several or could have been.
std::string decide_bundles(ModelPlan& plan, const Textile& textile, ExperimentType type);

/// Fills in which of the knobs for bundles have no effect, and why; an empty reason where one has. After decide_bundles().
void find_idle_bundle_knobs(ModelPlan& plan, const Textile& textile, ExperimentType type);

} // namespace hygroloom
