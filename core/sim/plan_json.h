// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A model plan as JSON: for recordings, for metrics and for scripts.
#pragma once

#include "core/sim/model_plan.h"

namespace hygroloom {

/// One JSON object; keys carry their units.
std::string plan_json(const ModelPlan& plan);

/// Throws Error when it is not what plan_json() wrote.
ModelPlan plan_from_json(const std::string& text);

} // namespace hygroloom
