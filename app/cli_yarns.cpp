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

#include <filesystem>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

struct YarnOptions : CommonOptions {
    std::string library;
    std::string read, write; ///< tables
    std::string project, where_used, by;
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

/// The project's fabrics that have a yarn of the library; with another in its place where that was asked for.
int use(const YarnOptions& options, const std::vector<LibraryYarn>& yarns)
{
    const LibraryYarn& yarn = named(yarns, options.where_used);
    const ChangeLock lock(options.project);
    Design design = read_project(options.project);
    const std::vector<std::string> fabrics = fabrics_with(design, yarn.yarn());
    const bool replaces = !options.by.empty() && replace_yarn(design, yarn.yarn(), named(yarns, options.by)) > 0;
    if (replaces) {
        const std::vector<Issue> issues = validate(design);
        if (const Issue* error = first_error(issues))
            throw Stop(exit_invalid, fmt::format("{}: Nothing was replaced, as the project would not be valid: {}: {}", options.project,
                                                 error->where.text(), error->text()));
        write_project(design, options.project);
    }
    if (options.json)
        print_json(Json{{"format", "hygroloom-yarns"}, {"version", 1}, {"fabrics", fabrics}, {"replaced", replaces}});
    else if (fabrics.empty())
        print_result("No fabric of the project has this yarn: its fibres, count, twist and plies must be the same.\n");
    else
        for (const std::string& fabric : fabrics) print_result("{}\n", fabric);
    return exit_ok;
}

int list(const YarnOptions& options, const std::vector<LibraryYarn>& yarns)
{
    Json json = Json::array();
    for (const LibraryYarn& yarn : yarns) {
        json.push_back({{"name", yarn.name}, {"supplier", yarn.supplier}, {"currency", yarn.currency}});
        if (!options.json) print_result("  {:<30} {}\n", yarn.name, yarn.supplier);
    }
    if (options.json) print_json(Json{{"format", "hygroloom-yarns"}, {"version", 1}, {"yarns", json}});
    return exit_ok;
}

int yarns(const YarnOptions& options)
{
    if (options.where_used.empty() != options.project.empty())
        throw Stop(exit_usage, "--where-used names a yarn of the library, and --project where to look for it; give both.");
    if (!options.by.empty() && options.where_used.empty()) throw Stop(exit_usage, "--by goes with --where-used.");
    if (options.read.empty() && !std::filesystem::exists(options.library))
        throw Stop(exit_invalid, options.library + ": There is no such library.");
    std::vector<LibraryYarn> known;
    try {
        known = read_yarns(options.library);
        if (!options.read.empty()) {
            for (LibraryYarn& yarn : yarns_of_csv(read_file(options.read, std::size_t{16} << 20U), options.read, known))
                keep_yarn(known, std::move(yarn));
            write_yarns(known, options.library);
        }
    } catch (const Error& error) {
        throw Stop(exit_invalid, error.what());
    }
    if (!options.write.empty()) write_file(options.write, csv_of_yarns(known));
    return options.where_used.empty() ? list(options, known) : use(options, known);
}

} // namespace

void add_yarns(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<YarnOptions>();
    CLI::App& yarns_verb =
        *app.add_subcommand("yarns", "List the yarns of your library, as tables too; replace one in a project's fabrics");
    yarns_verb.footer(
        "Example: hygroloom-cli yarns own.hygrolib --read yarns.csv\n"
        "Replace a yarn in all fabrics: hygroloom-cli yarns own.hygrolib --project cloth.hygro --where-used \"Ne 40\" --by \"Ne 36\"");
    add_common_options(yarns_verb, *options);
    yarns_verb.add_option("library", options->library, "Your own library (.hygrolib)")->required()->type_name("FILE");
    yarns_verb.add_option("--read", options->read, "Add the yarns of a table (.csv), a row each; those of the same name are replaced")
        ->type_name("FILE");
    yarns_verb.add_option("--write", options->write, "Write all yarns as a table (.csv)")->type_name("FILE");
    yarns_verb.add_option("--project", options->project, "Project to look into")->type_name("FILE");
    yarns_verb.add_option("--where-used", options->where_used,
                          "List the project's fabrics that have this yarn, whatever its colour and price");
    yarns_verb.add_option("--by", options->by, "Put this yarn in its place in all of them, and save the project; colours stay");
    yarns_verb.callback([&verb, options] { verb = [options] { return yarns(*options); }; });
}

} // namespace hygroloom
