// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// compare: candidates on the same experiment, ranked.
#include "app/cli_compare.h"
#include "app/cli_interrupt.h"
#include "app/cli_replicates.h"
#include "app/cli_report.h"
#include "app/cli_wear.h"
#include "app/cli_why.h"

#include "core/analysis/card.h"
#include "core/analysis/comparison_report.h"
#include "core/analysis/map_picture.h"
#include "core/design/unknowns.h"
#include "core/project/atomic_file.h"
#include "core/run/plan_run.h"
#include "gpu/backends.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace hygroloom {
namespace {

/// The maps of a candidate's last frame.
struct CandidateMaps {
    MapPicture top, bottom;
};

constexpr int crossings_per_cell = 2;

void write_pictures(std::vector<std::optional<CandidateMaps>>& maps, const std::vector<std::string>& fabrics,
                    const std::filesystem::path& folder)
{
    std::vector<MapPicture*> all;
    for (auto& of : maps)
        if (of) all.insert(all.end(), {&of->top, &of->bottom});
    share_scale(all);
    const std::vector<std::string> stems = file_stems(fabrics);
    for (std::size_t i = 0; i < fabrics.size(); ++i) {
        if (!maps[i]) continue;
        auto& [top, bottom] = *maps[i];
        write_picture(top, folder / (stems[i] + "-top.png"));
        write_picture(bottom, folder / (stems[i] + "-bottom.png"));
    }
}

bool wants_maps(const CompareOptions& options) { return !options.output.empty() || !options.report.empty(); }

/// The numbers are written after every run, the maps of the first replicates, which are the cloths as given, kept. Throws what writing
/// threw.
void run_candidates(const std::vector<NamedJob>& candidates, const CompareOptions& options, const std::atomic<bool>& cancel,
                    RunQueue& queue, const std::shared_ptr<RunPlaces>& places, Comparison& comparison,
                    std::vector<std::optional<CandidateMaps>>& maps)
{
    RunBar bar(options.quiet, candidates.size() * static_cast<std::size_t>(comparison.replicates));
    std::vector<std::shared_ptr<const Frame>> firsts(candidates.size()), lasts(candidates.size());
    ComparedWatch watch;
    watch.begins = [&](std::size_t i, RunJob& job) {
        job.beside = shown_in(bar, i, job.fabric);
        if (i < candidates.size() && wants_maps(options))
            job.beside.frame = [&, i](const std::shared_ptr<const Frame>& frame) {
                if (!firsts[i]) firsts[i] = frame;
                lasts[i] = frame;
            };
    };
    watch.came = [&](std::size_t i, const RunResult& result) {
        if (i >= candidates.size() || !firsts[i]) return;
        const RunRecord& run = result.sample->run;
        const Frame start = start_of_maps(run, *firsts[i]);
        maps[i].emplace(CandidateMaps{map_picture(run, *lasts[i], start, MapSide::top, crossings_per_cell),
                                      map_picture(run, *lasts[i], start, MapSide::bottom, crossings_per_cell)});
        firsts[i] = lasts[i] = nullptr;
    };
    watch.ended = [&](std::size_t i) {
        bar.end(i);
        write_numbers(comparison, options.output);
    };
    run_comparison(comparison, candidates, queue, places, cancel, watch);
}

/// On one page, with the maps that there are.
void write_report(const Comparison& comparison, const std::vector<std::optional<CandidateMaps>>& maps,
                  const std::vector<std::string>& fabrics, const std::string& file)
{
    std::vector<std::pair<std::string, MapPicture>> pictures;
    for (const Candidate& candidate : comparison.candidates) {
        const auto at = static_cast<std::size_t>(std::find(fabrics.begin(), fabrics.end(), candidate.fabric) - fabrics.begin());
        if (!maps[at]) continue;
        for (const auto& [side, map] : {std::pair{"top", &maps[at]->top}, std::pair{"bottom", &maps[at]->bottom}})
            pictures.emplace_back(map_caption(comparison, candidate.fabric, side), *map);
    }
    write_report_file(file, comparison_report(comparison, pictures_on_one_scale(std::move(pictures))));
}

/// The compared fabrics; with --why the two that it is about, unless others are named, too. Sets the baseline of --why.
std::vector<std::string> compared_fabrics(const Design& design, CompareOptions& options)
{
    std::vector<std::string> fabrics = chosen_fabrics(design, options.fabrics);
    if (options.why.empty()) return fabrics;
    ProjectOptions one;
    one.fabric = options.why;
    chosen_fabric(design, one); // throws with the names there are
    const auto is_other = [&](const std::string& name) { return name != options.why; };
    if (options.baseline.empty()) {
        const auto other = std::find_if(fabrics.begin(), fabrics.end(), is_other);
        options.baseline = other == fabrics.end() ? options.why : *other;
    }
    if (!is_other(options.baseline))
        throw Stop(exit_usage, fmt::format("--why: \"{}\" needs another fabric beside it; name one with --baseline.", options.why));
    one.fabric = options.baseline;
    chosen_fabric(design, one);
    if (options.fabrics.empty()) fabrics = {options.why, options.baseline};
    if (std::find(fabrics.begin(), fabrics.end(), options.why) == fabrics.end())
        throw Stop(exit_usage, fmt::format("--why: \"{}\" is not among the compared fabrics.", options.why));
    return fabrics;
}

/// Results on stdout and in the files that were asked for.
void give_results(const CompareOptions& options, const Comparison& comparison, const FidelityChoice& choice,
                  std::vector<std::optional<CandidateMaps>>& maps, const std::vector<std::string>& fabrics)
{
    const bool some = !comparison.candidates.empty();
    if (options.json)
        print_result("{}", comparison_json(comparison));
    else if (some)
        print_result("{}{}", comparison_table(comparison), fidelity_text(choice));
    if (!options.output.empty() && some) {
        if (comparison.why) write_numbers(comparison, options.output);
        write_pictures(maps, fabrics, options.output);
        if (!options.quiet) print_note("Table and maps: {}\n", options.output);
    }
    if (!options.report.empty() && some) {
        write_report(comparison, maps, fabrics, options.report);
        if (!options.quiet) print_note("Report: {}\n", options.report);
    }
}

std::map<std::string, LaboratoryNumbers> cards_of(const Design& design, const FittedFabrics& fitted,
                                                  const std::vector<std::string>& fabrics)
{
    std::map<std::string, LaboratoryNumbers> cards;
    for (std::size_t i = 0; i < design.fabrics.size(); ++i)
        if (std::ranges::find(fabrics, design.fabrics[i].name) != fabrics.end())
            cards[design.fabrics[i].name] = compared_numbers(design, design.fabrics[i], *fitted[i]);
    return cards;
}

int compare(CompareOptions options)
{
    check_fidelity(options);
    check_report_name(options.report);
    RunOptions how = run_options(options);
    how.may_go_on_on_cpu = true;
    const Design design = load_project(options);
    const FittedFabrics fitted = require_valid(design, options);
    if (const WearExperiment* wear = chosen_wear(design, options)) {
        if (options.card) throw Stop(exit_usage, "--card: A garment has no technical card; ask for its fabrics' with the verb card.");
        return compare_garments(options, design, *wear);
    }
    if (!options.others.empty() || options.cell_mm > 0)
        throw Stop(exit_usage, "Several projects and --cell-mm work with experiments on garments (type wear).");
    const Experiment& experiment = chosen_experiment(design, options);
    const std::vector<std::string> fabrics = compared_fabrics(design, options);
    if (fabrics.size() < 2) throw Stop(exit_usage, "A comparison needs two or more fabrics; use simulate for one.");
    const int runs = static_cast<int>(fabrics.size()) * options.replicates;
    std::optional<WhyPlan> why;
    if (!options.why.empty()) why = plan_why(design, options.why, options.baseline, experiment.name, options.replicates > 1);
    const int scenes = why ? std::max(runs, static_cast<int>(why->mixtures.size()) * options.replicates) : runs;
    announce_scenes(options.at_once, scenes);
    const std::vector<Textile> textiles = textiles_of_runs(design, fitted, fabrics, experiment);
    std::vector<Textile> all_textiles = textiles;
    if (why)
        for (Textile& textile : textiles_of_mixtures(design, *why)) all_textiles.push_back(std::move(textile));
    const FidelityChoice choice = chosen_fidelity(options, design, all_textiles, how.forced, how.knobs);
    how.fidelity = choice.fidelity;
    how.fidelity_reason = choice.reason;
    Comparison comparison = comparison_of(options, experiment.name, compared_by(experiment.type), fabrics);
    if (options.card) comparison.cards = cards_of(design, fitted, fabrics);
    make_folder(options.output);
    write_numbers(comparison, options.output); // fails before the first run when the folder cannot be written to
    const auto places = open_places(options, options.at_once, scenes, bytes_of_largest(design, experiment, all_textiles, how));

    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    RunQueue queue;
    std::vector<std::optional<CandidateMaps>> maps(fabrics.size());
    run_candidates(jobs_of(design, fabrics, experiment.name, textiles, how), options, cancel, queue, places, comparison, maps);
    if (why && comparison.complete) find_why(comparison, *why, design, how, options.quiet, queue, places, cancel);
    give_results(options, comparison, choice, maps, fabrics);
    if (cancel && comparison.complete) {
        print_note("Cancelled after all runs; maps or reasons are missing.\n");
        return exit_cancelled;
    }
    if (comparison.complete && why && !comparison.why) return exit_cancelled;
    return exit_code_of(comparison, static_cast<std::size_t>(runs));
}

} // namespace

