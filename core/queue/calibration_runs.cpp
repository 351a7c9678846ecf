// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/queue/calibration_runs.h"

#include "core/analysis/intervals.h"
#include "core/base/error.h"
#include "core/run/plan_run.h"

#include <cmath>
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
    if (started) started(points.size());
    RunBatch batch;
    batch.name = name;
    batch.count = points.size();
    batch.places = places;
    batch.watched = true; // its rounds follow each other, and their dialog is open
    batch.job = [&](std::size_t i) {
        RunJob job{std::make_shared<const Design>(with_inputs(design, fabric, inputs, points[i])), experiment, fabric};
        job.how = how;
        if (progress) job.beside.progress = [&, i](const RunProgress& now) { progress(i, now); };
        return job;
    };
    batch.ended = [&](std::size_t i, RunResult& result) {
        if (result.error) std::rethrow_exception(result.error);
        numbers[i] = simulated_of(data, result.sample->run, result.sample->metrics);
    };
    if (!queue.run(std::move(batch), cancel) || cancel) throw Cancelled();
    return numbers;
}

std::vector<NumberError> CalibrationRuns::errors_of(const std::vector<double>& simulated) const
{
    RunRecord run;
    run.design = design;
    run.fabric = fabric;
    run.experiment = experiment;
    run.plan =
        plan_run(design, *find_fabric(design, fabric), *find_experiment(design, experiment), how.fidelity, how.forced, how.knobs, backend);
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

} // namespace hygroloom
