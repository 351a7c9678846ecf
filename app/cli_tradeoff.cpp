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
    std::string fidelities = "draft,standard,reference";
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

/// One measurement of a scene, run by run.
class Measurement {
public:
    Measurement(const ApartRun& scene, Tradeoff& result, const TradeoffOptions& options)
        : scene_(scene), result_(result), options_(options), bar_(!options.quiet && isatty(STDERR_FILENO))
    {
    }

    /// Leaves out a variant whose run would be the same as another's.
    void add(const TradeoffVariant& variant)
    {
        TradeoffPoint point;
        point.variant = variant;
        point.plan = plan_run(scene_.design, *find_fabric(scene_.design, scene_.fabric), *find_experiment(scene_.design, scene_.experiment),
                              variant.fidelity, scene_.options.forced, variant.settings);
        for (TradeoffPoint& other : result_.points)
            if (variant.timed && run_alike(other.plan, point.plan)) {
                other.stands_for.push_back(variant.name);
                return;
            }
        result_.points.push_back(std::move(point));
    }

    /// All variants once, then once more, and so on, so that a noisy machine favours none. Throws Cancelled.
    void run(const std::atomic<bool>& cancel)
    {
        outcomes_.resize(result_.points.size());
        for (int repeat = 0; repeat < options_.repeats; ++repeat)
            for (std::size_t i = 0; i < result_.points.size(); ++i) {
                if (repeat > 0 && !result_.points[i].variant.timed) continue;
                run_one(i, repeat, cancel);
                write();
            }
        result_.complete = true;
        write();
    }

    void write() const
    {
        if (options_.output.empty()) return;
        const std::filesystem::path folder = options_.output;
        write_file(folder / "tradeoff.json", tradeoff_json(result_));
        write_file(folder / "tradeoff.csv", tradeoff_csv(result_));
        write_file(folder / "tradeoff.svg", tradeoff_svg(result_));
    }

private:
    void run_one(std::size_t i, int repeat, const std::atomic<bool>& cancel)
    {
        TradeoffPoint& point = result_.points[i];
        const std::string about =
            fmt::format("repeat {} of {}, {} ({} of {})", repeat + 1, options_.repeats, point.variant.name, i + 1, result_.points.size());
        const auto show = [&](double share) {
            if (bar_) fmt::print(stderr, "\r\033[K{}: {:.0f} %", about, 100 * share);
        };
        show(0);
        TradeoffOutcome outcome = run_apart(scene_, point.variant, cancel, show);
        if (bar_) fmt::print(stderr, "\r\033[K");
        if (!options_.quiet) fmt::print(stderr, "{}: {} s, {}\n", about, rounded_text(outcome.wall, 3), bytes_text(outcome.peak_bytes));
        if (point.variant.timed) {
            point.walls.push_back(outcome.wall);
            point.peaks.push_back(outcome.peak_bytes);
        }
        point.closed_forms = closed_form_errors(outcome);
        point.liquid_steps = outcome.liquid_steps;
        point.switched_on = outcome.switched_on;
        point.stages.clear();
        for (const StageTime& stage : outcome.stages) point.stages[stage.name] = 100 * stage.seconds / outcome.wall;
        if (result_.backend.empty()) { // particles in double precision may run on a CPU
            result_.backend = outcome.backend;
            result_.device = outcome.device;
        }
        outcomes_[i] = std::move(outcome);
        compare();
    }

    const TradeoffOutcome* outcome_named(const std::string& name) const
    {
        for (std::size_t i = 0; i < result_.points.size(); ++i) {
            const TradeoffPoint& point = result_.points[i];
            const bool stands_for = std::find(point.stands_for.begin(), point.stands_for.end(), name) != point.stands_for.end();
            if ((point.variant.name == name || stands_for) && outcomes_[i]) return &*outcomes_[i];
        }
        return nullptr;
    }

    void compare()
    {
        const TradeoffOutcome* reference = outcome_named("reference");
        for (std::size_t i = 0; reference && i < outcomes_.size(); ++i)
            if (outcomes_[i]) result_.points[i].errors = tradeoff_errors(*outcomes_[i], *reference);
        mark_pareto(result_.points);
        result_.convergence.clear();
        const std::pair<const char*, const char*> steps[] = {{"reference / 4", "reference / 2"}, {"reference / 2", "reference"}};
        for (const auto& [coarse, fine] : steps) {
            const TradeoffOutcome *a = outcome_named(coarse), *b = outcome_named(fine);
            if (a && b) result_.convergence.push_back({coarse, fine, tradeoff_errors(*a, *b)});
        }
    }

    const ApartRun& scene_;
    Tradeoff& result_;
    const TradeoffOptions& options_;
    bool bar_;
    std::vector<std::optional<TradeoffOutcome>> outcomes_;
};

