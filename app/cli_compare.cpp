// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// compare: candidates on the same experiment, ranked.
#include "app/cli_fidelity.h"
#include "app/cli_interrupt.h"
#include "app/cli_metrics.h"

#include "core/analysis/sweep.h"
#include "core/project/atomic_file.h"
#include "gpu/backends.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace hygroloom {
namespace {

struct CompareOptions : FidelityOptions {
    std::vector<std::string> fabrics; ///< as given
    std::string by;
    std::string output;
    int at_once = 0;
};

/// The maps of a candidate's last frame.
struct CandidateMaps {
    MapPicture top, bottom;
};

constexpr int crossings_per_cell = 2;

/// Rewrites the tables after every run.
void write_numbers(const Comparison& comparison, const std::filesystem::path& folder)
{
    if (folder.empty()) return;
    write_file(folder / "comparison.json", comparison_json(comparison));
    write_file(folder / "comparison.csv", comparison_csv(comparison));
}

/// All on one colour scale, so that they can be compared.
void write_pictures(std::vector<std::optional<CandidateMaps>>& maps, const std::vector<std::string>& fabrics,
                    const std::filesystem::path& folder)
{
    double most = 0;
    for (const auto& m : maps)
        if (m) most = std::max({most, m->top.map.maximum(), m->bottom.map.maximum()});
    const std::vector<std::string> stems = file_stems(fabrics);
    for (std::size_t i = 0; i < fabrics.size(); ++i) {
        if (!maps[i]) continue;
        auto& [top, bottom] = *maps[i];
        top.image.most = bottom.image.most = most;
        write_picture(top, folder / (stems[i] + "-top.png"));
        write_picture(bottom, folder / (stems[i] + "-bottom.png"));
    }
}

/// Each fabric as its RunOptions say. The numbers are written after every run, the maps kept where there is an output folder. Throws what
/// writing threw.
void run_candidates(const Design& design, const std::vector<std::string>& fabrics, std::vector<RunOptions> how,
                    const CompareOptions& options, RunControl& control, const std::vector<std::unique_ptr<Backend>>& backends,
                    Comparison& comparison, std::vector<std::optional<CandidateMaps>>& maps)
{
    std::mutex one_on_cpu;
    for (RunOptions& one : how) one.one_on_cpu = &one_on_cpu;
    RunBar bar(options.quiet, fabrics.size());
    const auto run = [&](std::size_t i, Backend& backend) {
        std::shared_ptr<const Frame> first, last;
        FinishedRun finished = run_with_bar(design, fabrics[i], comparison.experiment, how[i], backend, control, bar, i,
                                            [&](const std::shared_ptr<const Frame>& frame) {
                                                if (!first) first = frame;
                                                last = frame;
                                            });
        if (!options.output.empty()) {
            const Frame start = start_of_maps(finished.run, *first);
            maps[i] = {map_picture(finished.run, *last, start, MapSide::top, crossings_per_cell),
                       map_picture(finished.run, *last, start, MapSide::bottom, crossings_per_cell)};
        }
        finished.run.textile = {}; // the comparison needs the numbers alone
        CandidateRun candidate{candidate_of(std::make_shared<const RunRecord>(std::move(finished.run)),
                                            std::make_shared<const Metrics>(std::move(finished.metrics))),
                               !finished.device_failure.empty()};
        if (candidate.device_failed) candidate.candidate.notes.push_back(finished.device_failure);
        return candidate;
    };
    run_comparison(comparison, fabrics, backends, control, run, [&](std::size_t i) {
        bar.end(i);
        write_numbers(comparison, options.output);
    });
}

int compare(const CompareOptions& options)
{
    check_fidelity(options);
    RunOptions how = run_options(options);
    how.may_go_on_on_cpu = true;
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    const Experiment& experiment = chosen_experiment(design, options);
    const std::vector<std::string> fabrics = chosen_fabrics(design, options.fabrics);
    if (fabrics.size() < 2) throw Stop(exit_usage, "A comparison needs two or more fabrics; use simulate for one.");
    announce_scenes(options.at_once, static_cast<int>(fabrics.size()));
    const std::vector<Textile> textiles = textiles_of_runs(design, fitted, fabrics, experiment);
    const FidelityChoice choice = chosen_fidelity(options, design, textiles, how.forced, how.knobs);
    how.fidelity = choice.fidelity;
    how.fidelity_reason = choice.reason;
    Comparison comparison;
    comparison.experiment = experiment.name;
    comparison.criteria = compared_by(experiment.type);
    comparison.ranked_by = as_usage([&] { return criterion_named(comparison.criteria, options.by); });
    make_folder(options.output);
    write_numbers(comparison, options.output); // fails before the first run when the folder cannot be written to
    const auto backends =
        open_backends(options, options.at_once, static_cast<int>(fabrics.size()), bytes_of_largest(design, experiment, textiles, how));

    RunControl control;
    const InterruptCancels cancels(control.cancel);
    std::vector<std::optional<CandidateMaps>> maps(fabrics.size());
    std::vector<RunOptions> each(fabrics.size(), how);
    for (std::size_t i = 0; i < each.size(); ++i) each[i].textile = std::make_shared<const Textile>(textiles[i]);
    run_candidates(design, fabrics, each, options, control, backends, comparison, maps);
    const bool some = !comparison.candidates.empty();
    if (options.json)
        print_result("{}", comparison_json(comparison));
    else if (some)
        print_result("{}{}", comparison_table(comparison), fidelity_text(choice));
    if (!options.output.empty() && some) {
        write_pictures(maps, fabrics, options.output);
        if (!options.quiet) print_note("Table and maps: {}\n", options.output);
    }
    if (!comparison.complete) {
        print_note("Cancelled after {} of {} fabrics.\n", comparison.candidates.size(), fabrics.size());
        return exit_cancelled;
    }
    const bool failed = std::any_of(comparison.candidates.begin(), comparison.candidates.end(),
                                    [](const Candidate& candidate) { return !candidate.failure.empty(); });
    return failed ? exit_failed : exit_ok;
}

} // namespace

void add_compare(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<CompareOptions>();
    CLI::App& verb = *app.add_subcommand("compare", "Run several fabrics on the same experiment and rank them");
    verb.footer(
        "Example: hygroloom-cli compare cloth.hygro --experiment \"one drop\" --fabrics \"Textile E,Textile F\" -o compared\n"
        "The folder receives comparison.json, comparison.csv and a water map of each face of each fabric, all on one colour scale.\n"
        "Ctrl-C keeps the finished runs.\n\n" +
        knob_help());
    add_project_options(verb, *options, true);
    verb.remove_option(verb.get_option("--fabric"));
    options->takes_knobs = true;
    verb.add_option("--fabrics", options->fabrics, "Two or more fabrics, separated by commas; all of the project when left out")
        ->allow_extra_args(false);
    verb.add_option("--by", options->by, "Metric to rank by, such as absorbency_time_s; the first of the table when left out");
    add_fidelity_options(verb, *options, ", for all runs together");
    add_physics_option(verb, *options);
    add_machine_options(verb, *options);
    add_at_once_option(verb, options->at_once);
    verb.add_option("-o,--output", options->output, "Folder for the table and the maps")->type_name("FOLDER");
    verb.callback([&chosen, options] { chosen = [options] { return compare(*options); }; });
}

} // namespace hygroloom
