// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Many runs for one answer, for Python: fabrics side by side, and inputs fitted to a measurement.
#include "app/python/bindings.h"
#include "app/python/machine.h"
#include "app/python/unlocked.h"

#include "core/project/atomic_file.h"
#include "core/queue/calibration_runs.h"
#include "core/queue/compared_runs.h"
#include "core/run/plan_run.h"
#include "core/run/recording_target.h"
#include "core/wear/wear_outcomes.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace hygroloom::python {
namespace {

std::vector<FreeInput> free_inputs(const Design& design, const Fabric& fabric, const std::vector<std::string>& keys)
{
    std::set<std::string> seen;
    std::vector<FreeInput> inputs;
    for (const std::string& key : keys) {
        if (!seen.insert(key).second) throw Error(fmt::format("free: {} is named twice.", key));
        inputs.push_back(free_input(design, fabric, key));
    }
    if (inputs.empty()) throw Error("free: Name an input: contact_angle_deg, receding_angle_deg or packing_factor.");
    return inputs;
}

struct Calibrated {
    std::string json, report, refusal;
    std::optional<Design> design = {}; ///< none: the data do not tell the inputs
};

Calibrated calibrated(const Design& design, const std::string& fabric_name, const std::string& experiment_name, const std::string& measured,
                      const std::string& measured_name, const std::vector<std::string>& keys, const RunArguments& arguments, Watch& watch)
{
    RunOptions how = run_options(arguments);
    const auto fitted = require_valid(design);
    const Experiment& experiment = chosen_experiment(design, experiment_name);
    const Fabric& fabric = chosen_fabric(design, fabric_name);
    const std::vector<FreeInput> inputs = free_inputs(design, fabric, keys);
    const MeasuredData data = read_measured_data(measured, measured_name, design, fabric, experiment);
    const std::vector<Textile> textiles = textiles_of_runs(design, fitted, {fabric.name}, experiment);
    const int most = 2 * static_cast<int>(inputs.size()); // runs side by side
    const auto places = open_places(arguments, arguments.at_once, most, bytes_of_largest(design, experiment, textiles, how));
    RunQueue queue;
    CalibrationRuns runs{design, fabric.name,           experiment.name,     data, inputs, how, queue,
                         places, backend_of(arguments), watch.control.cancel};
    std::optional<ManyRuns> round;
    runs.started = [&](std::size_t points) { round.emplace(watch, points); };
    runs.progress = [&](std::size_t point, const RunProgress& progress) { round->tell(point, share_of(progress)); };
    const Calibration result = calibrate(runs);
    Calibrated all{calibration_json(result), html_of(calibration_report(result)), result.refusal};
    if (result.identifiable()) all.design = calibrated_design(design, result);
    return all;
}

py::tuple calibrate_fabric(const Design& design, const std::string& fabric, const std::string& experiment, const std::string& measured,
                           const std::string& measured_name, const std::vector<std::string>& keys, const py::dict& how,
                           const py::object& progress)
{
    const RunArguments arguments = run_arguments(how);
    Calibrated result = watched(
        progress, [=](Watch& watch) { return calibrated(design, fabric, experiment, measured, measured_name, keys, arguments, watch); });
    const py::object fitted = result.design ? py::cast(std::move(*result.design)) : py::none();
    return py::make_tuple(text(result.json), fitted, text(result.refusal), text(result.report));
}

struct CompareArguments {
    std::vector<std::string> fabrics;
    std::string experiment, by, baseline;
    int replicates = 1;
    std::string folder; ///< of the project, from where it names a garment's files
};

Comparison comparison_of(const CompareArguments& asked, const std::string& experiment, std::vector<OutcomeInfo> criteria)
{
    Comparison comparison;
    comparison.experiment = experiment;
    comparison.criteria = std::move(criteria);
    comparison.ranked_by = criterion_named(comparison.criteria, asked.by);
    comparison.replicates = asked.replicates;
    comparison.baseline = asked.baseline.empty() ? asked.fabrics.front() : asked.baseline;
    if (std::find(asked.fabrics.begin(), asked.fabrics.end(), comparison.baseline) == asked.fabrics.end())
        throw Error(fmt::format("baseline: \"{}\" is not among the compared fabrics.", comparison.baseline));
    return comparison;
}

/// A garment cut from each of the fabrics.
std::vector<NamedJob> compared_garments(const Design& design, const CompareArguments& asked, const WearExperiment& wear,
                                        const RunArguments& arguments)
{
    if (!arguments.physics.empty()) throw Error("A worn garment does not take physics.");
    const auto shared = std::make_shared<const Design>(design);
    std::vector<NamedJob> jobs;
    for (const std::string& fabric : asked.fabrics)
        jobs.push_back({fabric, {shared, wear.name, fabric, std::filesystem::absolute(asked.folder), garment_options(arguments)}});
    return jobs;
}

std::string run_compared(Comparison comparison, const std::vector<NamedJob>& jobs, std::size_t bytes, const RunArguments& arguments,
                         Watch& watch)
{
    const std::size_t runs = jobs.size() * static_cast<std::size_t>(comparison.replicates);
    const auto places = open_places(arguments, arguments.at_once, static_cast<int>(runs), bytes);
    ManyRuns all(watch, runs);
    ComparedWatch compared;
    compared.begins = [&](std::size_t i, RunJob& job) {
        job.beside.progress = [&all, i](const RunProgress& progress) { all.tell(i, share_of(progress)); };
    };
    compared.ended = [&](std::size_t i) { all.end(i); };
    RunQueue queue;
    run_comparison(comparison, jobs, queue, places, watch.control.cancel, compared);
    return comparison_json(comparison);
}

std::string compared(const Design& design, CompareArguments asked, const RunArguments& arguments, Watch& watch)
{
    const auto fitted = require_valid(design);
    if (asked.fabrics.empty())
        for (const Fabric& fabric : design.fabrics) asked.fabrics.push_back(fabric.name);
    std::set<std::string> seen;
    for (const std::string& name : asked.fabrics)
        if (!seen.insert(chosen_fabric(design, name).name).second) throw Error(fmt::format("fabrics: \"{}\" is named twice.", name));
    if (asked.fabrics.size() < 2) throw Error("A comparison needs two or more fabrics; use simulate for one.");
    if (const WearExperiment* wear = chosen_wear(design, asked.experiment)) {
        const std::vector<NamedJob> jobs = compared_garments(design, asked, *wear, arguments);
        Comparison comparison = comparison_of(asked, wear->name, compared_by_wear());
        comparison.of_garments = true;
        double bytes = 0;
        for (const NamedJob& each : jobs) bytes = std::max(bytes, bytes_of(each.job));
        return run_compared(comparison, jobs, static_cast<std::size_t>(bytes), arguments, watch);
    }
    const RunOptions how = run_options(arguments);
    const Experiment& experiment = chosen_experiment(design, asked.experiment);
    const std::vector<Textile> textiles = textiles_of_runs(design, fitted, asked.fabrics, experiment);
    return run_compared(comparison_of(asked, experiment.name, compared_by(experiment.type)),
                        jobs_of(design, asked.fabrics, experiment.name, textiles, how), bytes_of_largest(design, experiment, textiles, how),
                        arguments, watch);
}

py::str compare(const Design& design, const std::vector<std::string>& fabrics, const std::string& experiment, const std::string& by,
                const std::string& baseline, int replicates, const std::string& folder, const py::dict& how, const py::object& progress)
{
    const RunArguments arguments = run_arguments(how);
    const CompareArguments asked{fabrics, experiment, by, baseline, replicates, folder};
    return text(watched(progress, [=](Watch& watch) { return compared(design, asked, arguments, watch); }));
}

/// A recording, as a whole.
void copy_file(const std::string& from, const std::string& to)
{
    bring_in_left_over(from);
    write_file_with(to, [&](const std::filesystem::path& temporary) {
        std::error_code failure;
        if (!std::filesystem::exists(from, failure)) throw FileError(from + ": The file is not there any more.");
        if (!std::filesystem::copy_file(from, temporary, failure))
            throw FileError(fmt::format("{}: The file cannot be written: {}.", to, failure.message()));
    });
}

} // namespace

void add_studies(py::module_& module)
{
    module.def("calibrate", &calibrate_fabric);
    module.def("compare", &compare);
    module.def("write_text", [](const std::string& path, const std::string& content) { write_file(path, content); });
    module.def("copy_file", &copy_file, py::call_guard<Unlocked>());
}

} // namespace hygroloom::python
