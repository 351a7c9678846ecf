// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether yarns side by side are simulated as one.
#pragma once

#include "core/plan/model_plan.h"

namespace hygroloom {

/// Fills in the crossings per cell. Returns a sentence, with a space before it, where they are several or could have been.
std::string decide_bundles(ModelPlan& plan, const Textile& textile, ExperimentType type);

/// Fills in the cells in which frames show the sample: of about this side (m), of 64 yarns at most, or, with 0, each segment where that
/// makes at most 500 000 crossings, else about so many cells; or why there can be none. Yarns that are
/// simulated as one are never parted. After decide_bundles().
void decide_shown_cells(ModelPlan& plan, const Textile& textile, ExperimentType type, double side = 0);

/// Fills in which of the knobs for bundles have no effect, and why; an empty reason where one has. After decide_bundles().
void find_idle_bundle_knobs(ModelPlan& plan, const Textile& textile, ExperimentType type);

} // namespace hygroloom
