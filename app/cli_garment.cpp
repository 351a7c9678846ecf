// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// garment: what a garment's file holds, and a project with it.
#include "app/cli_wear.h"

#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/base/words.h"
#include "core/design/wear.h"
#include "core/garment/pattern.h"
#include "core/project/atomic_file.h"
#include "core/project/library.h"
#include "core/project/project_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <filesystem>
#include <optional>

namespace hygroloom {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* built_in = "built-in:";

struct GarmentOptions : CommonOptions {
    std::string action;
    std::string file;
    std::string output;
    std::string name;
    std::string uv_unit = name_of(UvUnit::from_lengths);
    std::string fabric; ///< that panels are cut from; empty: the project's first
    WearVerbOptions plan;
    WearMapVerbOptions map;
};

Garment garment_of(const GarmentOptions& options)
{
    Garment garment;
    if (options.file.starts_with(built_in)) {
        const std::string kind = options.file.substr(std::string(built_in).size());
        const std::vector<std::string>& kinds = built_in_garments();
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
            throw Stop(
                exit_usage,
                fmt::format("{}: There is no such built-in garment{} There are built-in:tee, built-in:singlet and built-in:leggings.",
                            options.file, did_you_mean(kind, kinds)));
        garment.built_in = standard_garment(kind);
        garment.name = kind;
    } else {
        garment.source = options.file;
        garment.name = in_one_line(fs::path(options.file).stem().string());
    }
    for (int unit = 0; unit < uv_units; ++unit)
        if (options.uv_unit == name_of(static_cast<UvUnit>(unit))) garment.uv_unit = static_cast<UvUnit>(unit);
    if (garment.uv_unit != UvUnit::from_lengths && (garment.is_built_in() || garment.is_pattern()))
        throw Stop(exit_usage, "--uv-unit " + options.uv_unit + ": Only a mesh has flat coordinates without a unit; leave it out.");
    if (!options.name.empty()) garment.name = options.name;
    return garment;
}

/// Accepts the end of a scale.
CLI::Validator most_validator()
{
    return CLI::Validator(
        [](std::string& text) {
            double most = 0;
            const char* const end = text.data() + text.size();
            const auto [last, failure] = std::from_chars(text.data(), end, most);
            const bool fits = failure == std::errc() && last == end && most > 0 && most <= 1e6;
            return fits ? std::string() : "This must be a number over 0, at most 1000000; given is \"" + text + "\".";
        },
        "NUMBER");
}

/// Name of the fabric that panels are cut from: the design's, or one of the library, which the design then gets. Throws Stop.
std::string fabric_in(Design& design, const std::string& asked)
{
    if (asked.empty() && !design.fabrics.empty()) return design.fabrics.front().name;
    if (find_fabric(design, asked) != nullptr) return asked;
    std::vector<std::string> names;
    for (const Fabric& fabric : design.fabrics) names.push_back(fabric.name);
    for (const Preset& preset : shipped_presets()) {
        if (asked.empty() || preset.fabric().name == asked) return design.fabrics[add_preset(design, preset)].name;
        names.push_back(preset.fabric().name);
    }
    throw Stop(exit_usage, fmt::format("--fabric {}: Neither the project nor the library has this fabric{} hygroloom-cli presets lists the "
                                       "library's.",
                                       asked, did_you_mean(asked, names)));
}

/// Adds the garment to a design, worn in an experiment of its own, with a fabric of the library where that has none.
std::string add_to(Design& design, const GarmentOptions& options, Garment& garment)
{
    garment.panels["*"].fabric = fabric_in(design, options.fabric);
    if (!garment.is_built_in()) {
        const fs::path folder = fs::absolute(options.output).parent_path();
        garment.source = fs::absolute(garment.source).lexically_normal().lexically_relative(folder.lexically_normal()).generic_string();
    }
    garment.name = free_name(garment.name, [&design](const std::string& name) { return find_garment(design, name) != nullptr; });
    design.garments.push_back(garment);
    WearExperiment wear;
    wear.garment = garment.name;
    wear.name = free_name("wear", [&design](const std::string& name) {
        return find_wear(design, name) != nullptr || find_experiment(design, name) != nullptr;
    });
    design.wears.push_back(wear);
    return wear.name;
}

Json json_of(const GarmentPattern& pattern)
{
    Json json{{"format", "hygroloom-garment"}, {"version", 1}, {"panels", Json::array()}};
    for (const PatternPanel& panel : pattern.panels)
        json["panels"].push_back({{"name", panel.name},
                                  {"area_m2", area_of(panel)},
                                  {"edges", panel.edges.size()},
                                  {"perimeter_mm", 1e3 * perimeter_of(panel)}});
    json["seams"] = pattern.seams.size();
    json["uv_scale"] = pattern.uv_scale;
    json["uv_scale_spread"] = pattern.uv_scale_spread;
    json["draped"] = pattern.is_draped;
    json["issues"] = pattern.issues;
    return json;
}

void print_pattern(const GarmentOptions& options, const Garment& garment, const GarmentPattern& pattern)
{
    print_result("{}: \"{}\"\n", options.file, garment.name);
    print_result("  {:<24} {:>9} {:>6} {:>12}\n", "panel", "area m2", "edges", "perimeter mm");
    double area = 0;
    for (const PatternPanel& panel : pattern.panels) {
        area += area_of(panel);
        print_result("  {:<24} {:>9} {:>6} {:>12}\n", panel.name, rounded_text(area_of(panel), 4), panel.edges.size(),
                     rounded_text(1e3 * perimeter_of(panel), 4));
    }
    print_result("  {:<24} {:>9}\n", "all", rounded_text(area, 4));
    print_result("  {} seams; {}.\n", pattern.seams.size(), pattern.is_draped ? "draped" : "flat, where its panels were placed");
    if (pattern.uv_scale > 0 && !garment.is_built_in())
        print_result("  A unit of the flat coordinates is {:.6g} mm{}.\n", 1e3 * pattern.uv_scale,
                     pattern.uv_scale_spread > 5e-5
                         ? fmt::format(", half of the cloth differs by over {:.2g} %", 100 * pattern.uv_scale_spread)
                         : "");
    if (!options.quiet)
        for (const std::string& issue : pattern.issues) print_result("  {}\n", issue);
}

int import_garment(const GarmentOptions& options)
{
    if (!options.output.empty() && fs::path(options.output).extension() != ".hygro")
        throw Stop(exit_usage, "-o " + options.output + ": The project's name must end in .hygro.");
    if (options.output.empty() && !options.fabric.empty()) throw Stop(exit_usage, "--fabric works with -o: it is for the project there.");
    Garment garment = garment_of(options);
    GarmentPattern pattern;
    Design design;
    std::optional<ChangeLock> lock;
    if (!options.output.empty()) lock.emplace(options.output);
    const bool existing = !options.output.empty() && fs::exists(options.output);
    try {
        pattern = read_pattern(garment, {});
        if (existing) design = read_project(options.output);
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
    std::vector<Issue> issues;
    std::string experiment;
    if (!options.output.empty()) {
        experiment = add_to(design, options, garment);
        const Place where = Place("garments") / (design.garments.size() - 1);
        for (const Issue& issue : validate(design))
            if (issue.where.is_in(where)) issues.push_back(issue);
        write_project(design, options.output);
    }
    if (options.json) {
        Json json = json_of(pattern);
        if (!options.output.empty())
            json.update({{"project", options.output}, {"garment", garment.name}, {"experiment", experiment}, {"added", existing}});
        print_json(json);
    } else {
        print_pattern(options, garment, pattern);
        if (!options.output.empty())
            print_result("{} {}, worn in the experiment \"{}\".\n", existing ? "Added to" : "Written to", options.output, experiment);
    }
    if (!options.quiet) print_in_short(options.output, issues, false);
    return exit_ok;
}

int act(GarmentOptions& options)
{
    if (!options.fabric.empty() && options.action != "import") throw Stop(exit_usage, "--fabric works with garment import.");
    if (!options.plan.sets.empty() && options.action != "plan") throw Stop(exit_usage, "--set works with garment plan.");
    static_cast<CommonOptions&>(options.plan) = static_cast<CommonOptions&>(options.map) = options;
    options.plan.project = options.map.recording = options.file;
    options.map.output = options.output;
    if (options.action == "plan") return plan_garment(options.plan);
    return options.action == "map" ? map_garment(options.map) : import_garment(options);
}

void add_map_options(CLI::App& verb, WearMapVerbOptions& map)
{
    verb.add_option("--time", map.time, "With map: time, s; the end when left out")->default_str("")->check(time_validator());
    verb.add_option("--cells", map.cells, "With map: crossings over which water is summed up each way, or auto: as computed");
    verb.add_option("--scale", map.scale, "With map: g/m2 alike for all fabrics, or share of what each fabric can hold")
        ->check(CLI::IsMember({"same", "capacity"}));
    verb.add_option("--most", map.most,
                    "With map: the scale's end, g/m2 or a share; next round number over the map's largest when left out")
        ->check(most_validator());
    verb.add_option(
            "--steps", map.steps,
            "With map: where the eight colours end, ascending, separated by commas, g/m2 or shares; even up to --most when left out")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->excludes("--most");
    verb.add_option(
            "--report", map.report,
            "With map: write a report (.html, .pdf, .txt or .json) with maps, tables, curves and what was assumed; -o may be left out")
        ->type_name("FILE");
    verb.add_option("--times", map.times,
                    "With --report: times of its maps, s, separated by commas; at each quarter of the run when left out")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(time_validator());
}

} // namespace

void add_garment(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<GarmentOptions>();
    CLI::App& garment_verb =
        *app.add_subcommand("garment", "Read a garment: a sewing pattern, a mesh with flat coordinates, or a built-in one");
    garment_verb.footer(
        "Example: hygroloom-cli garment import tee.json -o run.hygro\n"
        "`garment import FILE` prints panels, seams, scale and what was repaired; with -o the garment is added to a project.\n"
        "FILE is a pattern (.json), a mesh (.obj, .glb, .gltf, .fbx, .ply, .dae), or built-in:tee, built-in:singlet, "
        "built-in:leggings.\n"
        "`garment plan PROJECT --experiment E` says into how many cells a worn garment is cut, and what the run takes.\n"
        "`garment map RECORDING --time T -o FOLDER` writes the water map of a worn garment: pictures and textures of its panels, a table "
        "of cells, the cells for ParaView (VTP), OBJ and GLB; with --report one page of it all.");
    garment_verb.add_option("action", options->action, "What to do")->required()->check(CLI::IsMember({"import", "plan", "map"}));
    garment_verb.add_option("file", options->file, "File to read, or built-in:tee")->required()->type_name("FILE");
    garment_verb.add_option("-o,--output", options->output, "Project to write or to add to")->type_name("FILE");
    garment_verb.add_option("--name", options->name, "Name of the garment; the file's when left out");
    garment_verb.add_option("--uv-unit", options->uv_unit, "Unit of a mesh's flat coordinates")
        ->check(CLI::IsMember({"from_lengths", "mm", "cm", "m"}));
    garment_verb.add_option("--fabric", options->fabric,
                            "With import: fabric of the project or the library that its panels are cut from; the project's first when left "
                            "out");
    options->plan.takes_knobs = true;
    garment_verb.add_option("--set", options->plan.sets, "With plan: change a value for this call, e.g. experiments[0].duration_s=600")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    garment_verb.add_option("--experiment", options->plan.experiment, "With plan: experiment of the type wear; the only one when left out");
    garment_verb.add_option("--fidelity", options->plan.fidelity, "With plan: resolution")->type_name("{live,draft,standard,reference}");
    garment_verb.add_option("--cell-mm", options->plan.cell_mm, "With plan: sides of cells, mm; by fidelity when left out")
        ->check(CLI::Range(0.05, 100.0));
    add_map_options(garment_verb, options->map);
    add_common_options(garment_verb, *options);
    garment_verb.callback([&verb, options] { verb = [options] { return act(*options); }; });
}

} // namespace hygroloom
