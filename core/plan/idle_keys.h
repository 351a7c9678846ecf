// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Keys of the project that change no water in an experiment. Names, colours and what is only drawn never do and are not among them.
#pragma once

#include "core/plan/model_plan.h"

namespace hygroloom {

struct IdleKey {
    std::string key;     ///< object of the schema and its key: "yarn.twist_per_m"
    std::string because; ///< in a clause: "only the closure pores reads it"
};

/// Each once, by what of the fabric, the experiment and its plan makes them idle.
std::vector<IdleKey> idle_keys(const Fabric& fabric, const Experiment& experiment, const ModelPlan& plan);

} // namespace hygroloom
