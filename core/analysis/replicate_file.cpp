// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/replicate_file.h"

#include "core/analysis/trace_json.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "core/project/project_json.h"
#include "core/run/answers_code.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace hygroloom {
namespace {

constexpr const char* format_name = "hygroloom-replicates";
constexpr int newest_version = 1;
constexpr std::size_t most_bytes = std::size_t{64} << 20U;
constexpr std::size_t most_unknowns = 1000;

ProjectJson value_of(int number, const ReplicateRun& run)
{
    ProjectJson value;
    value["number"] = number;
    value["numbers"] = ProjectJson::object();
    for (const auto& [key, found] : run.numbers) value["numbers"][key] = found;
    value["places"] = run.places;
    if (run.edge_time) value["edge_s"] = *run.edge_time;
    if (run.trace && !run.trace->series.time.empty()) value["trace"] = trace_value(*run.trace);
    return value;
}

ProjectJson value_of(const ReplicateSet& set)
{
    ProjectJson value;
    value["answers"] = std::string(answers_code);
    value["fabric"] = set.key.fabric;
    value["experiment"] = set.key.experiment;
    value["fidelity"] = name_of(set.key.fidelity);
    value["seed"] = static_cast<double>(set.key.seed);
    value["of"] = set.key.of;
    value["unknowns"] = set.unknowns;
    value["runs"] = ProjectJson::array();
    for (const auto& [number, run] : set.runs) value["runs"].push_back(value_of(number, run));
    value["project"] = json_from_design(set.key.design);
    return value;
}

std::vector<double> places_in(ObjectReader& reader, std::size_t count)
{
    std::vector<double> places;
    for (const ProjectJson& each : array_in(reader.require("places"), reader.file(), reader.path_of("places"))) {
        places.push_back(number_in(each, reader.file(), reader.path_of("places")));
        if (!(places.back() >= 0 && places.back() <= 1)) reader.refuse("places", "a place lies between 0 and 1.");
    }
    if (places.size() != count) reader.refuse("places", "there must be one for each of the unknowns.");
    return places;
}

void read_run(const ProjectJson& value, const std::string& file, const std::string& path, ReplicateSet& set)
{
    ObjectReader reader(value, file, path);
    int number = -1;
    reader.read("number", number);
    if (number < 0 || number >= set.key.of) reader.refuse("number", fmt::format("allowed is 0 to {}.", set.key.of - 1));
    ReplicateRun run;
    const ProjectJson& numbers = reader.require("numbers");
    const std::string at = reader.path_of("numbers");
    if (!numbers.is_object()) reader.refuse("numbers", fmt::format("must be an object; given is {}.", in_words(numbers)));
    for (const auto& [key, found] : numbers.items()) run.numbers[key] = number_in(found, file, at + "." + key);
    run.places = places_in(reader, set.unknowns.size());
    reader.read("edge_s", run.edge_time);
    if (run.edge_time && !(*run.edge_time >= 0)) reader.refuse("edge_s", "a time is 0 or more.");
    if (const ProjectJson* trace = reader.find("trace")) // those of an older program have none
        run.trace = std::make_shared<const RunTrace>(trace_from(*trace, file, reader.path_of("trace")));
    reader.finish({"number"});
    if (!set.runs.emplace(number, std::move(run)).second) reader.refuse("number", "each may stand there once.");
}

/// The fabric and the experiment are those of the project inside, and nothing else is in it; beside a garment its linings may be.
void require_parts(const ReplicateSet& set, const ObjectReader& reader)
{
    const Design& design = set.key.design;
    if (design.wears.size() == 1) {
        if (design.wears.front().name != set.key.experiment || !design.experiments.empty())
            reader.refuse("project", "it must have the experiment, and no other.");
        if (!find_fabric(design, set.key.fabric) || !find_garment(design, design.wears.front().garment))
            reader.refuse("project", "it must have the fabric and the garment.");
        return;
    }
    if (design.fabrics.size() != 1 || design.fabrics.front().name != set.key.fabric)
        reader.refuse("project", "it must have the fabric, and no other.");
    if (design.experiments.size() != 1 || design.experiments.front().name != set.key.experiment)
        reader.refuse("project", "it must have the experiment, and no other.");
}

/// none: a program with another answers_code wrote it.
std::optional<ReplicateSet> set_from(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader reader(value, file, path);
    ReplicateSet set;
    std::string answers;
    reader.read("answers", answers);
    if (answers != answers_code) return {};
    std::string fidelity;
    double seed = 1;
    reader.read("fabric", set.key.fabric);
    reader.read("experiment", set.key.experiment);
    reader.read("fidelity", fidelity);
    reader.read("seed", seed);
    reader.read("of", set.key.of);
    if (std::none_of(std::begin(all_fidelities), std::end(all_fidelities), [&](Fidelity one) { return fidelity == name_of(one); }))
        reader.refuse("fidelity", "allowed are live, draft, standard and reference.");
    set.key.fidelity = fidelity_from_name(fidelity);
    if (!(seed >= 0 && seed <= 9e15)) reader.refuse("seed", "allowed is 0 to 9e15.");
    set.key.seed = static_cast<std::uint64_t>(seed);
    if (set.key.of < 2 || set.key.of > most_replicates) reader.refuse("of", fmt::format("allowed is 2 to {}.", most_replicates));
    set.key.design = design_from_json(reader.require("project"), file + ", " + reader.path_of("project"));
    require_parts(set, reader);
    for (const ProjectJson& name : array_in(reader.require("unknowns"), file, reader.path_of("unknowns")))
        set.unknowns.push_back(text_in(name, file, reader.path_of("unknowns")));
    if (set.unknowns.size() > most_unknowns) reader.refuse("unknowns", fmt::format("at most {} are allowed.", most_unknowns));
    const ProjectJson& runs = array_in(reader.require("runs"), file, reader.path_of("runs"));
    for (std::size_t i = 0; i < runs.size(); ++i) read_run(runs[i], file, fmt::format("{}[{}]", reader.path_of("runs"), i), set);
    reader.finish({"fabric", "experiment", "fidelity", "of"});
    return set;
}

} // namespace

