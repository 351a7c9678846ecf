// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// compare: candidates on the same experiment, ranked.
#include "app/cli_interrupt.h"
#include "app/cli_run.h"

#include "core/analysis/comparison.h"
#include "core/analysis/map_image.h"
#include "core/base/units.h"
#include "core/project/atomic_file.h"
#include "gpu/backends.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {
namespace {

struct CompareOptions : RunVerbOptions {
    std::vector<std::string> fabrics;
    std::string by;
    std::string output;
};

/// The maps of a candidate's last frame.
struct CandidateMaps {
    CellMap top, bottom;
    Circle wet_top, wet_bottom;
    double width = 0, height = 0, time = 0; ///< m, m, s
};

constexpr int crossings_per_cell = 2;

CandidateMaps maps_of(const RunRecord& run, const Frame& first, const Frame& last)
{
    const Textile& t = run.textile;
    const Frame start = start_of_maps(run, first);
    return {cell_map(t, last, start, MapSide::top, crossings_per_cell),
            cell_map(t, last, start, MapSide::bottom, crossings_per_cell),
            wetted_circle(t, last, Face::top),
            wetted_circle(t, last, Face::bottom),
            t.ends() * t.warp.pitch,
            t.picks() * t.weft.pitch,
            last.time};
}

/// Those named, all when none is. A name may hold commas when it stands alone.
std::vector<std::string> chosen_fabrics(const Design& design, const CompareOptions& options)
{
    std::vector<std::string> names;
    for (const std::string& given : options.fabrics) {
        const std::vector<std::string> words = find_fabric(design, given) ? std::vector{given} : words_of(given);
        names.insert(names.end(), words.begin(), words.end());
    }
    if (options.fabrics.empty())
        for (const Fabric& fabric : design.fabrics) names.push_back(fabric.name);
    for (std::size_t i = 0; i < names.size(); ++i) {
        ProjectOptions one;
        one.fabric = names[i];
        chosen_fabric(design, one); // tells which there are
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
            names.begin() + static_cast<std::ptrdiff_t>(i))
            throw Stop(exit_usage, fmt::format("--fabrics: \"{}\" is named twice.", names[i]));
    }
    if (names.size() < 2) throw Stop(exit_usage, "A comparison needs two fabrics or more; simulate runs one.");
    return names;
}

std::string file_stem(std::size_t rank, const std::string& fabric)
{
    std::string stem = fmt::format("{}-", rank);
    for (const char c : fabric) stem += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
    return stem;
}

/// All with the same colours, so that they can be laid side by side.
void write_pictures(const Comparison& comparison, const std::map<std::string, CandidateMaps>& maps, const std::filesystem::path& folder)
{
    double most = 0;
    for (const auto& [fabric, m] : maps) most = std::max({most, m.top.maximum(), m.bottom.maximum()});
    for (std::size_t i = 0; i < comparison.candidates.size(); ++i) {
        const std::string& fabric = comparison.candidates[i].fabric;
        const auto found = maps.find(fabric);
        if (found == maps.end()) continue;
        const CandidateMaps& m = found->second;
        for (const bool top : {true, false}) {
            const Circle& wet = top ? m.wet_top : m.wet_bottom;
            MapImageOptions image;
            image.most = most;
            image.captions = {fmt::format("{}, {}", fabric, comparison.experiment),
                              fmt::format("{} face after {:.4g} s, cells of {} x {}", top ? "top" : "bottom", m.time, crossings_per_cell,
                                          crossings_per_cell)};
            if (wet.radius > 0) {
                image.circle = wet;
                image.captions.push_back(fmt::format("wetted radius {:.3g} mm", mm_from_metre(wet.radius)));
            }
            write_png(draw_map(top ? m.top : m.bottom, m.width, m.height, image),
                      folder / (file_stem(i + 1, fabric) + (top ? "-top.png" : "-bottom.png")));
        }
    }
}

void print_comparison(const Comparison& comparison)
{
    fmt::print("{}: ranked by {}\n", comparison.experiment, order_text(comparison));
    std::size_t widest = 6;
    for (const Candidate& c : comparison.candidates) widest = std::max(widest, c.fabric.size());
    fmt::print("    {:<{}}", "fabric", widest);
    for (const Criterion& criterion : comparison.criteria) fmt::print("  {}", criterion.name);
    fmt::print("  wall_s\n");
    int rank = 0;
    for (const Candidate& c : comparison.candidates) {
        fmt::print("{:>2}  {:<{}}", ++rank, c.fabric, widest);
        if (!c.failure.empty()) {
            fmt::print("  {}\n", c.failure);
            continue;
        }
        for (const Criterion& criterion : comparison.criteria) {
            const auto found = c.numbers.find(criterion.name);
            fmt::print("  {:>{}}", found == c.numbers.end() ? "-" : fmt::format("{:.4g}", found->second), criterion.name.size());
        }
        fmt::print("  {:>6}\n", fmt::format("{:.3g}", c.wall));
    }
}

