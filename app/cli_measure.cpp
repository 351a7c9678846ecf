// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// measure: numbers, maps and reports from a recording.
#include "app/cli.h"
#include "app/cli_bar.h"
#include "app/cli_interrupt.h"
#include "app/cli_metrics.h"
#include "app/cli_report.h"
#include "app/cli_wear.h"

#include "core/analysis/map_picture.h"
#include "core/analysis/metrics_json.h"
#include "core/analysis/outcomes.h"
#include "core/analysis/recording_netcdf.h"
#include "core/analysis/report.h"
#include "core/analysis/vtk_files.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/project/atomic_file.h"
#include "core/wear/wear_recording.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

struct MeasureOptions : CommonOptions {
    std::string recording;
    std::string map;
    std::string quantity = "water";
    int cells = 2;
    double time = -1;
    std::string output;
    std::string report;
    std::string vtk;
    std::string netcdf;
    int every = 1;
};

void write_map(const Recording& recording, const MeasureOptions& options)
{
    MapSide side{};
    ShownQuantity quantity{};
    try {
        side = map_side_from_name(options.map);
        quantity = shown_quantity_from_name(options.quantity);
    } catch (const Error& error) {
        throw Stop(exit_usage, error.what());
    }
    const std::string ending = std::filesystem::path(options.output).extension().string();
    if (ending != ".csv" && ending != ".png") throw Stop(exit_usage, "A map is a .csv or .png file; name it with -o.");

    const RunRecord& run = recording.run();
    const Frame frame = recording.frame(frame_at(recording, options.recording, options.time));
    if (const std::string why = why_not_shown(run.plan, quantity); !why.empty()) throw Stop(exit_invalid, options.recording + ": " + why);
    const MapPicture picture = quantity == ShownQuantity::water
                                   ? map_picture(run, frame, start_of_maps(run, recording.frame(0)), side, options.cells)
                                   : quantity_picture(run, frame, quantity, side, options.cells);
    if (ending == ".csv")
        write_cell_map_csv(picture.map, run, frame.time, side, options.output);
    else
        write_picture(picture, options.output);
    if (!options.quiet) print_note("Map at {:.4g} s: {}\n", frame.time, options.output);
}

/// With maps of both faces at --time.
void write_report(const Recording& recording, const Metrics& metrics, const MeasureOptions& options)
{
    const RunRecord& run = recording.run();
    const Frame frame = recording.frame(frame_at(recording, options.recording, options.time));
    const std::vector<ReportPicture> pictures = pictures_of_faces(run, frame, start_of_maps(run, recording.frame(0)), options.cells);
    write_report_file(options.report, report_of(run, metrics, pictures, recording.finished()));
    if (!options.quiet) print_note("Report: {}\n", options.report);
}

void write_vtk_files(const Recording& recording, const MeasureOptions& options)
{
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    int frames = 0;
    try {
        FileBar bar(options.quiet);
        frames = write_vtk(recording, options.vtk, options.every, [&](double share) {
            bar.show(share);
            return !cancel;
        });
    } catch (const Cancelled&) {
        throw Stop(exit_cancelled, "Cancelled. The frames written so far are in " + options.vtk + ".");
    }
    if (!options.quiet) print_note("{} frames are in {}; open yarns.pvd.\n", frames, options.vtk);
}

void write_netcdf_file(const Recording& recording, const Metrics& metrics, const MeasureOptions& options)
{
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    FileBar bar(options.quiet);
    write_netcdf(recording, metrics, options.cells, options.netcdf, [&](double share) {
        bar.show(share);
        return !cancel;
    });
    bar.clear();
    if (!options.quiet) print_note("NetCDF: {}\n", options.netcdf);
}

/// What is written must not take the place of what is read.
void require_other_files(const MeasureOptions& options)
{
    std::vector<std::filesystem::path> written{options.output, options.report, options.netcdf};
    if (!options.vtk.empty()) {
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(options.vtk, none))
            if (const std::string ending = entry.path().extension().string(); ending == ".vtp" || ending == ".pvd" || ending == ".series")
                written.push_back(entry.path());
    }
    for (const std::filesystem::path& path : written) {
        std::error_code none; // no such file: another
        if (!path.empty() && std::filesystem::equivalent(path, options.recording, none))
            throw Stop(exit_usage, path.string() + ": This is the recording that is measured; give another name for what is written.");
    }
}

