// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/calibration.h"
#include "core/analysis/sweep.h"
#include "core/base/error.h"

namespace hygroloom {

std::vector<std::vector<double>> CalibrationRuns::operator()(const std::vector<std::vector<double>>& points) const
{
    std::vector<std::vector<double>> numbers(points.size());
    std::mutex one_on_cpu;
    RunOptions options = how;
    options.one_on_cpu = &one_on_cpu;
    if (started) started(points.size());
    run_side_by_side(backends, points.size(), control, [&](std::size_t i, Backend& backend) {
        RunCallbacks beside;
        if (progress) beside.progress = [&, i](const RunProgress& now) { progress(i, now); };
        const FinishedRun run =
            run_and_measure(with_inputs(design, fabric, inputs, points[i]), fabric, experiment, options, backend, control, beside);
        numbers[i] = simulated_of(data, run.run, run.metrics);
        return !run.device_failure.empty();
    });
    if (control.cancel) throw Cancelled();
    return numbers;
}

} // namespace hygroloom
