// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The plan of one run: what it computes and what it is expected to take.
#pragma once

#include "core/run/run_options.h"

namespace hygroloom {

/// Builds the experiment's textile, plans it and fills in what is expected on the backend ("cpu", "cuda"), as learned_times.h knows it.
/// Precondition: validate() found no error. Throws Error when a knob is set out of its range.
ModelPlan plan_run(const Design& design, const Fabric& fabric, const Experiment& experiment, Fidelity fidelity,
                   const ForcedParts& forced = {}, const KnobSettings& settings = {}, const std::string& backend = "cpu");
/// The same of a textile that is there.
ModelPlan plan_run(const Design& design, const Textile& textile, const Experiment& experiment, Fidelity fidelity,
                   const ForcedParts& forced = {}, const KnobSettings& settings = {}, const std::string& backend = "cpu");

/// The memory (bytes) that the largest of the runs takes, by its plan; of the textiles of the experiment: see textile_of_run().
std::size_t bytes_of_largest(const Design& design, const Experiment& experiment, const std::vector<Textile>& textiles,
                             const RunOptions& how);

} // namespace hygroloom