std::unique_ptr<Recording> opened(const MeasureOptions& options)
{
    try {
        return std::make_unique<Recording>(options.recording);
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
}

/// Throws Stop when nothing is left.
void say_what_is_missing(const Recording& recording, const MeasureOptions& options)
{
    constexpr std::size_t most_named = 20;
    const std::vector<std::string>& problems = recording.problems();
    for (std::size_t i = 0; i < std::min(problems.size(), most_named); ++i) print_note("{}\n", problems[i]);
    if (problems.size() > most_named) print_note("{}: {} more frames are left out.\n", options.recording, problems.size() - most_named);
    if (recording.frames() == 0) throw Stop(exit_invalid, options.recording + ": The recording has no frames.");
    if (recording.finished() || options.quiet) return;
    const double end = recording.ledgers().back().time;
    if (recording.is_being_written())
        print_note("{}: The run goes on; measured is up to {:.4g} s.\n", options.recording, end);
    else
        print_note("{}: The run was stopped at {:.4g} s.\n", options.recording, end);
}

int measure(const MeasureOptions& options)
{
    check_report_name(options.report);
    if (options.time >= 0 && options.map.empty() && options.report.empty())
        throw Stop(exit_usage, "--time sets the time of the maps; it goes with --map or --report.");
    if (options.map.empty() != options.output.empty()) throw Stop(exit_usage, "--map (the side) and -o (the file) go together.");
    if (options.quantity != "water" && options.map.empty()) throw Stop(exit_usage, "--quantity says what a map shows; it goes with --map.");
    if (WearRecording::is_one(options.recording)) {
        if (!options.map.empty() || !options.vtk.empty() || !options.netcdf.empty())
            throw Stop(exit_usage, options.recording + ": This is the recording of a worn garment; `garment map` writes its maps.");
        return measure_garment(options.recording, options, options.report, options.time);
    }
    require_other_files(options);
    const std::unique_ptr<Recording> recording = opened(options);
    MetricsCollector collector;
    collector.start(recording->run());
    recording->read_frames([&](const Frame& frame) {
        collector.add(frame);
        return true;
    });
    say_what_is_missing(*recording, options);
    if (!options.map.empty()) write_map(*recording, options);
    const Metrics metrics = collector.metrics();
    if (!options.report.empty()) write_report(*recording, metrics, options);
    if (!options.vtk.empty()) write_vtk_files(*recording, options);
    if (!options.netcdf.empty()) write_netcdf_file(*recording, metrics, options);
    print_metrics(recording->run(), metrics, options.json);
    return exit_ok;
}

void row(const std::string& name, double value, const std::string& unit) { print_result("  {:<34} {:>10.4g} {}\n", name, value, unit); }

/// " ± 0.05" behind a number; nothing where the width is 0 or not known.
std::string half_width_text(const Outcome& outcome, const std::map<std::string, Interval>& intervals)
{
    const auto found = intervals.find(outcome.key);
    if (found == intervals.end()) return {};
    const ShownInterval seen = shown(outcome, found->second);
    if (seen.cut) return fmt::format(" ({} to {})", rounded_text(seen.low, 2), rounded_text(seen.high, 2));
    return seen.half > 0 ? " ± " + rounded_text(seen.half, 2) : "";
}

void print_outcome(const Outcome& outcome, const std::map<std::string, Interval>& intervals)
{
    const std::string name = full_title(outcome);
    if (!outcome.text.empty()) return print_result("  {:<34} {}\n", name, outcome.text);
    std::string remarks = outcome.grade ? fmt::format("grade {}", *outcome.grade) : "";
    for (const std::string& remark : {outcome.missing, outcome.remark})
        if (!remark.empty()) remarks += (remarks.empty() ? "" : "; ") + remark;
    if (!remarks.empty()) remarks = "(" + remarks + ")";
    if (!outcome.value) return print_result("  {:<34} {:>10} {}\n", name, "-", remarks);
    const auto found = intervals.find(outcome.key);
    const ShownValue value = shown(outcome, found == intervals.end() ? *outcome.value : found->second.centre);
    if (!value.unit.empty() && !remarks.empty()) remarks = " " + remarks;
    print_result("  {:<34} {:>10.4g}{} {}{}\n", name, value.value, half_width_text(outcome, intervals), value.unit, remarks);
}

} // namespace

void print_outcomes(const std::vector<Outcome>& outcomes, const std::map<std::string, Interval>& intervals)
{
    for (const Outcome& outcome : outcomes)
        if (is_shown(outcome)) print_outcome(outcome, intervals);
}