void write_numbers(const Comparison& comparison, const std::filesystem::path& folder)
{
    if (folder.empty()) return;
    write_file(folder / "comparison.json", comparison_json(comparison));
    write_file(folder / "comparison.csv", comparison_csv(comparison));
}

Comparison comparison_of(const CompareOptions& options, const std::string& experiment, std::vector<OutcomeInfo> criteria,
                         const std::vector<std::string>& names)
{
    Comparison comparison;
    comparison.experiment = experiment;
    comparison.criteria = std::move(criteria);
    comparison.ranked_by = as_usage([&] { return criterion_named(comparison.criteria, options.by); });
    comparison.replicates = options.replicates;
    comparison.baseline = options.baseline.empty() ? names.front() : options.baseline;
    if (std::find(names.begin(), names.end(), comparison.baseline) == names.end())
        throw Stop(exit_usage, fmt::format("--baseline: \"{}\" is not among what is compared.", comparison.baseline));
    if (!options.measured.empty()) {
        std::vector<std::pair<std::string, std::string>> metrics;
        for (const OutcomeInfo& criterion : comparison.criteria) metrics.emplace_back(criterion.key, criterion.unit);
        comparison.measured = read_laboratory_table(read_file(options.measured, std::size_t{16} << 20U), options.measured, names, metrics);
    }
    return comparison;
}