Design part_of_run(const Design& design, const std::string& fabric, const std::string& experiment)
{
    Design part;
    part.materials = design.materials;
    part.fabrics.push_back(*find_fabric(design, fabric));
    part.experiments.push_back(*find_experiment(design, experiment));
    for (const Liquid& liquid : design.liquids)
        if (liquid.name == part.experiments.front().liquid) part.liquids.push_back(liquid);
    return part;
}

std::string format_replicates(const std::vector<ReplicateSet>& sets)
{
    ProjectJson file;
    file["format"] = format_name;
    file["version"] = newest_version;
    file["sets"] = ProjectJson::array();
    for (const ReplicateSet& set : sets) file["sets"].push_back(value_of(set));
    return text_from_json(file);
}

std::vector<ReplicateSet> parse_replicates(std::string_view text, const std::string& name)
{
    const ProjectJson file = parse_json(text, name);
    ObjectReader reader(file, name, "");
    std::string format;
    int version = 0;
    reader.read("format", format);
    reader.read("version", version);
    if (format != format_name) reader.refuse("format", fmt::format("must be \"{}\".", format_name));
    if (version != newest_version) reader.refuse("version", fmt::format("this program reads version {}.", newest_version));
    std::vector<ReplicateSet> sets;
    const ProjectJson& all = array_in(reader.require("sets"), name, "sets");
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const auto set = set_from(all[i], name, fmt::format("sets[{}]", i))) merge(sets, *set);
    reader.finish();
    return sets;
}

std::vector<ReplicateSet> read_replicates(const std::filesystem::path& path)
{
    std::error_code none;
    if (!std::filesystem::exists(path, none)) return {};
    return parse_replicates(read_file(path, most_bytes), path.string());
}

const ReplicateSet* find_set(const std::vector<ReplicateSet>& sets, const ReplicateKey& key)
{
    const auto found = std::find_if(sets.begin(), sets.end(), [&key](const ReplicateSet& set) { return set.key == key; });
    return found == sets.end() ? nullptr : &*found;
}

void merge(std::vector<ReplicateSet>& sets, const ReplicateSet& other)
{
    const auto found = std::find_if(sets.begin(), sets.end(), [&other](const ReplicateSet& set) { return set.key == other.key; });
    if (found == sets.end()) {
        sets.push_back(other);
        return;
    }
    if (found->unknowns == other.unknowns) {
        for (const auto& [number, run] : other.runs) found->runs.insert_or_assign(number, run);
    } else { // by another version of the program, which knew of other unknowns
        *found = other;
    }
    std::rotate(found, found + 1, sets.end());
}

void drop_older_traces(std::vector<ReplicateSet>& sets)
{
    std::size_t traces = 0;
    for (auto set = sets.rbegin(); set != sets.rend(); ++set)
        for (auto& [number, run] : set->runs)
            if (run.trace && ++traces > most_kept_traces) run.trace.reset();
}

std::vector<ReplicateSet> without_leftovers(std::vector<ReplicateSet> sets, const Design& design)
{
    std::erase_if(sets, [&design](const ReplicateSet& set) {
        return !find_fabric(design, set.key.fabric) ||
               !(find_experiment(design, set.key.experiment) || find_wear(design, set.key.experiment));
    });
    std::size_t kept = 0, runs = 0;
    for (auto set = sets.rbegin(); set != sets.rend(); ++set, ++kept) {
        runs += set->runs.size();
        if (kept > 0 && (kept == most_kept_sets || runs > most_kept_runs)) break;
    }
    sets.erase(sets.begin(), sets.end() - static_cast<std::ptrdiff_t>(kept));
    drop_older_traces(sets);
    return sets;
}

} // namespace hygroloom
