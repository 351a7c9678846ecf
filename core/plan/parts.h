// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which parts of the physics a plan models, and why.
#pragma once

#include "core/plan/bounds.h"
#include "core/plan/model_plan.h"

namespace hygroloom {

/// Fills in the plan's parts and the water at stake.
void decide_parts(ModelPlan& plan, const Bounds& bounds, const Experiment& experiment, const ForcedParts& forced);

} // namespace hygroloom
