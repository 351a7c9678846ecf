// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// plan and simulate: what a run would do, and the run.
#include "app/cli_fidelity.h"
#include "app/cli_interrupt.h"
#include "app/cli_metrics.h"
#include "app/cli_replicates.h"
#include "app/cli_wear.h"

#include "core/analysis/metrics_json.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/plan/frame_times.h"
#include "core/plan/idle_keys.h"
#include "core/plan/plan_json.h"
#include "core/queue/compared_runs.h"
#include "core/run/plan_run.h"
#include "gpu/backends.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace hygroloom {
namespace {

struct SimulateOptions : FidelityOptions {
    std::vector<std::string> fabrics; ///< several, as given
    int at_once = 0;
    int replicates = 1;
    std::string output;
    bool profile = false;
    double cell_mm = 0, shown_mm = 0;
    std::vector<std::string> detail;
};

/// After a knob that the user set: " (set by the user; standard has 8)".
std::string as_set(const ModelPlan& plan, const KnobInfo& knob)
{
    const double usual = knobs_of(plan.fidelity).*knob.value;
    return plan.knobs.*knob.value == usual ? std::string()
                                           : fmt::format(" (set by the user; {} has {})", name_of(plan.fidelity), text_of(knob, usual));
}

/// The knobs without effect in this scene, by the reason.
std::map<std::string, std::string> idle_by_reason(const ModelPlan& plan)
{
    std::map<std::string, std::string> knobs;
    for (const KnobInfo& knob : knob_table()) {
        const auto idle = plan.idle_knobs.find(knob.name);
        if (idle == plan.idle_knobs.end()) continue;
        std::string& names = knobs[idle->second];
        names += (names.empty() ? "" : ", ") + std::string(knob.name) + as_set(plan, knob);
    }
    return knobs;
}

/// Keys of the project without effect in this experiment, by the reason.
std::map<std::string, std::string> keys_by_reason(const std::vector<IdleKey>& idle)
{
    std::map<std::string, std::string> keys;
    for (const IdleKey& key : idle) {
        std::string& names = keys[key.because];
        names += (names.empty() ? "" : ", ") + key.key;
    }
    return keys;
}

void print_plan(const ModelPlan& plan, const std::vector<IdleKey>& idle, const std::string& fabric, const std::string& experiment)
{
    print_result("fabric       {}\nexperiment   {}\n", fabric, experiment);
    print_result("expected     about {} s, {}, {}. {}\n", rounded_text(plan.expected_seconds, 2), bytes_text(plan.expected_bytes),
                 error_text(plan), plan.expectation_source);
    print_result("recording    about {} s more, with -o.\n", rounded_text(recording_seconds(plan), 2));
    print_result("fidelity     {}{}{}\n", name_of(plan.fidelity), plan.fidelity_reason.empty() ? "" : " (auto). ", plan.fidelity_reason);
    for (const PlannedPart& part : plan.parts)
        print_result("{:<12} {:<4} {}{}\n", part.name, part.on ? "on" : "off", part.forced ? "(forced) " : "", part.reason);
    print_result("region       {} ends, {} picks, {} segments. {}\n", plan.region.ends, plan.region.picks, plan.segments,
                 plan.region_reason);
    print_result("resolution   a frame every {:.3g} s. {}\n", plan.frame_interval, plan.resolution_reason);
    const char* head = "knobs";
    for (const KnobInfo& knob : knob_table()) {
        if (plan.idle_knobs.contains(knob.name)) continue;
        print_result("{:<12} {:<23} {:<8} {}{}\n", std::exchange(head, ""), knob.name, text_of(knob, plan.knobs.*knob.value), knob.meaning,
                     as_set(plan, knob));
    }
    head = "no effect";
    for (const auto& [why, knobs] : idle_by_reason(plan)) print_result("{:<12} {}: {}\n", std::exchange(head, ""), why, knobs);
    head = "idle keys";
    for (const auto& [why, keys] : keys_by_reason(idle)) print_result("{:<12} {}: {}\n", std::exchange(head, ""), why, keys);
}

int plan(const SimulateOptions& options)
{
    check_fidelity(options);
    const auto forced = as_usage([&] { return parse_forced_parts(options.physics); });
    const KnobSettings knobs = knob_settings(options);
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    const Experiment& chosen = chosen_experiment(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    const std::vector<Textile> textile = textiles_of_runs(design, fitted, {fabric.name}, chosen);
    const FidelityChoice choice = chosen_fidelity(options, design, textile, forced, knobs);
    ModelPlan plan = planned(options, design, textile.front(), choice.fidelity, forced, knobs);
    plan.fidelity_reason = choice.reason;
    const std::string experiment = chosen.name;
    const std::vector<IdleKey> idle = idle_keys(fabric, chosen, plan);
    if (options.json) {
        nlohmann::ordered_json json{{"fabric", fabric.name}, {"experiment", experiment}};
        json.update(plan_value(plan));
        json["idle_keys"] = nlohmann::ordered_json::array();
        for (const IdleKey& key : idle) json["idle_keys"].push_back({{"key", key.key}, {"because", key.because}});
        print_json(json);
    } else {
        print_plan(plan, idle, fabric.name, experiment);
    }
    return exit_ok;
}

/// The plan's notes stand in the summary, and on stderr when stdout is for JSON alone.
void print_run(const FinishedRun& finished, const CommonOptions& options)
{
    print_metrics(finished.run, finished.metrics, options.json);
    const ModelPlan& plan = finished.run.plan;
    if (!options.json) print_result("{}", fidelity_text({plan.fidelity, plan.fidelity_reason}));
    if (options.json && !options.quiet)
        for (const std::string& note : notes_of(plan)) print_note("{}: {}\n", finished.run.fabric, note);
}

/// What a run has given so far, for the case that it is cancelled.
struct SoFar {
    RunRecord run;
    std::shared_ptr<const MetricsCollector> metrics; ///< nullptr: no frame yet
    int frames = 0;
};

/// The last words, and the metrics up to there, unless that takes so long that the words are the last.
int print_cancelled(const SoFar& so_far, bool json)
{
    const Metrics metrics = so_far.metrics ? so_far.metrics->metrics() : Metrics{};
    const LastWords* words = last_words.exchange(nullptr);
    write_note(words->note);
    if (so_far.frames == 0) {
        write_result(words->result);
    } else if (json) {
        auto object = nlohmann::ordered_json::parse(words->result);
        object["so_far"] = metrics_value(so_far.run, metrics);
        print_json(object);
    } else {
        print_metrics(so_far.run, metrics, false);
    }
    return exit_cancelled;
}

/// Whether a recording is there that a run to this path keeps until it has a frame after its start.
bool has_older_recording(const std::string& path)
{
    std::error_code none;
    const auto size = std::filesystem::file_size(path, none);
    return !path.empty() && !none && size > 0;
}

int simulate_one(const SimulateOptions& options, const Design& design, const FittedFabrics& fitted, RunOptions how)
{
    const Experiment& experiment = chosen_experiment(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    const std::vector<Textile> textile = textiles_of_runs(design, fitted, {fabric.name}, experiment);
    const FidelityChoice choice = chosen_fidelity(options, design, textile, how.forced, how.knobs);
    how.fidelity = choice.fidelity;
    how.fidelity_reason = choice.reason;
    how.recording = options.output;
    how.textile = std::make_shared<const Textile>(textile.front());

    const std::unique_ptr<Backend> backend = open_backend(options);
    if (options.profile) backend->time_stages();
    RunControl control;
    const int frames_to_keep = has_older_recording(options.output) ? 2 : 1;
    const LastWords nothing = failure_words(options.json, exit_cancelled,
                                            frames_to_keep == 1 ? "Cancelled." : "Cancelled. The older recording stays: " + options.output);
    const LastWords with_recording = failure_words(options.json, exit_cancelled, "Cancelled. The recording so far: " + options.output);
    const InterruptCancels cancels(control.cancel, &nothing);
    FinishedRun finished;
    SoFar so_far;
    try {
        RunBar bar(options.quiet, 1);
        RunJob job{std::make_shared<const Design>(design), experiment.name, fabric.name, {}, how};
        job.beside = shown_in(bar, 0, fabric.name);
        job.measured = [&](const std::shared_ptr<const Frame>&, const std::shared_ptr<const MetricsCollector>& metrics) {
            so_far.metrics = metrics;
            if (++so_far.frames >= frames_to_keep && !options.output.empty()) last_words = &with_recording;
        };
        job.beside.started = [&](const RunRecord& record) {
            so_far.run = record;
            bar.expect(seconds_to_wait(record.plan, !how.recording.empty()));
        };
        finished = std::move(*run_job(job, *backend, control).sample);
    } catch (const Cancelled&) {
        return print_cancelled(so_far, options.json);
    }
    print_run(finished, options);
    if (options.profile) print_profile(backend->stage_times(), finished.run.wall, options.json);
    if (!options.output.empty() && !options.quiet) print_note("Recording: {}\n", options.output);
    return exit_ok;
}

/// One fabric with its replicates, side by side; the first is recorded.
int simulate_replicates(const SimulateOptions& options, const Design& design, const FittedFabrics& fitted, RunOptions how)
{
    const std::vector<std::string> fabric{chosen_fabric(design, options).name};
    const Experiment& experiment = chosen_experiment(design, options);
    const std::vector<Textile> textiles = textiles_of_runs(design, fitted, fabric, experiment);
    const FidelityChoice choice = chosen_fidelity(options, design, textiles, how.forced, how.knobs);
    how.fidelity = choice.fidelity;
    how.fidelity_reason = choice.reason;
    how.recording = options.output;
    announce_scenes(options.at_once, options.replicates);
    const auto places = open_places(options, options.at_once, options.replicates, bytes_of_largest(design, experiment, textiles, how));
    Comparison all;
    all.experiment = experiment.name;
    all.criteria = compared_by(experiment.type);
    all.ranked_by = all.criteria.front();
    all.replicates = options.replicates;
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    {
        RunBar bar(options.quiet, static_cast<std::size_t>(options.replicates));
        RunQueue queue;
        ComparedWatch watch;
        watch.begins = [&](std::size_t i, RunJob& job) { job.beside = shown_in(bar, i, fabric[0]); };
        watch.ended = [&](std::size_t i) { bar.end(i); };
        run_comparison(all, jobs_of(design, fabric, experiment.name, textiles, how), queue, places, cancel, watch);
    }
    if (!all.complete) throw Stop(exit_cancelled, "Cancelled.");
    const Candidate& found = all.candidates.front();
    if (!found.run) throw Stop(exit_failed, fmt::format("The first replicate failed: {}", found.failure));
    print_metrics(*found.run, *found.metrics, options.json, found.intervals);
    for (const std::string& note : found.notes) print_note("{}\n", note);
    if (!options.output.empty() && !options.quiet) print_note("Recording of the first replicate: {}\n", options.output);
    return exit_ok;
}

/// As simulate_one() with each, side by side; an error concerns its fabric alone.
int simulate_several(const SimulateOptions& options, const Design& design, const FittedFabrics& fitted, RunOptions how)
{
    const std::vector<std::string> fabrics = chosen_fabrics(design, options.fabrics), stems = file_stems(fabrics);
    announce_scenes(options.at_once, static_cast<int>(fabrics.size()));
    const Experiment& experiment = chosen_experiment(design, options);
    make_folder(options.output);
    std::vector<FidelityChoice> choices;
    const std::vector<Textile> textiles = textiles_of_runs(design, fitted, fabrics, experiment);
    choices.reserve(textiles.size());
    for (const Textile& textile : textiles) choices.push_back(chosen_fidelity(options, design, {textile}, how.forced, how.knobs));
    how.fidelity = Fidelity::draft;
    for (const FidelityChoice& choice : choices) how.fidelity = std::max(how.fidelity, choice.fidelity); // needs the most memory
    const std::vector<NamedJob> jobs = jobs_of(design, fabrics, experiment.name, textiles, how);
    const auto places =
        open_places(options, options.at_once, static_cast<int>(fabrics.size()), bytes_of_largest(design, experiment, textiles, how));

    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    std::vector<std::optional<FinishedRun>> runs(fabrics.size());
    int failed = 0;
    {
        RunBar bar(options.quiet, fabrics.size());
        RunQueue queue;
        RunBatch batch;
        batch.count = fabrics.size();
        batch.places = places;
        batch.job = [&](std::size_t i) {
            RunJob job = jobs[i].job;
            job.how.fidelity = choices[i].fidelity;
            job.how.fidelity_reason = choices[i].reason;
            if (!options.output.empty()) job.how.recording = (std::filesystem::path(options.output) / (stems[i] + ".hygrorec")).string();
            job.beside = shown_in(bar, i, fabrics[i]);
            return job;
        };
        batch.ended = [&](std::size_t i, RunResult& result) {
            runs[i] = std::move(result.sample);
            if (const std::string failure = result.failure(); !failure.empty()) {
                ++failed;
                bar.say(fabrics[i] + ": " + failure);
            }
            bar.end(i);
        };
        queue.run(std::move(batch), cancel);
    }
    if (options.json) print_result("[\n");
    const char* between = "";
    std::size_t ended = 0;
    for (const auto& run : runs) {
        if (!run) continue;
        if (options.json) print_result("{}", std::exchange(between, ",\n"));
        print_run(*run, options);
        ++ended;
    }
    if (options.json) print_result("]\n");
    if (cancel)
        throw Stop(exit_cancelled, fmt::format("Cancelled after {} of {} fabrics.{}", ended, fabrics.size(),
                                               options.output.empty() ? "" : " The recordings so far are in " + options.output + "."));
    if (!options.output.empty() && !options.quiet) print_note("Recordings: {}\n", options.output);
    return failed > 0 ? exit_failed : exit_ok;
}

/// A garment's run has no fabrics to choose.
int wear_verb(const Design& design, const WearExperiment& wear, const SimulateOptions& options)
{
    const std::pair<bool, const char*> refused[] = {
        {!options.fabric.empty(), "--fabric"},
        {!options.fabrics.empty(), "--fabrics"},
        {!options.physics.empty(), "--physics"},
        {options.replicates == 1 && options.seed != RunVerbOptions{}.seed, "--seed without --replicates"},
    };
    for (const auto& [given, name] : refused)
        if (given)
            throw Stop(exit_usage, fmt::format("A worn garment does not take {}: its panels name their fabrics, and nothing of one run is "
                                               "left to chance. It takes --fidelity, --cell-mm, --shown-mm, --detail, --set, --backend, "
                                               "--threads, --replicates, --at-once, --profile and -o.",
                                               name));
    WearVerbOptions how;
    static_cast<RunVerbOptions&>(how) = options;
    how.fidelity = options.fidelity;
    how.cell_mm = options.cell_mm;
    how.shown_mm = options.shown_mm;
    how.detail = options.detail;
    how.profile = options.profile;
    how.replicates = options.replicates;
    how.at_once = options.at_once;
    how.output = options.output;
    return simulate_wear(design, wear, how);
}

int simulate(const SimulateOptions& options)
{
    check_fidelity(options);
    const bool several = !options.fabrics.empty();
    if (several && !options.fabric.empty()) throw Stop(exit_usage, "Give either --fabric or --fabrics.");
    if (several && options.profile) throw Stop(exit_usage, "--profile works with one fabric.");
    const bool replicates = options.replicates > 1;
    if (!several && !replicates && options.at_once > 0) throw Stop(exit_usage, "--at-once works with --fabrics or --replicates.");
    if (several && replicates) throw Stop(exit_usage, "--replicates works with one fabric; compare takes several.");
    if (replicates && options.profile) throw Stop(exit_usage, "--profile works with one run.");
    RunOptions how = run_options(options);
    how.may_go_on_on_cpu = true;
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    if (const WearExperiment* wear = chosen_wear(design, options)) return wear_verb(design, *wear, options);
    const Experiment& experiment = chosen_experiment(design, options);
    if (options.cell_mm > 0 || !options.detail.empty())
        throw Stop(exit_usage, fmt::format("--cell-mm and --detail work with experiments on a garment (type wear); \"{}\" is one on a "
                                           "sample of fabric.",
                                           experiment.name));
    how.shown_side = metre_from_mm(options.shown_mm);
    if (replicates) return simulate_replicates(options, design, fitted, how);
    return several ? simulate_several(options, design, fitted, how) : simulate_one(options, design, fitted, how);
}

void add_run_options(CLI::App& verb, SimulateOptions& options)
{
    add_project_options(verb, options, true);
    options.takes_knobs = true;
    add_fidelity_options(verb, options, "");
    add_physics_option(verb, options);
}

} // namespace

void add_plan(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<SimulateOptions>();
    CLI::App& plan_verb = *app.add_subcommand("plan", "Show what a run would compute and why, its expected time, memory and error");
    plan_verb.footer("Example: hygroloom-cli plan cloth.hygro --fabric \"Textile F\" --experiment \"one drop\" --fidelity draft\n\n" +
                     knob_help());
    add_run_options(plan_verb, *options);
    plan_verb.add_option("--backend", options->backend, "Backend to estimate for: auto, cpu or cuda; it need not be installed")
        ->check(CLI::IsMember({"auto", "cpu", "cuda"}));
    plan_verb.callback([&verb, options] { verb = [options] { return plan(*options); }; });
}

void add_simulate(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<SimulateOptions>();
    CLI::App& simulate_verb = *app.add_subcommand("simulate", "Run an experiment on one or several fabrics and print the metrics");
    simulate_verb.footer(
        "Example: hygroloom-cli simulate cloth.hygro --fabric \"Textile F\" --experiment \"one drop\" --fidelity draft --set "
        "fabrics[1].contact_angle_deg=60 -o cloth.hygrorec\n"
        "Ctrl-C stops the run and prints the metrics so far; the recording so far stays readable.\n"
        "What a fidelity is made of, and how to change a part of it: hygroloom-cli plan --help");
    add_run_options(simulate_verb, *options);
    add_machine_options(simulate_verb, *options);
    simulate_verb.add_option("--cell-mm", options->cell_mm, "Garments: cell size, mm. Default: by fidelity")
        ->check(CLI::Range(0.05, 100.0));
    simulate_verb
        .add_option("--shown-mm", options->shown_mm,
                    "Cell size of maps and recordings, mm. Default: every crossing, or every computed cell of a garment, coarsened to "
                    "about 500 000 cells on large cloth")
        ->check(CLI::Range(0.05, 100.0));
    simulate_verb.add_option("--detail", options->detail, "Garments: panels, separated by commas, whose computed cells are all recorded")
        ->delimiter(',');
    simulate_verb.add_flag("--profile", options->profile, "Also print the time of each stage");
    simulate_verb
        .add_option("--fabrics", options->fabrics, "Several fabrics, separated by commas, that run side by side; --json then prints a list")
        ->allow_extra_args(false);
    add_replicates_option(simulate_verb, options->replicates, "");
    add_at_once_option(simulate_verb, options->at_once);
    simulate_verb.add_option("-o,--output", options->output, "Recording to write (.hygrorec); with --fabrics a folder")->type_name("FILE");
    simulate_verb.callback([&verb, options] {
        options->recorded = !options->output.empty();
        verb = [options] { return simulate(*options); };
    });
}

} // namespace hygroloom
