// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments that are worn: what a run would take, the run, maps of its recording.
#include "app/cli_wear.h"

#include "app/cli_interrupt.h"
#include "app/cli_metrics.h"
#include "app/cli_report.h"

#include "core/analysis/map_image.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/base/words.h"
#include "core/garment/check_garment.h"
#include "core/wear/wear_map.h"
#include "core/wear/wear_outcomes.h"
#include "core/wear/wear_report.h"
#include "gpu/backends.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <filesystem>
#include <optional>

namespace hygroloom {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A file that a garment names is the user's mistake.
template <typename Act> auto as_invalid(Act act)
{
    try {
        return act();
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
}

GarmentParts parts_of(const Design& design, const WearExperiment& wear, const std::string& project)
{
    return as_invalid([&] { return garment_parts(design, wear, folder_of(project)); });
}

RunOptions how_of(const WearVerbOptions& options)
{
    RunOptions how = run_options(options);
    how.fidelity = as_usage([&] { return fidelity_from_name(options.fidelity); });
    how.cell_side = metre_from_mm(options.cell_mm);
    how.shown_side = metre_from_mm(options.shown_mm);
    how.detail = options.detail;
    how.memory = memory_rule(options, "larger cells");
    how.may_go_on_on_cpu = true;
    how.recording = options.output;
    return how;
}

/// That yarns hold less than the experiment wets them with.
std::string of_initial_water(const WearMetrics& metrics, const WearRecord& record)
{
    const WearExperiment* const wear = find_wear(record.design, record.layout.experiment);
    const double asked = wear != nullptr ? wear->initial_water_g_m2 : 0.0,
                 there = 1e3 * metrics.at_start() / metrics.all().in_cells; // g/m2
    constexpr double rounding = 1e-3;
    if (there >= (1 - rounding) * asked) return {};
    return fmt::format("Of the {:.4g} g/m2 of water asked for at the start the yarns hold {:.4g}.\n", asked, there);
}

/// intervals: of replicates; else none.
void print_worn(const WearMetrics& metrics, const WearRecord& record, bool json, const std::map<std::string, Interval>& intervals = {})
{
    if (json) {
        print_result("{}\n", wear_json(metrics, intervals));
        return;
    }
    const WearLayout& layout = record.layout;
    print_result("{} in \"{}\", {}\n", layout.garment, layout.experiment, layout.cells_in_words);
    print_outcomes(outcomes_of(metrics, metrics.all()), intervals);
    print_result("\n{}{}", table_of_parts(metrics), of_initial_water(metrics, record));
}

/// The last words, and what the garment came to so far, if there is a frame.
int print_cancelled(const std::optional<WearMetrics>& metrics, const WearRecord* record, bool json)
{
    const LastWords* const words = last_words.exchange(nullptr);
    write_note(words->note);
    if (!metrics) {
        write_result(words->result);
    } else if (json) {
        Json object = Json::parse(words->result);
        object["so_far"] = Json::parse(wear_json(*metrics));
        print_json(object);
    } else {
        print_result("Up to {:.4g} s:\n", metrics->all().course.back().time);
        print_worn(*metrics, *record, false);
    }
    return exit_cancelled;
}

WearMetrics metrics_of(const WearRecording& recording)
{
    WearMetrics metrics(recording.record().layout);
    for (int k = 0; k < recording.frames(); ++k) metrics.add(as_invalid([&] { return recording.frame(k); }));
    return metrics;
}

std::vector<double> times_of(const WearRecording& recording)
{
    std::vector<double> times;
    for (int k = 0; k < recording.frames(); ++k) times.push_back(recording.time_of(k));
    return times;
}

void write_wear_report(const WearRecording& recording, const WearMetrics& metrics, const std::vector<double>& times,
                       const WearMapOptions& how, const std::string& file, bool quiet)
{
    const std::vector<ReportPicture> pictures =
        as_invalid([&] { return pictures_of_panels(recording, frames_for_report(times_of(recording), times), how); });
    write_report_file(file, wear_report(recording.record(), metrics, pictures, recording.finished()));
    if (!quiet) print_note("Report: {}\n", file);
}

WearSteps steps_of(const WearMapVerbOptions& options)
{
    WearSteps steps;
    if (options.steps.size() != steps.size())
        throw Stop(exit_usage, fmt::format("--steps: There must be {} numbers; given are {}.", steps.size(), options.steps.size()));
    std::copy(options.steps.begin(), options.steps.end(), steps.begin());
    return as_usage([&] {
        try {
            require_ascending(steps);
        } catch (const Error& error) {
            throw Error(std::string("--steps: ") + error.what());
        }
        return steps;
    });
}

/// Each computed cell by itself.
constexpr int as_computed = 1;

/// A scale of shares does not end at g/m2. Throws Stop.
void require_shares(const WearMapOptions& how)
{
    constexpr double most = 10; // cloth with all of its rooms filled holds a few times what its yarns can
    const double end = how.steps ? how.steps->back() : how.most;
    if (how.scale == WearScale::capacity && end > most)
        throw Stop(exit_usage,
                   fmt::format("{}: With --scale capacity this is a share of what the cloth can hold, up to {:g}; {:g} % is {:g}.",
                               how.steps ? fmt::format("--steps up to {:g}", end) : fmt::format("--most {:g}", end), most, end, end / 100));
}

/// Throws Stop for a time after the run's end.
void require_within(const char* option, double time, const WearRecording& recording)
{
    if (const double end = recording.time_of(recording.frames() - 1); time > end * (1 + 1e-5))
        throw Stop(exit_usage, fmt::format("{} {:g}: The run {} at {:g} s; take a time from 0 to {:g}.", option, time,
                                           recording.finished() ? "ends" : "was stopped", end, end));
}

/// Reports must not take the place of what is read.
void require_other_file(const std::string& report, const std::string& recording)
{
    check_report_name(report);
    std::error_code none; // no such file: another
    if (!report.empty() && fs::equivalent(report, recording, none))
        throw Stop(exit_usage, report + ": This is the recording that is read; give another name for what is written.");
}

/// Panels and seams that the garment names and does not have.
void print_misnamed(const Design& design, const GarmentParts& parts, const std::string& project)
{
    const auto number = static_cast<std::size_t>(parts.garment - design.garments.data());
    for (const Issue& issue : misnamed_in(*parts.garment, parts.pattern, Place("garments") / number)) print_issue(project, issue);
}

/// For what works on garments alone: of that name, or the only one on a garment. Throws Stop.
const WearExperiment& required_wear(const Design& design, const ProjectOptions& options)
{
    if (options.experiment.empty() && design.wears.size() == 1) return design.wears.front();
    if (const WearExperiment* wear = find_wear(design, options.experiment)) return *wear;
    if (design.wears.empty())
        throw Stop(exit_usage, "The project has no experiment of the type wear. hygroloom-cli garment import built-in:tee -o " +
                                   options.project + " adds a garment with one.");
    std::vector<std::string> names;
    std::string listed;
    for (const WearExperiment& wear : design.wears) {
        names.push_back(wear.name);
        listed += (listed.empty() ? "\"" : ", \"") + wear.name + "\"";
    }
    if (options.experiment.empty())
        throw Stop(exit_usage, "The project has several experiments of the type wear; choose one with --experiment: " + listed + ".");
    if (find_experiment(design, options.experiment) != nullptr)
        throw Stop(exit_usage,
                   fmt::format("The experiment \"{}\" is one on a sample of fabric; hygroloom-cli plan plans it. Of the type wear "
                               "the project has {}.",
                               options.experiment, listed));
    throw Stop(exit_usage, fmt::format("The project has no experiment \"{}\" of the type wear{} It has {}.", options.experiment,
                                       did_you_mean(options.experiment, names), listed));
}

RunJob job_of(const Design& design, const WearExperiment& wear, const WearVerbOptions& options)
{
    RunJob job{std::make_shared<const Design>(design), wear.name};
    job.base = folder_of(options.project);
    job.how = how_of(options);
    return job;
}

/// The garment with its replicates; the first is recorded.
int simulate_replicates(const Design& design, const WearExperiment& wear, const WearVerbOptions& options)
{
    Comparison all;
    all.experiment = wear.name;
    all.criteria = compared_by_wear();
    all.ranked_by = all.criteria.front();
    all.replicates = options.replicates;
    all.of_garments = true;
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    const std::vector<FinishedGarment> firsts =
        run_garments(all, {{wear.garment, job_of(design, wear, options)}}, options, options.at_once, cancel, [] {});
    if (!all.complete) throw Stop(exit_cancelled, "Cancelled.");
    const Candidate& found = all.candidates.front();
    if (!firsts.front().metrics) throw Stop(exit_failed, fmt::format("The first replicate failed: {}", found.failure));
    print_worn(*firsts.front().metrics, *firsts.front().record, options.json, found.intervals);
    if (!options.json) print_result("  {}\n", basis_text(all));
    for (const std::string& note : found.notes) print_note("{}\n", note);
    if (!options.output.empty() && !options.quiet) print_note("Recording of the first replicate: {}\n", options.output);
    return exit_ok;
}

} // namespace

const WearExperiment* chosen_wear(const Design& design, const ProjectOptions& options)
{
    if (design.experiments.empty() && !design.wears.empty()) return &required_wear(design, options);
    return options.experiment.empty() ? nullptr : find_wear(design, options.experiment);
}

fs::path folder_of(const std::string& project) { return fs::absolute(project).parent_path(); }

std::vector<FinishedGarment> run_garments(Comparison& comparison, std::vector<NamedJob> candidates, const WearVerbOptions& options,
                                          int at_once, const std::atomic<bool>& cancel, const std::function<void()>& ended)
{
    for (NamedJob& candidate : candidates) {
        candidate.job.how = how_of(options);
        if (options.quiet) continue;
        const Design cut = cut_from(*candidate.job.design, candidate.job.experiment, candidate.job.fabric);
        const GarmentParts parts =
            as_invalid([&] { return garment_parts(cut, *find_wear(cut, candidate.job.experiment), candidate.job.base); });
        print_misnamed(cut, parts, candidate.name);
    }
    const std::size_t runs = candidates.size() * static_cast<std::size_t>(comparison.replicates);
    announce_scenes(at_once, static_cast<int>(runs));
    double bytes = 0;
    for (const NamedJob& candidate : candidates) bytes = std::max(bytes, as_invalid([&] { return bytes_of(candidate.job); }));
    const auto places = open_places(options, at_once, static_cast<int>(runs), static_cast<std::size_t>(bytes));
    RunBar bar(options.quiet, runs);
    std::vector<FinishedGarment> firsts(candidates.size());
    ComparedWatch watch;
    watch.begins = [&](std::size_t i, RunJob& job) { job.beside = shown_in(bar, i, candidates[i % candidates.size()].name); };
    watch.came = [&](std::size_t i, const RunResult& result) {
        if (i < candidates.size()) firsts[i] = *result.garment;
    };
    watch.ended = [&](std::size_t i) {
        bar.end(i);
        ended();
    };
    RunQueue queue;
    run_comparison(comparison, candidates, queue, places, cancel, watch);
    return firsts;
}

int simulate_wear(const Design& design, const WearExperiment& wear, const WearVerbOptions& options)
{
    if (options.replicates > 1) return simulate_replicates(design, wear, options);
    const GarmentParts parts = parts_of(design, wear, options.project);
    if (!options.quiet)
        for (const std::string& issue : parts.pattern.issues) print_note("{}: {}\n", parts.garment->name, issue);
    if (!options.quiet) print_misnamed(design, parts, options.project);
    const std::unique_ptr<Backend> backend = open_backend(options);
    if (options.profile) backend->time_stages();
    std::shared_ptr<const WearRecord> record;
    std::optional<WearMetrics> so_far;
    FinishedGarment finished;
    RunControl control;
    const LastWords words = failure_words(options.json, exit_cancelled,
                                          options.output.empty() ? "Cancelled." : "Cancelled. The recording so far: " + options.output);
    {
        const InterruptCancels cancels(control.cancel, &words);
        RunBar bar(options.quiet, 1);
        RunJob job = job_of(design, wear, options);
        job.beside.memory_is_short = job.beside.device_failed = [&](const std::string& sentence) { bar.note(sentence); };
        job.beside.progress = [&](const RunProgress& progress) { bar.show(0, progress); };
        job.worn.planned = [&](const WearPlan& plan) { bar.expect(plan.time.seconds); };
        job.worn.started = [&](const std::shared_ptr<const WearRecord>& begun) { record = begun; };
        job.worn.frame = [&](const std::shared_ptr<const WearFrame>&, const WearMetrics& metrics) { so_far.emplace(metrics); };
        try {
            finished = *run_job(job, *backend, control).garment;
        } catch (const Cancelled&) {
            return print_cancelled(so_far, record.get(), options.json);
        }
    }
    print_worn(*finished.metrics, *finished.record, options.json);
    if (options.profile) print_profile(backend->stage_times(), finished.wall, options.json);
    if (!options.quiet) {
        print_note("{} on {}: {:.1f} s.\n", backend->name(), backend->device(), finished.wall);
        if (!options.output.empty()) print_note("Recording: {}\n", options.output);
    }
    return exit_ok;
}

int plan_garment(const WearVerbOptions& options)
{
    const Design design = load_project(options);
    require_valid(design, options);
    const WearExperiment& wear = required_wear(design, options);
    const GarmentParts parts = parts_of(design, wear, options.project);
    if (!options.quiet) print_misnamed(design, parts, options.project);
    RunOptions how = how_of(options);
    how.memory = {false, "Take larger cells or a lower fidelity."};
    const GarmentScene garment = garment_scene(parts, resolution_of(how));
    const WearLayout layout = wear_layout(parts, garment);
    const WearPlan plan =
        as_usage([&] { return plan_wear(garment, wear, how.fidelity, expected_backend(backend_for(options.backend, how.knobs))); });
    if (options.json) {
        Json json{{"garment", layout.garment},
                  {"experiment", wear.name},
                  {"cells", plan.cells},
                  {"bytes", plan.bytes},
                  {"seconds", plan.time.seconds}};
        json["resolution"] = layout.cells_in_words;
        for (std::size_t k = 0; k < layout.panels.size(); ++k)
            json["panels"].push_back({{"name", layout.panels[k].name},
                                      {"fabric", layout.panels[k].fabric},
                                      {"area_m2", area_of(parts.pattern.panels[k])},
                                      {"cells", plan.panel_cells[k]},
                                      {"crossings_per_cell", plan.crossings_per_cell[k]}});
        json["seam_joints"] = garment.scene.cloth.seams.joints.size();
        print_json(json);
        return exit_ok;
    }
    print_result("{} in \"{}\": {} cells; {}\n", layout.garment, wear.name, plan.cells, layout.cells_in_words);
    for (std::size_t k = 0; k < layout.panels.size(); ++k)
        print_result("  {:<24} {:<24} {:>9} m2 {:>9} cells\n", layout.panels[k].name, layout.panels[k].fabric,
                     rounded_text(area_of(parts.pattern.panels[k]), 4), plan.panel_cells[k]);
    print_result("Memory about {:.0f} MB; {} {} s, by the number of cells and how wet they get. {}\n", 1e-6 * plan.bytes,
                 plan.time.learned.empty() ? "on two cores some" : "here about", rounded_text(plan.time.seconds, 2),
                 plan.time.learned.empty() ? "Most runs at live and draft take from a third to three times that." : plan.time.learned);
    return exit_ok;
}

int measure_garment(const std::string& file, const CommonOptions& options, const std::string& report, double time)
{
    require_other_file(report, file);
    const WearRecording recording = as_invalid([&] { return WearRecording(file); });
    const WearMetrics metrics = metrics_of(recording);
    if (!report.empty()) {
        WearMapOptions how;
        how.crossings = as_computed;
        write_wear_report(recording, metrics, time >= 0 ? std::vector{time} : std::vector<double>{}, how, report, options.quiet);
    }
    print_worn(metrics, recording.record(), options.json);
    if (!options.quiet && !recording.finished()) print_note("{}: The run did not end.\n", file);
    return exit_ok;
}

int map_garment(const WearMapVerbOptions& options)
{
    if (options.output.empty() && options.report.empty())
        throw Stop(exit_usage, "Name a folder for the map with -o, or a page with --report.");
    if (options.report.empty() && !options.times.empty()) throw Stop(exit_usage, "--times are those of a report; the map's is --time.");
    require_other_file(options.report, options.recording);
    const WearRecording recording = as_invalid([&] { return WearRecording(options.recording); });
    const WearLayout& layout = recording.record().layout;
    require_within("--time", options.time, recording);
    for (const double time : options.times) require_within("--times", time, recording);
    const int nearest = options.time < 0 ? recording.frames() - 1 : frames_for_report(times_of(recording), {options.time}).front();
    const WearFrame frame = as_invalid([&] { return recording.frame(nearest); });
    WearMapOptions how;
    how.scale = options.scale == "capacity" ? WearScale::capacity : WearScale::same;
    how.most = options.most;
    if (!options.steps.empty()) how.steps = steps_of(options);
    require_shares(how);
    how.crossings = as_computed;
    if (options.cells != "auto") {
        const char* const end = options.cells.data() + options.cells.size();
        const auto [last, failure] = std::from_chars(options.cells.data(), end, how.crossings);
        if (failure != std::errc() || last != end || how.crossings < 1 || how.crossings > 10000)
            throw Stop(exit_usage, "--cells " + options.cells + ": This must be auto or a whole number from 1 to 10000.");
    }
    if (!options.report.empty()) write_wear_report(recording, metrics_of(recording), options.times, how, options.report, options.quiet);
    if (options.output.empty()) {
        if (options.json) print_json(Json{{"files", {options.report}}});
        return exit_ok;
    }
    const WearMap map = wear_map(layout, frame, how);
    make_folder(options.output);
    const std::vector<std::string> files = write_wear_map(layout, frame, map, options.output);
    if (options.json)
        print_json(Json{{"time_s", frame.time}, {"most", map.most()}, {"steps", map.steps}, {"cells", map.cells}, {"files", files}});
    else
        print_result("{} at {:.4g} s, {}: {} files in {}\n", layout.garment, frame.time, map.cells, files.size(), options.output);
    return exit_ok;
}

} // namespace hygroloom
