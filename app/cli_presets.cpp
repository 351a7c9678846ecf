// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// presets: the fabrics that ship with the program, as a list or as a project to begin with.
#include "app/cli.h"

#include "core/base/words.h"
#include "core/design/fitted_fabric.h"
#include "core/project/atomic_file.h"
#include "core/project/library.h"
#include "core/project/project_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

struct PresetOptions : CommonOptions {
    std::vector<std::string> names;
    std::vector<std::string> experiments; ///< types
    std::string output;
    std::string library;
    bool finishes = false;
};

int list_finishes(const PresetOptions& options)
{
    Json json = Json::array();
    for (const Finish& finish : finishes()) {
        json.push_back({{"name", finish.name}, {"contact_angle_deg", finish.contact_angle_deg}, {"note", finish.note}});
        if (!options.json) print_result("  {:<30} {:>4.0f} degrees  {}\n", finish.name, finish.contact_angle_deg, finish.note);
    }
    if (options.json)
        print_result("{}\n", Json{{"format", "hygroloom-finishes"}, {"version", 1}, {"finishes", json}}.dump(
                                 2, ' ', false, nlohmann::json::error_handler_t::replace));
    return exit_ok;
}

/// Weights: g/m2 of each.
int list_presets(const PresetOptions& options, const std::vector<Preset>& presets, const std::vector<double>& weights)
{
    Json json = Json::array();
    std::string group;
    for (std::size_t i = 0; i < presets.size(); ++i) {
        const Preset& preset = presets[i];
        const double weight = weights[i];
        json.push_back({{"name", preset.fabric().name}, {"group", preset.group}, {"note", preset.note}, {"areal_density_g_m2", weight}});
        if (options.json) continue;
        if (preset.group != group) print_result("{}\n", group = preset.group);
        print_result("  {:<20} {:>4.0f} g/m2  {}\n", preset.fabric().name, weight, preset.note);
    }
    if (options.json)
        print_result("{}\n", Json{{"format", "hygroloom-presets"}, {"version", 1}, {"presets", json}}.dump(
                                 2, ' ', false, nlohmann::json::error_handler_t::replace));
    return exit_ok;
}

/// Those of the shipped library, or of one's own.
std::vector<Preset> presets_of(const PresetOptions& options)
{
    if (options.library.empty()) return shipped_presets();
    if (!std::filesystem::exists(options.library)) throw Stop(exit_invalid, options.library + ": There is no such library.");
    try {
        return read_library(options.library);
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
}

std::vector<double> weights_of(const PresetOptions& options, const std::vector<Preset>& presets)
{
    std::vector<double> weights;
    for (const Preset& preset : presets) {
        const Validation found = validate_and_fit(preset.design);
        if (const Issue* error = first_error(found.issues))
            throw Stop(exit_invalid, fmt::format("{}: {}: {}", options.library, preset.fabric().name, error->text()));
        weights.push_back(found.fabrics.front()->derived.areal_density_g_m2);
    }
    return weights;
}

std::vector<std::string> add_fabrics(Design& design, const PresetOptions& options, const std::vector<Preset>& all)
{
    std::vector<std::string> added;
    for (const std::string& name : options.names) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Preset& preset) { return preset.fabric().name == name; });
        if (found == all.end()) {
            std::vector<std::string> names;
            names.reserve(all.size());
            for (const Preset& preset : all) names.push_back(preset.fabric().name);
            throw Stop(exit_usage, fmt::format("The library has no fabric \"{}\"{} There are: {}.", name, did_you_mean(name, names),
                                               fmt::join(names, ", ")));
        }
        added.push_back(design.fabrics[add_preset(design, *found)].name);
        if (added.back() != name && !options.quiet)
            print_note("{}: The fabric \"{}\" exists already; the new one is \"{}\".\n", options.output, name, added.back());
    }
    return added;
}

/// As the window names it: "one drop", "vertical wicking".
std::string usual_name(ExperimentType type)
{
    return type == ExperimentType::droplet ? "one drop" : CLI::detail::to_lower(info_of(type).title);
}

/// Of each type with the values of its standard.
std::vector<std::string> add_experiments(Design& design, const PresetOptions& options)
{
    std::vector<std::string> added;
    for (const std::string& key : options.experiments) {
        if (key == "wear")
            throw Stop(exit_usage, "--experiment wear: This is an experiment on a garment; hygroloom-cli garment import adds both.");
        std::vector<std::string> keys;
        int type = 0;
        for (; type < experiment_types && name_of(ExperimentType(type)) != key; ++type) keys.emplace_back(name_of(ExperimentType(type)));
        if (type == experiment_types)
            throw Stop(exit_usage, fmt::format("--experiment {}: There is no such type{} There are: {}.", key, did_you_mean(key, keys),
                                               fmt::join(keys, ", ")));
        Experiment experiment = standard_experiment(ExperimentType(type));
        experiment.name = free_name(usual_name(experiment.type), [&design](const std::string& name) {
            return find_experiment(design, name) != nullptr || find_wear(design, name) != nullptr;
        });
        added.push_back(experiment.name);
        design.experiments.push_back(std::move(experiment));
    }
    return added;
}

int write_presets(const PresetOptions& options, const std::vector<Preset>& all)
{
    if (std::filesystem::path(options.output).extension() != ".hygro")
        throw Stop(exit_usage, "-o " + options.output + ": The project's name must end in .hygro.");
    const ChangeLock lock(options.output);
    Design design;
    if (std::filesystem::exists(options.output)) design = read_project(options.output);
    const std::vector<std::string> fabrics = add_fabrics(design, options, all), experiments = add_experiments(design, options);
    write_project(design, options.output);
    if (options.json)
        print_json(Json{
            {"format", "hygroloom-presets"}, {"version", 1}, {"file", options.output}, {"fabrics", fabrics}, {"experiments", experiments}});
    else
        print_result("{}\n", options.output);
    return exit_ok;
}

int presets(const PresetOptions& options)
{
    if (options.finishes) return list_finishes(options);
    const std::vector<Preset> all = presets_of(options);
    const std::vector<double> weights = weights_of(options, all); // refuses a library with errors
    const bool adds = !options.names.empty() || !options.experiments.empty();
    if (adds != !options.output.empty())
        throw Stop(exit_usage, "Give both what to add (fabrics, --experiment) and a project (-o), or neither to list the fabrics.");
    return adds ? write_presets(options, all) : list_presets(options, all, weights);
}

} // namespace

void add_presets(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<PresetOptions>();
    CLI::App& presets_verb =
        *app.add_subcommand("presets", "List the shipped fabrics and finishes, or add fabrics and experiments to a project");
    presets_verb.footer("Example: hygroloom-cli presets \"Denim\" \"Textile F\" --experiment droplet -o cloth.hygro");
    add_common_options(presets_verb, *options);
    presets_verb.add_option("NAMES", options->names, "Fabrics to add to the project");
    presets_verb
        .add_option(
            "--experiment", options->experiments,
            "Experiment to add, by its type, such as droplet or drying, with the values of its standard. May be given several times")
        ->type_name("TYPE")
        ->allow_extra_args(false);
    presets_verb.add_option("-o,--output", options->output, "Project to write or to add to")->type_name("FILE");
    presets_verb.add_option("--library", options->library, "Your own library (.hygrolib) instead of the shipped one")->type_name("FILE");
    presets_verb.add_flag("--finishes", options->finishes, "List the finishes and their contact angles");
    presets_verb.callback([&verb, options] { verb = [options] { return presets(*options); }; });
}

} // namespace hygroloom