std::string percent(const std::optional<double>& share) { return share ? fmt::format("{:.3g} %", 100 * *share) : std::string("-"); }

void print_table(const Tradeoff& t)
{
    fmt::print("{}, {} ({}, {}, median of {})\n", t.fabric, t.experiment, t.backend, t.device, t.repeats);
    fmt::print("  {:<28} {:>10} {:>9} {:>9} {:>9} {:>9}\n", "", "time", "memory", "error", "map", "overlap");
    for (const TradeoffPoint& p : t.points) {
        fmt::print("{} {:<28} {:>10} {:>9} {:>9} {:>9} {:>9}\n", p.pareto ? '*' : ' ', p.variant.name,
                   p.walls.empty() ? "-" : rounded_text(p.wall(), 3) + " s", p.peaks.empty() ? "-" : bytes_text(p.peak()),
                   p.errors ? percent(p.errors->largest) : "-", p.errors ? percent(p.errors->map) : "-",
                   p.errors ? percent(p.errors->overlap) : "-");
        for (const MetricError& m : p.closed_forms)
            fmt::print("    {}: {:.5g}, closed form {:.5g} (error {:.2g} %)\n", m.name, *m.value, *m.reference, 100 * m.error);
        for (const std::string& name : p.stands_for) fmt::print("    same run as {}\n", name);
    }
    for (const ConvergenceStep& step : t.convergence)
        fmt::print("  from {} to {}: error {}, map {}\n", step.coarse, step.fine, percent(step.errors.largest), percent(step.errors.map));
    fmt::print("* no other variant is both faster and more accurate. Time and memory (largest resident set): one process per run, one run\n"
               "at a time. Error against the reference: the largest of all metrics, water contents and 1 - overlap. Map: relative L2.\n");
    for (const TradeoffPoint& p : t.points) {
        if (p.variant.name != "standard" || p.stages.empty()) continue;
        std::vector<std::pair<double, std::string>> stages;
        for (const auto& [name, share] : p.stages) stages.emplace_back(share, name);
        std::sort(stages.rbegin(), stages.rend());
        stages.resize(std::min<std::size_t>(stages.size(), 5));
        fmt::print("Slowest stages of standard:");
        for (const auto& [share, name] : stages) fmt::print(" {} {:.0f} %", name, share);
        fmt::print("\n");
    }
}

int tradeoff(const TradeoffOptions& options)
{
    ApartRun scene;
    scene.options = run_options(options);
    const std::vector<TradeoffVariant> variants = chosen_variants(options, std::exchange(scene.options.knobs, {}));
    scene.design = load_project(options);
    require_valid(scene.design, options);
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
    Measurement measurement(scene, result, options);
    for (const TradeoffVariant& variant : variants) measurement.add(variant);
    bool cancelled = false;
    try {
        measurement.run(cancel);
    } catch (const Cancelled&) {
        cancelled = true;
        if (!options.quiet) fmt::print(stderr, "\n");
    }
    if (options.json)
        fmt::print("{}", tradeoff_json(result));
    else
        print_table(result);
    const std::string where = options.output.empty() ? "" : fmt::format(" Measurements: {}", options.output);
    if (cancelled) {
        fmt::print(stderr, "Cancelled.{}\n", where);
        return exit_cancelled;
    }
    if (!options.quiet && !where.empty()) fmt::print(stderr, "{}\n", where.substr(1));
    return exit_ok;
}

/// For --help: times of the shipped scenes at each fidelity.
std::string measured_help()
{
    std::string text =
        "Measured on the shipped scenes (error against the reference: the largest of all metrics, water contents and 1 - overlap):\n";
    for (const char* backend : {"cpu", "cuda"})
        for (const MeasuredScene& scene : shipped_measurements(backend)) {
            text += fmt::format("  {} on {} ({}, {})\n", scene.experiment, scene.fabric, scene.device, scene.date);
            for (const MeasuredRun& run : scene.runs)
                if (run.settings.empty())
                    text += fmt::format("    {:<10} {:>8} s {:>8} {:>8}\n", name_of(run.plan.fidelity), rounded_text(run.seconds, 3),
                                        bytes_text(run.bytes), percent(run.error));
        }
    return text;
}

} // namespace

void add_tradeoff(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<TradeoffOptions>();
    CLI::App& verb = *app.add_subcommand("tradeoff", "Measure speed against accuracy of one scene: every fidelity, and one knob at a time");
    verb.footer([] {
        return "Example: hygroloom-cli tradeoff cloth.hygro --knobs particles_per_droplet,fibre_shells --repeats 3 -o cloth-tradeoff\n"
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
                  "Also run the reference at half and a quarter of its resolution, to see whether it has converged");
    verb.add_option("-o,--output", options->output, "Folder for the results");
    verb.callback([&chosen, options] { chosen = [options] { return tradeoff(*options); }; });
}

} // namespace hygroloom