void print_metrics(const RunRecord& run, const Metrics& m, bool json, const std::map<std::string, Interval>& of_replicates)
{
    if (json) {
        print_result("{}\n", metrics_json(run, m, of_replicates));
        return;
    }
    const std::map<std::string, Interval> intervals = of_replicates.empty() ? numerical_intervals(run, m) : of_replicates;
    const Ledger& l = m.ledger;
    const bool is_unfinished = run.wall <= 0; // how long it took is not known
    print_result("{}, {} ({}, {}, {})\n", run.fabric, run.experiment, name_of(run.plan.fidelity), run.backend,
                 is_unfinished ? "unfinished" : rounded_text(run.wall, 3) + " s");
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    row("simulated", l.time, is_unfinished && experiment ? fmt::format("s of {:.4g}", experiment->duration_s) : "s");
    print_outcomes(outcomes_of(run, m), intervals);
    for (const BalanceRow& of : water_balance(l)) row(of.title, of.value, of.unit);
    const BalanceRow imbalance = balance_check(l).front();
    row(imbalance.title, imbalance.value, imbalance.unit);
    if (!m.series.temperature_max.empty())
        row("highest temperature", celsius_from_kelvin(*std::max_element(m.series.temperature_max.begin(), m.series.temperature_max.end())),
            "°C");
    if (!of_replicates.empty()) {
        print_result("  After ±: half of the interval that holds {:.0f} % of such cloths, by {} replicates and the numerical error.\n",
                     100 * of_intervals.held, of_replicates.begin()->second.runs);
        const std::string few = few_replicates_text(of_replicates.begin()->second.runs);
        if (!few.empty()) print_result("  {}\n", few);
    } else if (!run.plan.expected_errors.empty())
        print_result(
            "  After ±: the numerical error, as measured on runs of this kind. --replicates 8 adds what is not known of the cloth.\n");
    else
        print_result("  The numerical error of these numbers is not known.\n");
    for (const std::string& note : notes_of(run.plan)) print_result("  {}\n", note);
    for (const std::string& note : m.notes) print_result("  {}\n", note);
    for (const std::string& sentence : m.assumed) print_result("  Assumed: {}\n", sentence);
}

void add_measure(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<MeasureOptions>();
    CLI::App& measure_verb = *app.add_subcommand("measure", "Print the metrics of a recording; write maps, reports and ParaView files");
    measure_verb.footer("Example: hygroloom-cli measure cloth.hygrorec --map top --cells 2 -o top.png");
    measure_verb.add_option("recording", options->recording, "Recording (.hygrorec)")->required()->type_name("FILE");
    measure_verb.add_option("--map", options->map, "Write a map of this side")->type_name("{top,bottom,total}");
    measure_verb.add_option("--quantity", options->quantity, "What the map shows; humidity: relative humidity in the pores of the yarns")
        ->type_name("{water,temperature,humidity}");
    measure_verb.add_option("--cells", options->cells, "Map resolution: N x N crossings per cell")->check(CLI::Range(1, 1000));
    measure_verb.add_option("--time", options->time, "Time of the maps, s; the end when left out")
        ->default_str("")
        ->check(time_validator());
    measure_verb.add_option("-o,--output", options->output, "File of the map (.csv or .png)")->type_name("FILE");
    const CLI::Validator given([](const std::string& text) { return text.empty() ? "the file name is empty" : ""; }, "");
    measure_verb
        .add_option("--report", options->report, "Write a report (.html, .pdf, .txt or .json) with results, maps, charts and inputs")
        ->type_name("FILE")
        ->check(given);
    CLI::Option* vtk =
        measure_verb
            .add_option("--vtk", options->vtk, "Write the yarns and the liquid of all frames to this folder for ParaView (.vtp, .pvd)")
            ->type_name("FOLDER")
            ->check(given);
    measure_verb
        .add_option("--netcdf", options->netcdf,
                    "Write maps, values of the segments and series of all frames as NetCDF (.nc), which xarray opens")
        ->type_name("FILE")
        ->check(given);
    measure_verb.add_option("--every", options->every, "With --vtk: write every Nth frame")->check(CLI::Range(1, 1000000))->needs(vtk);
    add_common_options(measure_verb, *options);
    measure_verb.callback([&verb, options] { verb = [options] { return measure(*options); }; });
}

} // namespace hygroloom
