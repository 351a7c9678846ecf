// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Decides before a run what it needs to compute: which parts of the physics, and how finely.
#pragma once

#include "core/plan/model_plan.h"

namespace hygroloom {

/// The textile is that of the experiment's whole sample: see textile_of_run(). The plan has no expectation yet: see expect().
/// Precondition: validate() found no error. Throws Error when a knob is set out of its range.
ModelPlan plan_model(const Design& design, const Textile& textile, const Experiment& experiment, Fidelity fidelity,
                     const ForcedParts& forced = {}, const KnobSettings& settings = {});

} // namespace hygroloom
