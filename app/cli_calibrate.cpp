// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// calibrate: inputs of a fabric that are not known, from one measurement.
#include "app/cli_fidelity.h"
#include "app/cli_interrupt.h"
#include "app/cli_report.h"

#include "core/project/atomic_file.h"
#include "core/project/project_file.h"
#include "core/queue/calibration_runs.h"
#include "core/run/plan_run.h"
#include "gpu/backends.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

namespace hygroloom {
namespace {

struct CalibrateOptions : FidelityOptions {
    std::string measured; ///< file
    std::string free;     ///< keys, separated by commas
    std::string output;   ///< project
    std::string report;
    int at_once = 0;
};

std::vector<FreeInput> chosen_inputs(const Design& design, const Fabric& fabric, const std::string& list)
{
    std::vector<FreeInput> inputs;
    for (const std::string& key : words_of(list)) {
        for (const FreeInput& other : inputs)
            if (other.key == key) throw Stop(exit_usage, fmt::format("--free: {} is named twice.", key));
        inputs.push_back(as_usage([&] { return free_input(design, fabric, key); }));
    }
    if (inputs.empty()) throw Stop(exit_usage, "--free: Name an input: contact_angle_deg, receding_angle_deg or packing_factor.");
    return inputs;
}

void check_output(const CalibrateOptions& options)
{
    check_report_name(options.report);
    std::error_code failure;
    if (!options.output.empty() && std::filesystem::equivalent(options.output, options.project, failure))
        throw Stop(exit_usage, "-o: The calibrated project is a file of its own; " + options.output + " is the one that is read.");
}

/// With the progress of each round of runs on a bar of its own.
Calibration fit(const CalibrateOptions& options, CalibrationRuns runs)
{
    std::optional<RunBar> bar;
    std::size_t done = 0;
    runs.started = [&](std::size_t points) {
        bar.emplace(options.quiet, points);
        done += points;
    };
    runs.progress = [&](std::size_t point, const RunProgress& progress) { bar->show(point, progress); };
    Calibration result = calibrate(runs);
    bar.reset();
    if (!options.quiet) print_note("{} runs.\n", done);
    return result;
}

void write_results(const CalibrateOptions& options, const Design& design, const Calibration& result)
{
    if (options.json)
        print_result("{}", calibration_json(result));
    else
        print_result("{}", calibration_table(result));
    if (!result.identifiable()) print_note("{}\n", result.refusal);
    if (result.identifiable() && !options.output.empty()) {
        write_project(calibrated_design(design, result), options.output);
        if (!options.quiet) print_note("Calibrated project: {}\n", options.output);
    }
    if (options.report.empty()) return;
    write_report_file(options.report, calibration_report(result));
    if (!options.quiet) print_note("Report: {}\n", options.report);
}

int calibrate_verb(const CalibrateOptions& options)
{
    check_fidelity(options);
    check_output(options);
    RunOptions how = run_options(options);
    how.may_go_on_on_cpu = true;
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    const Experiment& experiment = chosen_experiment(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    const std::vector<FreeInput> inputs = chosen_inputs(design, fabric, options.free);
    const MeasuredData data =
        read_measured_data(read_file(options.measured, std::size_t{16} << 20U), options.measured, design, fabric, experiment);
    const int most = 2 * static_cast<int>(inputs.size()); // runs side by side
    announce_scenes(options.at_once, most);
    const std::vector<Textile> textiles = textiles_of_runs(design, fitted, {fabric.name}, experiment);
    const FidelityChoice choice = chosen_fidelity(options, design, textiles, how.forced, how.knobs);
    how.fidelity = choice.fidelity;
    how.fidelity_reason = choice.reason;
    const auto places = open_places(options, options.at_once, most, bytes_of_largest(design, experiment, textiles, how));

    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    RunQueue queue;
    try {
        const Calibration result = fit(options, {design, fabric.name, experiment.name, data, inputs, how, queue, places,
                                                 expected_backend(backend_of(options)), cancel});
        write_results(options, design, result);
        return result.identifiable() ? exit_ok : exit_failed;
    } catch (const Cancelled&) {
        print_note("Cancelled; nothing was written.\n");
        return exit_cancelled;
    }
}

} // namespace

void add_calibrate(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<CalibrateOptions>();
    CLI::App& verb = *app.add_subcommand("calibrate", "Fit inputs of a fabric that are not known to one measurement");
    verb.footer(
        "Example: hygroloom-cli calibrate strip.hygro --experiment \"vertical wicking\" --measured strip.csv --free contact_angle_deg -o "
        "calibrated.hygro\n"
        "The measured file is a curve, with the columns time_s, a series such as wick_height_mm and, if known, spread (standard "
        "deviation); or a table of metrics, with fabric, metric, value, unit and spread.\n"
        "Exit code 1 and a sentence when the data cannot tell the inputs; nothing is then written with -o.\n"
        "What a fidelity is made of, and how to change a part of it: hygroloom-cli plan --help");
    add_project_options(verb, *options, true);
    options->takes_knobs = true;
    verb.add_option("--measured", options->measured, "What was measured of the fabric on the experiment (CSV)")
        ->required()
        ->type_name("FILE");
    verb.add_option("--free", options->free,
                    "Inputs to fit, separated by commas: contact_angle_deg, receding_angle_deg, packing_factor; within the fabric's "
                    "uncertainty, or a usual range")
        ->required()
        ->type_name("KEYS");
    add_fidelity_options(verb, *options, " of each run");
    add_physics_option(verb, *options);
    add_machine_options(verb, *options);
    verb.add_option("--at-once", options->at_once,
                    "Runs at the same time; 0: one on a CPU, up to 16 on each GPU. Results do not depend on it")
        ->check(CLI::Range(0, 1024));
    verb.add_option("--report", options->report, "Write a report (.html, .pdf, .txt or .json) with the fit and its residuals")
        ->type_name("FILE");
    verb.add_option("-o,--output", options->output, "Project with the calibrated fabric (.hygro)")->type_name("FILE");
    verb.callback([&chosen, options] { chosen = [options] { return calibrate_verb(*options); }; });
}

} // namespace hygroloom
