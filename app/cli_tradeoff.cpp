// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// tradeoff: one scene at each fidelity, timed and compared with the reference; and its measurements as the table that plans read.
#include "app/cli_interrupt.h"
#include "app/cli_run.h"

#include "core/analysis/tradeoff.h"
#include "core/base/text.h"
#include "core/project/atomic_file.h"
#include "core/project/project_file.h"
#include "core/run/apart.h"
#include "core/run/plan_run.h"
#include "gpu/backends.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace hygroloom {
namespace {

struct TradeoffOptions : RunVerbOptions {
    std::string fidelities = "live,draft,standard,reference";
    int repeats = 3;
    bool convergence = false;
    std::string output;
    std::vector<std::string> tables; ///< measured before, to be printed as one
};

/// What all runs of one scene share.
struct TradeoffScene {
    Design design;
    std::string fabric, experiment, backend;
    RunOptions options; ///< without fidelity and knobs
};

Fidelity named_fidelity(const TradeoffOptions& options, const std::string& word)
try {
    return fidelity_from_name(word);
} catch (const Error& error) {
    throw Stop(exit_usage, "--fidelities " + options.fidelities + ": " + error.what());
}

std::vector<TradeoffRun> chosen_runs(const TradeoffOptions& options, const TradeoffScene& scene, const KnobSettings& settings)
{
    std::vector<TradeoffRun> runs;
    const auto add = [&](const std::string& name, Fidelity fidelity, const KnobSettings& knobs, const std::string& coarser) {
        as_usage([&] { return backend_for(options.backend, knobs); });
        const Experiment& experiment = *find_experiment(scene.design, scene.experiment);
        runs.push_back({.name = name,
                        .plan = plan_run(scene.design, *scene.options.textile, experiment, fidelity, scene.options.forced, knobs),
                        .settings = knobs,
                        .coarser = coarser});
    };
    for (const std::string& word : words_of(options.fidelities)) add(word, named_fidelity(options, word), settings, "");
    if (!options.convergence) return runs;
    add("reference x 2", Fidelity::reference, refined(settings, 2), name_of(Fidelity::reference));
    add("reference x 4", Fidelity::reference, refined(settings, 4), "reference x 2");
    return runs;
}

std::string run_here(const TradeoffScene& scene, const TradeoffRun& variant, const std::function<void(double)>& progress)
{
    RunControl control;
    const InterruptCancels cancels(control.cancel);
    RunOptions options = scene.options;
    options.fidelity = variant.plan.fidelity;
    options.knobs = variant.settings;
    options.shown_side = 1e-9; // m: each segment, so that all runs have the same ones
    const std::unique_ptr<Backend> backend = make_backend(backend_for(scene.backend, variant.settings));
    OutcomeCollector collector;
    RunJob job{std::make_shared<const Design>(scene.design), scene.experiment, scene.fabric, {}, options};
    job.times_count = false; // its frames are finer than those of others
    job.beside.started = [&](const RunRecord& record) { collector.start(record); };
    job.beside.frame = [&](const std::shared_ptr<const Frame>& frame) { collector.add(*frame); };
    job.beside.progress = [&](const RunProgress& p) { progress(p.duration > 0 ? p.simulated / p.duration : 1.0); };
    const FinishedRun finished = std::move(*run_job(job, *backend, control).sample);
    return outcome_json(collector.outcome(finished.run, finished.metrics));
}

/// In a process of its own, with its progress on the terminal. Precondition: this process has started no thread yet.
TradeoffOutcome run_apart_shown(const TradeoffScene& scene, const TradeoffRun& run, const std::string& about, bool quiet,
                                const std::atomic<bool>& cancel)
try {
    const bool bar = !quiet && isatty(STDERR_FILENO);
    const auto show = [&](double share) {
        if (bar) draw_line(fmt::format("{}: {:.0f} %", about, 100 * share));
    };
    show(0);
    const ApartResult result = run_apart(
        run.name, [&](const auto& progress) { return run_here(scene, run, progress); }, cancel, show);
    TradeoffOutcome outcome = outcome_from_json(result.text);
    outcome.peak_bytes = result.peak_bytes;
    if (bar) draw_line("");
    if (!quiet) print_note("{}: {} s, {}\n", about, rounded_text(outcome.wall, 3), bytes_text(outcome.peak_bytes));
    return outcome;
} catch (const DeviceError& error) {
    throw Stop(exit_no_device, std::string(error.what()) + " Use --backend cpu.");
}

/// All runs once, then all timed ones once more, and so on, so that a noisy machine favours none. Throws Cancelled.
void measure(const TradeoffScene& scene, Tradeoff& result, const TradeoffOptions& options, const std::atomic<bool>& cancel)
{
    for (int repeat = 0; repeat < result.repeats; ++repeat)
        for (std::size_t i = 0; i < result.runs.size(); ++i) {
            TradeoffRun& run = result.runs[i];
            const bool timed = run.coarser.empty();
            if (repeat > 0 && !timed) continue;
            const std::string about =
                fmt::format("repeat {} of {}, {} ({} of {})", repeat + 1, result.repeats, run.name, i + 1, result.runs.size());
            run.outcome = run_apart_shown(scene, run, about, options.quiet, cancel);
            if (timed) run.walls.push_back(run.outcome->wall);
            if (timed) run.peaks.push_back(run.outcome->peak_bytes);
            compare_runs(result.runs);
            if (!options.output.empty()) write_file(options.output, tradeoff_json(result));
        }
    result.complete = true;
    if (!options.output.empty()) write_file(options.output, tradeoff_json(result));
}

std::string percent(const std::optional<double>& share) { return share ? fmt::format("{:.3g} %", 100 * *share) : std::string("-"); }

void print_table(const Tradeoff& t)
{
    print_result("{}, {} (median of {})\n  {:<14} {:>10} {:>9} {:>9}\n", t.fabric, t.experiment, t.repeats, "", "time", "memory", "error");
    for (const TradeoffRun& run : t.runs) {
        const std::optional<double> error = run.errors ? std::optional(run.errors->largest) : std::nullopt;
        if (run.coarser.empty())
            print_result("  {:<14} {:>10} {:>9} {:>9}\n", run.name, run.walls.empty() ? "-" : rounded_text(median(run.walls), 3) + " s",
                         run.peaks.empty() ? "-" : bytes_text(median(run.peaks)), percent(error));
        else
            print_result("  from {} to {}: error {}\n", run.coarser, run.name, percent(error));
    }
    print_result("Time and memory (largest resident set): one process per run, one run at a time. Error against the reference: the largest "
                 "of metrics,\nwater contents and 1 - overlap of what is wet.\n");
}

int print_measured_table(const TradeoffOptions& options)
{
    constexpr std::size_t most_bytes = 10'000'000;
    std::vector<MeasuredScene> scenes;
    for (const std::string& file : options.tables) {
        try {
            scenes.push_back(measured_scene(read_file(file, most_bytes), file));
        } catch (const Error& error) {
            throw Stop(exit_invalid, error.what());
        }
    }
    print_result("{}", measured_csv(scenes));
    return exit_ok;
}

int tradeoff(const TradeoffOptions& options)
{
    if (!options.tables.empty()) return print_measured_table(options);
    if (options.project.empty()) throw Stop(exit_usage, "tradeoff needs a PROJECT to run, or --csv with files that it wrote.");
    TradeoffScene scene;
    scene.options = run_options(options);
    const KnobSettings settings = std::exchange(scene.options.knobs, {});
    scene.design = load_project(options);
    const FittedFabrics fitted = require_valid(scene.design, options);
    scene.fabric = chosen_fabric(scene.design, options).name;
    const Experiment& experiment = chosen_experiment(scene.design, options);
    scene.experiment = experiment.name;
    scene.backend = options.backend;
    scene.options.textile = std::make_shared<const Textile>(textiles_of_runs(scene.design, fitted, {scene.fabric}, experiment).front());

    Tradeoff result = tradeoff_here(scene.fabric, scene.experiment);
    result.threads = options.threads;
    result.repeats = options.repeats;
    result.runs = chosen_runs(options, scene, settings);
    if (!options.output.empty()) write_file(options.output, tradeoff_json(result));
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    bool cancelled = false;
    try {
        measure(scene, result, options, cancel);
    } catch (const Cancelled&) {
        cancelled = true;
        if (!options.quiet) print_note("\n");
    }
    if (options.json)
        print_result("{}", tradeoff_json(result));
    else
        print_table(result);
    const std::string where = options.output.empty() ? "" : fmt::format(" Measurements: {}", options.output);
    if (cancelled) print_note("Cancelled.{}\n", where);
    if (!cancelled && !options.quiet && !where.empty()) print_note("{}\n", where.substr(1));
    return cancelled ? exit_cancelled : exit_ok;
}

} // namespace

