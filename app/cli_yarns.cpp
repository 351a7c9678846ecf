// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// yarns: the yarns of one's own library, as a list or a table; and the same yarn in all fabrics of a project.
#include "app/cli.h"

#include "core/base/words.h"
#include "core/design/validate.h"
#include "core/project/atomic_file.h"
#include "core/project/library.h"
#include "core/project/project_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

struct YarnOptions : CommonOptions {
    std::string library;
    std::string read, write; ///< tables
    std::string project, where_used, by;
    bool update = false;
};

/// Throws Stop.
const LibraryYarn& named(const std::vector<LibraryYarn>& yarns, const std::string& name)
{
    std::vector<std::string> names;
    for (const LibraryYarn& yarn : yarns) {
        if (yarn.name == name) return yarn;
        names.push_back(yarn.name);
    }
    throw Stop(exit_usage, fmt::format("The library has no yarn \"{}\"{} There are: {}.", name, did_you_mean(name, names),
                                       names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

/// Throws Stop where the project was not valid before or is not now, and leaves its file.
void write_if_valid(const Design& design, const Design& before, const std::string& project, const char* nothing)
{
    const std::vector<Issue> old = validate(before), issues = validate(design);
    const Issue *was = first_error(old), *error = first_error(issues);
    if (was || error)
        throw Stop(exit_invalid,
                   fmt::format("{}: {}, as the project {}: {}: {}", project, nothing, was ? "is not valid as it is" : "would not be valid",
                               (was ? was : error)->where.text(), (was ? was : error)->text()));
    write_project(design, project);
}

Json json_of(const YarnUpdate& update)
{
    Json changes = Json::array();
    for (const YarnChange& change : update.changes)
        changes.push_back({{"field", change.key}, {"before", change.before}, {"after", change.after}});
    return {{"fabric", update.fabric},
            {"yarn", update.key},
            {"library_yarn", update.library_yarn},
            {"in_library", !update.is_missing},
            {"changes", changes}};
}

std::string or_none(const std::string& text) { return text.empty() ? "not given" : text; }

void print_text(const YarnUpdate& update)
{
    print_result("{}: {}: {}{}\n", update.fabric, update.key, update.library_yarn,
                 update.is_missing ? ": The library has no such yarn." : "");
    for (const YarnChange& change : update.changes)
        print_result("  {}: {} -> {}\n", change.label, or_none(change.before), or_none(change.after));
}

/// The project's fabrics that have a yarn of the library; with another in its place where that was asked for.
int use(const YarnOptions& options, const std::vector<LibraryYarn>& yarns)
{
    const LibraryYarn& yarn = named(yarns, options.where_used);
    const ChangeLock lock(options.project);
    const Design before = read_project(options.project);
    Design design = before;
    const std::vector<std::string> fabrics = fabrics_with(design, yarn);
    std::vector<YarnUpdate> replaced;
    if (!options.by.empty()) replaced = replace_yarn(design, yarn, named(yarns, options.by));
    if (!replaced.empty()) write_if_valid(design, before, options.project, "Nothing was replaced");
    Json json = Json::array();
    for (const YarnUpdate& each : replaced) json.push_back(json_of(each));
    if (options.json)
        print_json(
            Json{{"format", "hygroloom-yarns"}, {"version", 1}, {"fabrics", fabrics}, {"replaced", !replaced.empty()}, {"updates", json}});
    else if (fabrics.empty())
        print_result("No fabric of the project has this yarn: its fibres, count, twist and plies must be the same.\n");
    else if (!replaced.empty())
        for (const YarnUpdate& each : replaced) print_text(each);
    else
        for (const std::string& fabric : fabrics) print_result("{}\n", fabric);
    return exit_ok;
}

/// The project's yarns that refer to the library's become as they are there.
int update(const YarnOptions& options, const std::vector<LibraryYarn>& yarns)
{
    const ChangeLock lock(options.project);
    const Design before = read_project(options.project);
    Design design = before;
    const std::vector<YarnUpdate> updates = update_yarns(design, yarns);
    const bool changed = std::any_of(updates.begin(), updates.end(), [](const YarnUpdate& each) { return !each.is_missing; });
    if (changed) write_if_valid(design, before, options.project, "Nothing was updated");
    Json json = Json::array();
    for (const YarnUpdate& each : updates) {
        json.push_back(json_of(each));
        if (!options.json) print_text(each);
    }
    if (options.json)
        print_json(Json{{"format", "hygroloom-yarns"}, {"version", 1}, {"updates", json}, {"updated", changed}});
    else if (updates.empty())
        print_result("No yarn changed: all that refer to the library are as they are there.\n");
    const auto missing = std::find_if(updates.begin(), updates.end(), [](const YarnUpdate& each) { return each.is_missing; });
    if (missing != updates.end() && options.json) return exit_invalid; // its "in_library" says so
    if (missing != updates.end())
        throw Stop(exit_invalid, fmt::format("{}: {}: {}: The library has no yarn \"{}\".", options.project, missing->fabric, missing->key,
                                             missing->library_yarn));
    return exit_ok;
}

int list(const YarnOptions& options, const std::vector<LibraryYarn>& yarns)
{
    Json json = Json::array();
    if (!options.json && !yarns.empty())
        print_result("  {:<30} {:<16} {:<30} {:>12}  {}\n", "name", "count", "fibres, %", "price a kg", "supplier");
    for (const LibraryYarn& yarn : yarns) {
        const std::string size = size_text(yarn.yarn()), fibres = fibres_text(yarn.yarn());
        const std::optional<double> price = yarn.yarn().price;
        json.push_back({{"name", yarn.name},
                        {"count", size},
                        {"fibres", fibres},
                        {"price", price ? Json(*price) : Json(nullptr)},
                        {"currency", yarn.currency},
                        {"supplier", yarn.supplier}});
        if (options.json) continue;
        const std::string costs = price ? fmt::format("{:g} {}", *price, yarn.currency) : std::string();
        print_result("  {:<30} {:<16} {:<30} {:>12}  {}\n", yarn.name, size, fibres, costs, yarn.supplier);
    }
    if (options.json) print_json(Json{{"format", "hygroloom-yarns"}, {"version", 1}, {"yarns", json}});
    return exit_ok;
}

/// The library's yarns, with those of the table that was given, which are kept in it.
std::vector<LibraryYarn> library_of(const YarnOptions& options)
{
    if (options.read.empty()) return read_yarns(options.library);
    const ChangeLock lock(options.library);
    std::vector<LibraryYarn> known = read_yarns(options.library);
    for (LibraryYarn& yarn : yarns_of_csv(read_file(options.read, std::size_t{16} << 20U), options.read, known))
        keep_yarn(known, std::move(yarn));
    write_yarns(known, options.library);
    return known;
}

/// Throws Stop where the table would be written over something else.
void require_table(const YarnOptions& options)
{
    const auto whole = [](const std::string& path) { return std::filesystem::weakly_canonical(std::filesystem::absolute(path)); };
    if (std::filesystem::path(options.write).extension() != ".csv")
        throw Stop(exit_usage, fmt::format("--write: A table's name must end in .csv; given is {}.", options.write));
    for (const std::string& other : {options.library, options.read, options.project})
        if (!other.empty() && whole(other) == whole(options.write))
            throw Stop(exit_usage, fmt::format("--write: The table would overwrite {}, which is read; name another file.", other));
}

int yarns(const YarnOptions& options)
{
    if (!options.write.empty()) require_table(options);
    const bool uses = !options.where_used.empty();
    if (uses && options.update) throw Stop(exit_usage, "--where-used and --update are two commands; give one of them.");
    if (options.project.empty() && uses)
        throw Stop(exit_usage, "--where-used names a yarn of the library, and --project where to look for it; give both.");
    if (options.project.empty() && options.update)
        throw Stop(exit_usage, "--update brings a project's yarns up to date; name the project with --project.");
    if (!options.project.empty() && !uses && !options.update) throw Stop(exit_usage, "--project goes with --where-used or --update.");
    if (!options.by.empty() && !uses) throw Stop(exit_usage, "--by goes with --where-used.");
    if (options.read.empty() && !std::filesystem::exists(options.library))
        throw Stop(exit_invalid, options.library + ": There is no such library.");
    std::vector<LibraryYarn> known;
    try {
        known = library_of(options);
    } catch (const Error& error) {
        throw Stop(exit_invalid, error.what());
    }
    if (!options.write.empty()) write_file(options.write, csv_of_yarns(known));
    return uses ? use(options, known) : options.update ? update(options, known) : list(options, known);
}

} // namespace

void add_yarns(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<YarnOptions>();
    CLI::App& yarns_verb =
        *app.add_subcommand("yarns", "List the yarns of your library, as tables too; replace or update them in a project's fabrics");
    yarns_verb.footer(
        "Example: hygroloom-cli yarns own.hygrolib --read yarns.csv\n"
        "Replace a yarn in all fabrics: hygroloom-cli yarns own.hygrolib --project cloth.hygro --where-used \"Ne 40\" --by \"Ne 36\"\n"
        "Bring a project's yarns up to date: hygroloom-cli yarns own.hygrolib --project cloth.hygro --update");
    add_common_options(yarns_verb, *options);
    yarns_verb.add_option("library", options->library, "Your own library (.hygrolib)")->required()->type_name("FILE");
    yarns_verb.add_option("--read", options->read, "Add the yarns of a table (.csv), a row each; those of the same name are replaced")
        ->type_name("FILE");
    yarns_verb.add_option("--write", options->write, "Write all yarns as a table (.csv)")->type_name("FILE");
    yarns_verb.add_option("--project", options->project, "Project to look into")->type_name("FILE");
    yarns_verb.add_option("--where-used", options->where_used,
                          "List the project's fabrics that have this yarn, whatever its colour and price");
    yarns_verb.add_option(
        "--by", options->by,
        "Put this yarn in its place in all of them, and save the project; colours stay. They refer to it then; with the same "
        "name they refer to the one they have");
    yarns_verb.add_flag("--update", options->update,
                        "Bring the project's yarns that refer to yarns of the library up to date with them, say what changed, and save the "
                        "project; colours stay");
    yarns_verb.callback([&verb, options] { verb = [options] { return yarns(*options); }; });
}

} // namespace hygroloom
