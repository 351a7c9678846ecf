// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A model plan, and what a run made of it, as JSON: for recordings, for metrics and for scripts.
#pragma once

#include "core/plan/model_plan.h"
#include "core/plan/switched_part.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace hygroloom {

/// One JSON object; keys carry their units.
nlohmann::ordered_json plan_value(const ModelPlan& plan);
std::string plan_json(const ModelPlan& plan);

/// Throws Error when it is not what plan_json() wrote.
ModelPlan plan_from_value(const nlohmann::ordered_json& json);
ModelPlan plan_from_json(const std::string& text);

/// A list of the parts that a run switched on, or would have, and back again. Throws Error likewise.
nlohmann::ordered_json switched_value(const std::vector<SwitchedPart>& parts);
std::string switched_json(const std::vector<SwitchedPart>& parts);
std::vector<SwitchedPart> switched_from_value(const nlohmann::ordered_json& json);
std::vector<SwitchedPart> switched_from_json(const std::string& text);

} // namespace hygroloom
