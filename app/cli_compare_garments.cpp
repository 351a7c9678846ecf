// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// compare, of garments: one garment cut from several fabrics, or the garments of several projects.
#include "app/cli_compare.h"
#include "app/cli_interrupt.h"
#include "app/cli_report.h"
#include "app/cli_wear.h"

#include "core/analysis/comparison_report.h"
#include "core/wear/wear_outcomes.h"
#include "core/wear/wear_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

WearVerbOptions wear_options(const CompareOptions& options)
{
    WearVerbOptions how;
    static_cast<RunVerbOptions&>(how) = options;
    how.fidelity = options.fidelity;
    how.cell_mm = options.cell_mm;
    return how;
}

void refuse_what_samples_take(const CompareOptions& options)
{
    const std::pair<bool, const char*> refused[] = {{!options.physics.empty(), "--physics"}, {!options.why.empty(), "--why"}};
    for (const auto& [given, name] : refused)
        if (given) throw Stop(exit_usage, fmt::format("Comparisons of garments do not take {}.", name));
    if (!options.others.empty() && !options.fabrics.empty()) throw Stop(exit_usage, "Give either several projects or --fabrics with one.");
}

/// What the experiments of two projects differ in beside name and garment; empty: in nothing.
std::string difference_of(const WearExperiment& a, const WearExperiment& b)
{
    const std::pair<bool, const char*> parts[] = {{a.climate == b.climate, "climate"},
                                                  {a.liquid == b.liquid, "liquid"},
                                                  {a.duration_s == b.duration_s, "duration_s"},
                                                  {a.activity == b.activity, "activity"},
                                                  {a.activity_file == b.activity_file, "activity_file"},
                                                  {a.initial_water_g_m2 == b.initial_water_g_m2, "initial_water_g_m2"}};
    for (const auto& [same, key] : parts)
        if (!same) return key;
    return "";
}

/// Each project with its own experiment on a garment, named like its file. All experiments are alike.
std::vector<NamedJob> of_projects(const CompareOptions& options, const Design& design, const WearExperiment& wear)
{
    const auto named = [](const std::string& file) { return std::filesystem::path(file).stem().string(); };
    std::vector<NamedJob> all{
        {named(options.project), {std::make_shared<const Design>(design), wear.name, {}, folder_of(options.project)}}};
    for (const std::string& file : options.others) {
        ProjectOptions other = options;
        other.project = file;
        const Design own = load_project(other);
        require_valid(own, other);
        const WearExperiment* const worn = chosen_wear(own, other);
        if (worn == nullptr) throw Stop(exit_usage, fmt::format("{}: The experiment \"{}\" is none on a garment.", file, other.experiment));
        if (const std::string key = difference_of(*worn, wear); !key.empty())
            throw Stop(exit_usage, fmt::format("{}: The experiment \"{}\" is not \"{}\" of {}: they differ in {}. Garments are compared "
                                               "on the same experiment.",
                                               file, worn->name, wear.name, options.project, key));
        all.push_back({named(file), {std::make_shared<const Design>(own), worn->name, {}, folder_of(file)}});
        const auto same = [&](const NamedJob& before) { return before.name == all.back().name; };
        if (std::any_of(all.begin(), all.end() - 1, same)) all.back().name = file;
    }
    return all;
}

std::vector<NamedJob> candidates_of(const CompareOptions& options, const Design& design, const WearExperiment& wear)
{
    if (!options.others.empty()) return of_projects(options, design, wear);
    const auto shared = std::make_shared<const Design>(design);
    std::vector<NamedJob> all;
    for (const std::string& fabric : chosen_fabrics(design, options.fabrics))
        all.push_back({fabric, {shared, wear.name, fabric, folder_of(options.project)}});
    return all;
}

/// All panels of all candidates at their ends, on one scale; also to a folder each.
std::vector<ReportPicture> maps_of(const std::vector<NamedJob>& candidates, const std::vector<FinishedGarment>& firsts,
                                   const std::string& folder)
{
    WearMapOptions how;
    how.crossings = 1; // as computed
    std::vector<std::string> names;
    for (const NamedJob& candidate : candidates) names.push_back(candidate.name);
    std::vector<GarmentAtEnd> ends;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (firsts[i].last) ends.push_back({names[i], &firsts[i].record->layout, firsts[i].last});
    std::vector<ReportPicture> pictures = pictures_on_one_scale(ends, how);
    const std::vector<std::string> stems = file_stems(names);
    for (std::size_t i = 0; i < candidates.size() && !folder.empty(); ++i) {
        if (!firsts[i].last) continue;
        const WearLayout& layout = firsts[i].record->layout;
        const std::string own = (std::filesystem::path(folder) / stems[i]).string();
        make_folder(own);
        write_wear_map(layout, *firsts[i].last, wear_map(layout, *firsts[i].last, how), own);
    }
    return pictures;
}

} // namespace

int compare_garments(const CompareOptions& options, const Design& design, const WearExperiment& wear)
{
    refuse_what_samples_take(options);
    const std::vector<NamedJob> candidates = candidates_of(options, design, wear);
    if (candidates.size() < 2)
        throw Stop(exit_usage, "A comparison needs two or more fabrics that the garment is cut from, or two or more projects; use simulate "
                               "for one.");
    std::vector<std::string> names;
    for (const NamedJob& candidate : candidates) names.push_back(candidate.name);
    Comparison comparison = comparison_of(options, wear.name, compared_by_wear(), names);
    comparison.of_garments = true;
    make_folder(options.output);
    write_numbers(comparison, options.output); // fails before the first run when the folder cannot be written to
    std::atomic<bool> cancel{false};
    const InterruptCancels cancels(cancel);
    const std::vector<FinishedGarment> firsts = run_garments(comparison, candidates, wear_options(options), options.at_once, cancel,
                                                             [&] { write_numbers(comparison, options.output); });
    const bool some = !comparison.candidates.empty();
    if (options.json)
        print_result("{}", comparison_json(comparison));
    else if (some)
        print_result("{}", comparison_table(comparison));
    if (some && !(options.output.empty() && options.report.empty())) {
        const std::vector<ReportPicture> maps = maps_of(candidates, firsts, options.output);
        if (!options.report.empty()) write_report_file(options.report, comparison_report(comparison, maps));
        if (!options.quiet && !options.output.empty()) print_note("Table and maps: {}\n", options.output);
        if (!options.quiet && !options.report.empty()) print_note("Report: {}\n", options.report);
    }
    return exit_code_of(comparison, candidates.size() * static_cast<std::size_t>(options.replicates));
}

} // namespace hygroloom
