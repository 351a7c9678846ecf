// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/plan_run.h"

#include "core/base/error.h"
#include "core/plan/expectation.h"
#include "core/plan/planning.h"
#include "core/run/learned_times.h"

#include <algorithm>

namespace hygroloom {

ModelPlan plan_run(const Design& design, const Fabric& fabric, const Experiment& experiment, Fidelity fidelity, const ForcedParts& forced,
                   const KnobSettings& settings, const std::string& backend)
{
    return plan_run(design, textile_of_run(design, fabric, experiment), experiment, fidelity, forced, settings, backend);
}

ModelPlan plan_run(const Design& design, const Textile& textile, const Experiment& experiment, Fidelity fidelity, const ForcedParts& forced,
                   const KnobSettings& settings, const std::string& backend)
{
    ModelPlan plan = plan_model(design, textile, experiment, fidelity, forced, settings);
    expect(plan, shipped_measurements(backend), shipped_measurements());
    expect_as_learned(plan, backend);
    return plan;
}

std::size_t bytes_of_largest(const Design& design, const Experiment& experiment, const std::vector<Textile>& textiles,
                             const RunOptions& how)
{
    double most = 0;
    for (const Textile& textile : textiles) {
        try {
            const ModelPlan plan = plan_run(design, textile, experiment, how.fidelity, how.forced, how.knobs);
            most = std::max(most, plan.expected_bytes);
        } catch (const Error&) {
            // The run reports it.
        }
    }
    return static_cast<std::size_t>(most);
}

} // namespace hygroloom