int compare(const CompareOptions& options)
{
    RunOptions how = run_options(options);
    how.fidelity = as_usage([&] { return fidelity_from_name(options.fidelity); });
    const Design design = load_project(options);
    require_valid(design, options);
    const Experiment& experiment = chosen_experiment(design, options);
    const std::vector<std::string> fabrics = chosen_fabrics(design, options);
    Comparison comparison;
    comparison.experiment = experiment.name;
    comparison.criteria = criteria_of(experiment.type);
    comparison.ranked_by = as_usage([&] { return criterion_named(comparison.criteria, options.by); });
    make_folder(options.output);
    const std::unique_ptr<Backend> backend = open_backend(options);

    RunControl control;
    const InterruptCancels cancels(control.cancel);
    std::map<std::string, CandidateMaps> maps;
    bool cancelled = false, failed = false;
    for (std::size_t i = 0; i < fabrics.size() && !cancelled; ++i) {
        const std::string& fabric = fabrics[i];
        std::shared_ptr<const Frame> first, last;
        const auto see = [&](const std::shared_ptr<const Frame>& frame) {
            if (!first) first = frame;
            last = frame;
        };
        try {
            const FinishedRun finished = run_with_bar(design, fabric, experiment.name, how, *backend, control, options.quiet,
                                                      fmt::format("{} ({} of {}) ", fabric, i + 1, fabrics.size()), see);
            comparison.candidates.push_back(candidate_of(finished.run, finished.metrics, comparison.criteria));
            if (!options.output.empty()) maps[fabric] = maps_of(finished.run, *first, *last);
        } catch (const Cancelled&) {
            cancelled = true;
        } catch (const Stop&) {
            throw;
        } catch (const Error& error) {
            failed = true;
            Candidate candidate;
            candidate.fabric = fabric;
            candidate.failure = error.what();
            comparison.candidates.push_back(std::move(candidate));
        }
    }
    rank(comparison);
    if (!options.output.empty()) {
        const std::filesystem::path folder = options.output;
        write_file(folder / "comparison.json", comparison_json(comparison));
        write_file(folder / "comparison.csv", comparison_csv(comparison));
        write_pictures(comparison, maps, folder);
        if (!options.quiet) fmt::print(stderr, "Table, numbers and maps are in {}.\n", options.output);
    }
    if (options.json)
        fmt::print("{}", comparison_json(comparison));
    else
        print_comparison(comparison);
    if (cancelled) {
        fmt::print(stderr, "Cancelled after {} of {} fabrics.\n", comparison.candidates.size(), fabrics.size());
        return exit_cancelled;
    }
    return failed ? exit_failed : exit_ok;
}

} // namespace

void add_compare(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<CompareOptions>();
    CLI::App& verb = *app.add_subcommand("compare", "Several fabrics on the same experiment, ranked");
    verb.footer(
        "Example: hygroloom-cli compare cloth.hygro --experiment \"one drop\" --fabrics \"Textile E,Textile F\" -o compared\n"
        "The folder gets comparison.json, comparison.csv and a water map of each face of each fabric, all with one scale of colours.\n"
        "Ctrl-C keeps what has been run until then.\n\n" +
        knob_help());
    add_project_options(verb, *options, true);
    verb.remove_option(verb.get_option("--fabric"));
    options->takes_knobs = true;
    verb.add_option("--fabrics", options->fabrics, "Names of two or more, with commas between; all of the project when left out")
        ->allow_extra_args(false);
    verb.add_option("--by", options->by, "Number to rank by, as in the table's head; the first of it when left out");
    verb.add_option("--fidelity", options->fidelity, "draft, standard or reference; the same for all");
    add_physics_option(verb, *options);
    add_machine_options(verb, *options);
    verb.add_option("-o,--output", options->output, "Folder to write the table and the maps to");
    verb.callback([&chosen, options] { chosen = [options] { return compare(*options); }; });
}

} // namespace hygroloom