int exit_code_of(const Comparison& comparison, std::size_t runs)
{
    const auto failed = [](const Candidate& candidate) { return !candidate.failure.empty(); };
    if (comparison.complete) return std::any_of(comparison.candidates.begin(), comparison.candidates.end(), failed) ? exit_failed : exit_ok;
    int ended = 0;
    for (const Candidate& candidate : comparison.candidates) ended += runs_of(candidate);
    print_note("Cancelled after {} of {} runs.\n", ended, runs);
    return exit_cancelled;
}

void add_compare(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<CompareOptions>();
    CLI::App& verb = *app.add_subcommand("compare", "Run several fabrics, or garments, on the same experiment and rank them");
    verb.footer(
        "Example: hygroloom-cli compare cloth.hygro --experiment \"one drop\" --fabrics \"Denim,Textile F\" -o compared\n"
        "The folder receives comparison.json, comparison.csv and a water map of each face of each fabric, all on one colour scale.\n"
        "With --replicates maps are of the first run of each cloth; the report's curves have bands.\n"
        "Ctrl-C keeps the finished runs.\n"
        "Garments: in an experiment of the type wear the garment is cut from each fabric in turn. Several projects are compared as "
        "they are.\n"
        "  hygroloom-cli compare tee.hygro --experiment wear --fabrics \"Denim,Textile F\" --replicates 4\n"
        "  hygroloom-cli compare tee.hygro singlet.hygro --experiment wear\n"
        "Why is one better? hygroloom-cli compare cloth.hygro --why \"Textile E\" --baseline \"Textile F\" --by absorbency_time_s\n"
        "What a fidelity is made of, and how to change a part of it: hygroloom-cli plan --help");
    add_project_options(verb, *options, true);
    verb.remove_option(verb.get_option("--fabric"));
    verb.add_option("others", options->others, "Further projects, of which each has a garment with an experiment of that name")
        ->type_name("FILE");
    options->takes_knobs = true;
    verb.add_option("--fabrics", options->fabrics, "Two or more fabrics, separated by commas; all of the project when left out")
        ->allow_extra_args(false);
    verb.add_option("--by", options->by,
                    "Metric to rank by, such as absorbency_time_s or \"absorbency time\"; the first of the table when left out");
    verb.add_option("--baseline", options->baseline, "Fabric that the verdicts are against; the first when left out");
    add_replicates_option(verb, options->replicates, " of each fabric");
    verb.add_option("--cell-mm", options->cell_mm, "Garments: cell size, mm. Default: by fidelity")->check(CLI::Range(0.05, 100.0));
    verb.add_option(
            "--why", options->why,
            "Fabric to explain: how much of its difference to the baseline in the metric of --by each input that differs makes. Runs "
            "mixtures of the two, 14 at most where 4 parts differ, else two a part")
        ->type_name("FABRIC");
    verb.add_option("--measured", options->measured, "Numbers of a laboratory beside: CSV with fabric, metric, value, unit and spread")
        ->type_name("FILE");
    verb.add_flag("--card", options->card, "The laboratory's numbers of each fabric's technical card beside; not of garments");
    add_fidelity_options(verb, *options, ", for all runs together");
    add_physics_option(verb, *options);
    add_machine_options(verb, *options);
    add_at_once_option(verb, options->at_once);
    verb.add_option("--report", options->report,
                    "Write a report (.html, .pdf, .txt or .json) with verdicts, intervals, maps, curves and what is not known")
        ->type_name("FILE");
    verb.add_option("-o,--output", options->output, "Folder for the table and the maps")->type_name("FOLDER");
    verb.callback([&chosen, options] { chosen = [options] { return compare(*options); }; });
}

} // namespace hygroloom
