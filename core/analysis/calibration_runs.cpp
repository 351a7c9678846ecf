// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Calibrations by real runs, and the project that comes of one.
#include "core/analysis/calibration.h"
#include "core/analysis/intervals.h"
#include "core/analysis/sweep.h"
#include "core/base/error.h"
#include "core/run/plan_run.h"
#include "core/solver/backend.h"

#include <cmath>
#include <filesystem>
#include <map>

namespace hygroloom {
namespace {

/// The metric that is read from a curve. The height at the end is not: in all measured strips it is that of the whole strip.
const std::string& metric_of(const std::string& key)
{
    static const std::map<std::string, std::string> read_from{{"wick_height_mm", "wick_rate_mm_s05"},
                                                              {"wetted_radius_top_mm", "maximum_wetted_radius_top_mm"},
                                                              {"wetted_radius_bottom_mm", "maximum_wetted_radius_bottom_mm"}};
    const auto found = read_from.find(key);
    return found == read_from.end() ? key : found->second;
}

} // namespace

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

std::vector<NumberError> CalibrationRuns::errors_of(const std::vector<double>& simulated) const
{
    RunRecord run;
    run.design = design;
    run.fabric = fabric;
    run.experiment = experiment;
    run.plan = plan_run(design, *find_fabric(design, fabric), *find_experiment(design, experiment), how.fidelity, how.forced, how.knobs,
                        backends.front()->name());
    std::vector<NumberError> errors;
    for (std::size_t i = 0; i < simulated.size(); ++i) {
        const std::string& key = data.numbers[i].key;
        if (!data.is_curve()) {
            errors.push_back({numerical_error(run, key, simulated[i]), step_of(run, key)});
            continue;
        }
        const auto share = run.plan.expected_errors.find(metric_of(key));
        errors.emplace_back(); // its numbers jump at different values of an input
        if (share != run.plan.expected_errors.end()) errors.back().half = share->second * std::abs(simulated[i]);
    }
    return errors;
}

Calibration calibrate(const CalibrationRuns& runs)
{
    Calibration result =
        calibrate(runs.data, runs.inputs, std::cref(runs), [&runs](const std::vector<double>& at) { return runs.errors_of(at); });
    result.fabric = runs.fabric;
    result.experiment = runs.experiment;
    result.fidelity = runs.how.fidelity;
    return result;
}

Design calibrated_design(const Design& design, const Calibration& calibration)
{
    std::vector<FreeInput> inputs(calibration.inputs.begin(), calibration.inputs.end());
    std::vector<double> values;
    for (const FittedInput& input : calibration.inputs) values.push_back(input.value);
    Design other = with_inputs(design, calibration.fabric, inputs, values);
    Fabric& fabric = other.fabrics[static_cast<std::size_t>(find_fabric(other, calibration.fabric) - other.fabrics.data())];
    const std::string file = std::filesystem::path(calibration.data.file).filename().string(); // folders are this machine's
    Calibrated from{file, calibration.experiment, name_of(calibration.fidelity), calibration.data.quantity, calibration.residual_rms, {}};
    for (const FittedInput& input : calibration.inputs) {
        if (input.half > 0) uncertainty_of(fabric, input.key) = input.half; // else nothing is known of it
        before_of(from, input.key) = input.given;
    }
    fabric.calibrated = from;
    return other;
}

} // namespace hygroloom
