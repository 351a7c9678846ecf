// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// tradeoff: the ladder of fidelities and one-knob variations of one scene, timed and compared with the reference.
#include "app/cli_interrupt.h"
#include "app/cli_run.h"
#include "app/run_apart.h"

#include "core/base/text.h"
#include "core/plan/expectation.h"
#include "core/project/atomic_file.h"
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
    std::string knobs;
    int repeats = 3;
    bool convergence = false;
    std::string output;
};

/// Keeps the fidelities of the list.
void keep_named(std::vector<TradeoffVariant>& variants, const std::string& list)
{
    std::vector<std::string> named;
    try {
        for (const std::string& word : words_of(list)) named.emplace_back(name_of(fidelity_from_name(word)));
    } catch (const Error& error) {
        throw Stop(exit_usage, "--fidelities " + list + ": " + error.what());
    }
    std::erase_if(variants, [&](const TradeoffVariant& variant) {
        return variant.name == name_of(variant.fidelity) && std::find(named.begin(), named.end(), variant.name) == named.end();
    });
}

std::vector<TradeoffVariant> chosen_variants(const TradeoffOptions& options, const KnobSettings& always)
{
    std::vector<TradeoffVariant> variants;
    try {
        variants = options.knobs == "none" ? tradeoff_ladder() : tradeoff_variants(words_of(options.knobs));
    } catch (const Error& error) {
        throw Stop(exit_usage, "--knobs " + options.knobs + ": " + error.what());
    }
    keep_named(variants, options.fidelities);
    if (options.knobs.empty() && options.backend == "cuda")
        std::erase_if(variants, [](const TradeoffVariant& variant) { return variant.settings.contains("double_precision"); });
    for (TradeoffVariant& variant : variants) {
        variant.settings.insert(always.begin(), always.end());
        as_usage([&] { return backend_for(options.backend, variant.settings); });
    }
    if (options.convergence)
        for (const TradeoffVariant& variant : convergence_variants(always)) variants.push_back(variant);
    return variants;
}

void write_results(const Tradeoff& result, const std::filesystem::path& folder)
{
    if (folder.empty()) return;
    write_file(folder / "tradeoff.json", tradeoff_json(result));
    write_file(folder / "tradeoff.csv", tradeoff_csv(result));
    write_file(folder / "tradeoff.svg", tradeoff_svg(result));
}

/// One run, in a process of its own, with its progress on the terminal.
TradeoffOutcome run_shown(const ApartRun& scene, const Tradeoff& result, std::size_t i, int repeat, bool quiet,
                          const std::atomic<bool>& cancel)
{
    const bool bar = !quiet && isatty(STDERR_FILENO);
    const TradeoffVariant& variant = result.points[i].variant;
    const std::string about =
        fmt::format("repeat {} of {}, {} ({} of {})", repeat + 1, result.repeats, variant.name, i + 1, result.points.size());
    const auto show = [&](double share) {
        if (bar) draw_line(fmt::format("{}: {:.0f} %", about, 100 * share));
    };
    show(0);
    TradeoffOutcome outcome = run_apart(scene, variant, cancel, show);
    if (bar) draw_line("");
    if (!quiet) print_note("{}: {} s, {}\n", about, rounded_text(outcome.wall, 3), bytes_text(outcome.peak_bytes));
    return outcome;
}

std::string percent(const std::optional<double>& share) { return share ? fmt::format("{:.3g} %", 100 * *share) : std::string("-"); }

void print_table(const Tradeoff& t)
{
    print_result("{}, {} ({}, {}, median of {})\n", t.fabric, t.experiment, t.backend, t.device, t.repeats);
    print_result("  {:<28} {:>10} {:>9} {:>9} {:>9} {:>9}\n", "", "time", "memory", "error", "map", "overlap");
    for (const TradeoffPoint& p : t.points) {
        print_result("{} {:<28} {:>10} {:>9} {:>9} {:>9} {:>9}\n", p.pareto ? '*' : ' ', p.variant.name,
                     p.walls.empty() ? "-" : rounded_text(p.wall(), 3) + " s", p.peaks.empty() ? "-" : bytes_text(p.peak()),
                     p.errors ? percent(p.errors->largest) : "-", p.errors ? percent(p.errors->map) : "-",
                     p.errors ? percent(p.errors->overlap) : "-");
        for (const MetricError& m : p.closed_forms)
            print_result("    {}: {:.5g}, closed form {:.5g} (error {:.2g} %)\n", m.name, *m.value, *m.reference, 100 * m.error);
        for (const std::string& name : p.stands_for) print_result("    same run as {}\n", name);
    }
    for (const ConvergenceStep& step : t.convergence)
        print_result("  from {} to {}: error {}, map {}\n", step.coarse, step.fine, percent(step.errors.largest), percent(step.errors.map));
    print_result(
        "* no other variant is both faster and more accurate. Time and memory (largest resident set): one process per run, one run\n"
        "at a time. Error against the reference: the largest of all metrics, water contents and 1 - overlap. Map: relative L2.\n");
    for (const TradeoffPoint& p : t.points) {
        if (p.variant.name != "standard" || p.stages.empty()) continue;
        std::vector<std::pair<double, std::string>> stages;
        for (const auto& [name, share] : p.stages) stages.emplace_back(share, name);
        std::sort(stages.rbegin(), stages.rend());
        stages.resize(std::min<std::size_t>(stages.size(), 5));
        print_result("Slowest stages of standard:");
        for (const auto& [share, name] : stages) print_result(" {} {:.0f} %", name, share);
        print_result("\n");
    }
}

