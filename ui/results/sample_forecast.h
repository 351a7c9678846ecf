// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What runs of a sample are expected to take, and the physics that they would model.
#pragma once

#include "core/run/plan_run.h"
#include "ui/results/run_subject.h"

namespace hygroloom {

/// Of each fidelity. fitted: the fabric's yarns; nullptr: they are fitted for it.
RunForecasts sampleForecasts(const Design& design, const Fabric& fabric, const Experiment& experiment, const FittedFabric* fitted,
                             const std::string& machine, const NewestJob::Turn& turn);

} // namespace hygroloom
