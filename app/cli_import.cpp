// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// import: a weaving draft, a drawing or a picture as a fabric; and its way back, a fabric as a WIF file.
#include "app/cli.h"

#include "core/base/words.h"
#include "core/design/draft.h"
#include "core/project/atomic_file.h"
#include "core/project/draft_import.h"
#include "core/project/project_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

struct ImportOptions : CommonOptions {
    std::string draft;
    std::string output;
    std::string name;
    bool use_suggestions = false; ///< the default; older versions needed it
    bool no_suggestions = false;
};

Json suggestion_json(const Suggestion& suggestion, bool takes)
{
    if (!suggestion.value) return nullptr;
    Json json{{"value", *suggestion.value}, {"plausible", suggestion.plausible}, {"taken", takes && suggestion.plausible}};
    if (!suggestion.plausible) json["why"] = suggestion.why;
    return json;
}

Json import_json(const ImportOptions& options, const DraftImport& draft, bool takes, bool existing)
{
    const Fabric& fabric = draft.fabric;
    Json json{{"format", "hygroloom-import"}, {"version", 1}, {"file", options.draft}, {"fabric", fabric.name}};
    json["weave"] = {{"ends", fabric.weave.ends()}, {"picks", fabric.weave.picks()}, {"pattern", fabric.weave.pattern()}};
    if (const auto& plan = fabric.weave.draft())
        json["weave"].update({{"shafts", plan->shafts}, {"treadles", plan->treadles}, {"liftplan", !plan->liftplan.empty()}});
    json["extra_yarns"] = fabric.extra_yarns.size();
    json["suggestions"] = {{"ends_per_cm", suggestion_json(draft.ends_per_cm, takes)},
                           {"picks_per_cm", suggestion_json(draft.picks_per_cm, takes)},
                           {"warp_diameter_mm", suggestion_json(draft.warp_diameter_mm, takes)},
                           {"weft_diameter_mm", suggestion_json(draft.weft_diameter_mm, takes)}};
    json["report"] = Json::array();
    for (const ImportLine& line : draft.report)
        json["report"].push_back({{"severity", line.severity == Severity::note ? "note" : "warning"}, {"text", line.text}});
    if (!options.output.empty()) json.update({{"project", options.output}, {"added", existing}});
    return json;
}

int import_file(const ImportOptions& options)
{
    Design design;
    std::optional<ChangeLock> lock;
    if (!options.output.empty()) lock.emplace(options.output);
    const bool existing = !options.output.empty() && std::filesystem::exists(options.output);
    if (!options.output.empty() && std::filesystem::path(options.output).extension() != ".hygro")
        throw Stop(exit_usage, "-o " + options.output + ": The project's name must end in .hygro.");
    DraftImport draft;
    try {
        if (existing) design = read_project(options.output);
        draft = import_draft(options.draft, design);
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
    const bool takes = !options.no_suggestions && !draft.numbers_are_ours;
    if (takes) take_suggestions(draft);
    if (!options.name.empty()) draft.fabric.name = options.name;
    draft.fabric.name = free_name(draft.fabric.name, [&design](const std::string& name) { return find_fabric(design, name) != nullptr; });
    std::vector<Issue> issues;
    if (!options.output.empty()) {
        const Place where = Place("fabrics") / design.fabrics.size();
        design.fabrics.push_back(draft.fabric);
        for (const Issue& issue : validate(design))
            if (issue.where.is_in(where)) issues.push_back(issue);
        write_project(design, options.output);
    }
    if (options.json) {
        print_json(import_json(options, draft, takes, existing));
    } else {
        print_result("{}: \"{}\"\n", options.draft, draft.fabric.name);
        for (const ImportLine& line : draft.report)
            if (line.severity != Severity::note || !options.quiet)
                print_result("  {}{}\n", line.severity == Severity::note ? "" : "warning: ", line.text);
        if (!options.output.empty()) print_result("{} {}\n", existing ? "Added to" : "Written to", options.output);
    }
    if (!options.quiet) print_in_short(options.output, issues, false);
    return exit_ok;
}

} // namespace

int export_wif(const ProjectOptions& options, const std::string& output)
{
    const Design design = load_project(options);
    require_valid(design, options);
    const Fabric& fabric = chosen_fabric(design, options);
    write_wif(design, fabric, output);
    if (options.json)
        print_json(Json{{"format", "hygroloom-export"},
                        {"version", 1},
                        {"file", output},
                        {"ends", fabric.weave.ends()},
                        {"picks", fabric.weave.picks()}});
    else
        print_result("{}\n", output);
    return exit_ok;
}

void add_import(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<ImportOptions>();
    CLI::App& import_verb =
        *app.add_subcommand("import", "Read a weaving draft (WIF), a drawing of 0 and 1, or a picture (PNG, BMP) as a fabric");
    import_verb.footer("Example: hygroloom-cli import draft.wif -o woven.hygro\n"
                       "Prints what was understood and what was repaired. The fabric is added to an existing project.");
    import_verb.add_option("draft", options->draft, "File to read")->required()->type_name("FILE");
    import_verb.add_option("-o,--output", options->output, "Project to write or to add to")->type_name("FILE");
    import_verb.add_option("--name", options->name, "Name of the fabric; the draft's title when left out");
    import_verb.add_flag("--no-suggestions", options->no_suggestions,
                         "Ignore the sett and the yarn thickness of the draft, which are used where plausible");
    import_verb.add_flag("--use-suggestions", options->use_suggestions, "Use them where plausible (the default)")
        ->excludes("--no-suggestions");
    add_common_options(import_verb, *options);
    import_verb.callback([&verb, options] { verb = [options] { return import_file(*options); }; });
}

} // namespace hygroloom