int tradeoff(const TradeoffOptions& options)
{
    ApartRun scene;
    scene.options = run_options(options);
    const std::vector<TradeoffVariant> variants = chosen_variants(options, std::exchange(scene.options.knobs, {}));
    scene.design = load_project(options);
    const FittedFabrics fitted = require_valid(scene.design, options);
    const Fabric& fabric = chosen_fabric(scene.design, options);
    const Experiment& experiment = chosen_experiment(scene.design, options);
    scene.fabric = fabric.name;
    scene.experiment = experiment.name;
    scene.backend = options.backend;
    make_folder(options.output);

    Tradeoff result = tradeoff_here(fabric, experiment);
    result.threads = options.threads;
    result.repeats = options.repeats;
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    TradeoffSweep sweep(result);
    scene.options.textile = std::make_shared<const Textile>(textiles_of_runs(scene.design, fitted, {fabric.name}, experiment).front());
    for (const TradeoffVariant& variant : variants)
        sweep.add(variant,
                  plan_run(scene.design, *scene.options.textile, experiment, variant.fidelity, scene.options.forced, variant.settings));
    bool cancelled = false;
    try {
        sweep.run([&](std::size_t i, int repeat) { return run_shown(scene, result, i, repeat, options.quiet, cancel); },
                  [&] { write_results(result, options.output); });
    } catch (const Cancelled&) {
        cancelled = true;
        if (!options.quiet) print_note("\n");
    }
    if (options.json)
        print_result("{}", tradeoff_json(result));
    else
        print_table(result);
    const std::string where = options.output.empty() ? "" : fmt::format(" Measurements: {}", options.output);
    if (cancelled) {
        print_note("Cancelled.{}\n", where);
        return exit_cancelled;
    }
    if (!options.quiet && !where.empty()) print_note("{}\n", where.substr(1));
    return exit_ok;
}

/// For --help: times of the shipped scenes at each fidelity.
std::string measured_help()
{
    std::string text =
        "Measured on the shipped scenes: wall time, memory, numerical error (against the reference: the largest of all metrics but the "
        "time from which a stain rests, of water contents and of 1 - overlap):\n";
    for (const char* backend : {"cpu", "cuda"})
        for (const MeasuredScene& scene : shipped_measurements(backend)) {
            text += fmt::format("  {} on {} (closure {}; {}, {})\n", scene.experiment, scene.fabric, scene.runs.front().plan.counts.closure,
                                scene.device, scene.date);
            for (const MeasuredRun& run : scene.runs)
                if (run.settings.empty())
                    text += fmt::format("    {:<10} {:>10} {:>8} {:>8}\n", name_of(run.plan.fidelity),
                                        run.seconds > 0 ? rounded_text(run.seconds, 3) + " s" : "not timed",
                                        run.bytes > 0 ? bytes_text(run.bytes) : "–", percent(run.error));
        }
    return text;
}

} // namespace

void add_tradeoff(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<TradeoffOptions>();
    CLI::App& verb = *app.add_subcommand("tradeoff", "Measure speed against accuracy of one scene: every fidelity, and one knob at a time");
    verb.footer([] {
        return "Example: hygroloom-cli tradeoff cloth.hygro --fabric \"Textile F\" --experiment \"one drop\" --knobs "
               "particles_per_droplet,fibre_shells --repeats 3 "
               "-o cloth-tradeoff\n"
               "The reference runs as well, which may take long; see plan. The folder receives tradeoff.json, .csv and .svg after every "
               "run;\n"
               "Ctrl-C keeps the measurements so far. Run nothing else on the machine meanwhile.\n\n" +
               measured_help() + "\n" + knob_help();
    });
    add_project_options(verb, *options, true);
    options->takes_knobs = true;
    verb.add_option("--fidelities", options->fidelities, "Fidelities to run, separated by commas; errors need the reference");
    verb.add_option("--knobs", options->knobs, "Knobs to vary, separated by commas; all when left out; none: fidelities only");
    add_physics_option(verb, *options);
    add_machine_options(verb, *options);
    verb.add_option("--repeats", options->repeats, "Runs of every variant; the median time counts")->check(CLI::Range(1, 99));
    verb.add_flag("--convergence", options->convergence,
                  "Also run the reference twice and four times as fine, to see whether it has converged");
    verb.add_option("-o,--output", options->output, "Folder for the results")->type_name("FOLDER");
    verb.callback([&chosen, options] { chosen = [options] { return tradeoff(*options); }; });
}

} // namespace hygroloom