void add_tradeoff(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<TradeoffOptions>();
    CLI::App& verb = *app.add_subcommand("tradeoff", "Measure speed against accuracy of one scene: a run at every fidelity");
    verb.footer([] {
        return "Example: hygroloom-cli tradeoff cloth.hygro --fabric \"Textile F\" --experiment \"one drop\" --repeats 3 -o cloth.json\n"
               "The reference runs as well, which may take long; see plan. The file is written after every run; Ctrl-C keeps the\n"
               "measurements so far. Run nothing else on the machine meanwhile.\n\n" +
               knob_help();
    });
    add_project_options(verb, *options, true);
    verb.get_option("project")->required(false);
    options->takes_knobs = true;
    verb.add_option("--fidelities", options->fidelities, "Fidelities to run, separated by commas; errors need the reference");
    add_physics_option(verb, *options);
    add_machine_options(verb, *options);
    verb.add_option("--repeats", options->repeats, "Runs at every fidelity; the median time counts")->check(CLI::Range(1, 99));
    verb.add_flag("--convergence", options->convergence,
                  "Also run the reference twice and four times as fine, to see whether it has converged");
    verb.add_option("-o,--output", options->output, "JSON file for the measurements")->type_name("FILE");
    verb.add_option("--csv", options->tables, "Run nothing: print files of -o as one table, as the program ships it")->type_name("FILE");
    verb.callback([&chosen, options] { chosen = [options] { return tradeoff(*options); }; });
}

} // namespace hygroloom
