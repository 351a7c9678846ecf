// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/sample_forecast.h"

#include "core/base/error.h"
#include "core/plan/frame_times.h"
#include "ui/results/plan_dialog.h"

namespace hygroloom {

RunForecasts sampleForecasts(const Design& design, const Fabric& fabric, const Experiment& experiment, const FittedFabric* fitted,
                             const std::string& machine, const NewestJob::Turn& turn)
{
    RunForecasts forecasts;
    std::optional<Textile> textile;
    for (std::size_t i = 0; i < forecasts.size() && !turn.outdated(); ++i) {
        try {
            if (!textile) { textile = textile_of_run(design, fabric, experiment, fitted); }
            ModelPlan plan = plan_run(design, *textile, experiment, all_fidelities[i], {}, {}, machine);
            plan.expected_seconds = seconds_to_wait(plan, true); // the window records each run
            forecasts[i] = {shortExpectation(plan), "<p>" + PlanDialog::tr("Expected: %1").arg(expectation(plan)) + "</p>", {}, {}, plan};
        } catch (const Error& error) {
            forecasts[i].problem = QString::fromStdString(error.what());
        }
    }
    return forecasts;
}

} // namespace hygroloom
