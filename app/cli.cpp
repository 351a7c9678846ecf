// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// hygroloom-cli: one verb per task. Results go to stdout, everything else to stderr.
#include "app/cli.h"
#include "app/cli_interrupt.h"
#include "app/cli_usage.h"

#include "core/base/utf8.h"
#include "core/base/version.h"
#include "core/base/words.h"
#include "core/design/wear.h"
#include "core/project/project_file.h"
#include "core/room/kept_tables.h"
#include "core/run/learned_times.h"
#include "core/run/recording.h"
#include "gpu/backends.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace hygroloom {

void add_common_options(CLI::App& verb, CommonOptions& options)
{
    verb.add_flag("--json", options.json, "Print one JSON object on stdout");
    verb.add_flag("-q,--quiet", options.quiet, "No progress bar, no notes");
}

void add_project_options(CLI::App& verb, ProjectOptions& options, bool with_experiment)
{
    verb.add_option("project", options.project, "Project file (.hygro)")->required()->type_name("FILE");
    verb.add_option("--fabric", options.fabric, "Fabric by name; needed when the project has several");
    if (with_experiment) verb.add_option("--experiment", options.experiment, "Experiment by name; needed when the project has several");
    verb.add_option("--set", options.sets, "Change a value for this call, e.g. fabrics[0].contact_angle_deg=60. May be given several times")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    add_common_options(verb, options);
}

CLI::Validator seed_validator()
{
    return CLI::Validator(
        [](std::string& text) {
            std::uint64_t seed = 0;
            const char* const end = text.data() + text.size();
            const auto [last, failure] = std::from_chars(text.data(), end, seed);
            const bool fits = failure == std::errc() && last == end;
            return fits ? std::string() : "This must be a whole number from 0 to 18446744073709551615; given is \"" + text + "\".";
        },
        "");
}

CLI::Validator time_validator()
{
    return CLI::Validator(
        [](std::string& text) {
            double seconds = -1;
            const char* const end = text.data() + text.size();
            const auto [last, failure] = std::from_chars(text.data(), end, seconds);
            const bool number = failure == std::errc() && last == end && std::isfinite(seconds);
            return number && seconds >= 0 ? std::string() : "This must be a time in seconds, 0 or more; given is \"" + text + "\".";
        },
        "SECONDS");
}

int frame_at(const Recording& recording, const std::string& file, double time)
{
    const std::vector<Ledger>& ledgers = recording.ledgers();
    const auto last = static_cast<std::size_t>(recording.frames() - 1);
    if (time < 0) return static_cast<int>(last);
    const double end = ledgers[last].time, interval = last > 0 ? end - ledgers[last - 1].time : 0;
    if (time > end + interval)
        print_note("{}: warning: The recording ends at {:.4g} s, before {:.4g} s; its last frame is used.\n", file, end, time);
    std::size_t nearest = 0;
    for (std::size_t i = 1; i <= last; ++i)
        if (std::abs(ledgers[i].time - time) < std::abs(ledgers[nearest].time - time)) nearest = i;
    return static_cast<int>(nearest);
}

namespace {

constexpr std::string_view knob_prefix = "fidelity.";

/// The two sides of "path=value".
std::pair<std::string, std::string> path_and_value(const std::string& set)
{
    const std::size_t sign = set.find('=');
    if (sign == std::string::npos || sign == 0) throw Stop(exit_usage, "--set " + set + ": Write it as path=value.");
    return {set.substr(0, sign), set.substr(sign + 1)};
}

} // namespace

Design load_project(const ProjectOptions& options)
{
    Design design;
    try {
        design = read_project(options.project);
    } catch (const FileError& error) {
        throw Stop(exit_invalid, error.what());
    }
    for (const std::string& set : options.sets) {
        const auto [path, value] = path_and_value(set);
        if (path.starts_with(knob_prefix)) {
            if (options.takes_knobs) continue;
            throw Stop(exit_usage,
                       "--set " + set +
                           ": This verb runs no simulation and has no knobs. Set knobs with plan, simulate, compare or tradeoff.");
        }
        try {
            design = with_value(design, path, value);
        } catch (const Error& error) {
            throw Stop(exit_usage, error.what());
        }
    }
    return design;
}

KnobSettings knob_settings(const ProjectOptions& options)
{
    KnobSettings settings;
    for (const std::string& set : options.sets) {
        const auto [path, value] = path_and_value(set);
        if (!path.starts_with(knob_prefix)) continue;
        try {
            set_knob(settings, path.substr(knob_prefix.size()), value);
        } catch (const Error& error) {
            throw Stop(exit_usage, error.what());
        }
    }
    return settings;
}

std::string knob_help()
{
    std::string text = "Knobs: numbers that --fidelity sets. Change one with --set fidelity.<knob>=value. At live, draft, standard and "
                       "reference they are\n";
    for (const KnobInfo& knob : knob_table())
        text += fmt::format("  {:<22} {}{}{}; {}\n", knob.name, values_of(knob), *knob.unit ? " " : "", knob.unit, knob.meaning);
    return text;
}

void print_issue(const std::string& file, const Issue& issue)
{
    constexpr const char* severities[] = {"note", "warning", "error"};
    print_note("{}: {}: {}: {}\n", file, in_one_line(issue.where.text()), severities[static_cast<int>(issue.severity)],
               in_one_line(issue.text()));
}

void print_in_short(const std::string& file, const std::vector<Issue>& issues, bool quiet)
{
    std::size_t warnings = 0;
    for (const Issue& issue : issues) {
        if (issue.severity == Severity::error) print_issue(file, issue);
        if (issue.severity == Severity::warning) ++warnings;
    }
    if (warnings == 1 && !quiet) print_note("1 warning; see hygroloom-cli check {}.\n", file);
    if (warnings > 1 && !quiet) print_note("{} warnings; see hygroloom-cli check {}.\n", warnings, file);
}

LastWords failure_words(bool json, ExitCode code, const std::string& sentence)
{
    const nlohmann::ordered_json object{{"error", sentence}, {"exit_code", int(code)}};
    return {sentence + "\n", json ? object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n" : std::string()};
}

FittedFabrics require_valid(const Design& design, const ProjectOptions& options)
{
    Validation found = validate_and_fit(design);
    print_in_short(options.project, found.issues, options.quiet);
    if (has_error(found.issues)) throw Stop(exit_invalid, options.project + ": The project has errors; nothing was computed.");
    return std::move(found.fabrics);
}

namespace {

/// hint: what to do where there is none.
template <typename Item> const Item& chosen(const std::vector<Item>& items, const std::string& name, const char* what, const char* hint)
{
    for (const Item& item : items)
        if (item.name == name || (name.empty() && items.size() == 1)) return item;
    const std::vector<std::string> known = names_in(items);
    const std::string names = listed_in_quotes(known);
    if (items.empty()) throw Stop(exit_usage, fmt::format("The project has no {}. {}", what, hint));
    if (name.empty()) throw Stop(exit_usage, fmt::format("The project has several {}s; choose one with --{}: {}.", what, what, names));
    throw Stop(exit_usage, fmt::format("The project has no {} \"{}\"{} It has {}.", what, name, did_you_mean(name, known), names));
}

struct DevicesOptions : CommonOptions {};

int devices(const DevicesOptions& options)
{
    const std::vector<BackendInfo> backends = find_backends();
    if (options.json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const BackendInfo& info : backends) {
            list.push_back({{"backend", info.name}, {"device", info.device}, {"usable", info.usable}});
            if (!info.usable) list.back()["reason"] = info.reason;
        }
        print_json(nlohmann::ordered_json{{"devices", list}});
        return exit_ok;
    }
    for (const BackendInfo& info : backends)
        print_result("{:<5} {:<10} {}\n", info.name, info.usable ? "usable" : "not usable",
                     info.usable ? info.device : (info.device.empty() ? "" : info.device + ": ") + info.reason);
    return exit_ok;
}

/// "--set a=1 b=2" becomes "--set=a=1 --set=b=2", so that the project's name after it is not read as a value.
std::vector<std::string> arguments(int count, char** values)
{
    std::vector<std::string> given;
    for (int i = 1; i < count; ++i) {
        if (std::string(values[i]) != "--set") {
            given.emplace_back(values[i]);
            continue;
        }
        const int first = i + 1;
        while (i + 1 < count && values[i + 1][0] != '-' && (i + 1 == first || std::string(values[i + 1]).find('=') != std::string::npos))
            given.push_back(std::string("--set=") + values[++i]);
        if (i + 1 == first) given.emplace_back("--set");
    }
    return given;
}

int report_failure(bool json, ExitCode code, const std::string& sentence)
{
    const LastWords words = failure_words(json, code, sentence);
    write_note(words.note);
    if (json) write_result(words.result);
    return code;
}

/// After all others.
void add_help(CLI::App& app, Verb& chosen)
{
    CLI::App& verb = *app.add_subcommand("help", "The help on a verb, as VERB --help");
    verb.footer("Example: hygroloom-cli help simulate");
    auto words = std::make_shared<std::vector<std::string>>();
    verb.add_option("VERB", *words, "The verb; left out: all verbs")->default_str("");
    verb.callback([&chosen, &app, words] {
        chosen = [&app, words] {
            if (std::string fault = fault_of(app, *words); !fault.empty()) throw Stop(exit_usage, fault);
            print_result("{}", help_on(app, *words));
            return int{exit_ok};
        };
    });
}

int run(int count, char** values)
{
    CLI::App app("Simulates how woven fabric absorbs, spreads and loses water.", "hygroloom-cli");
    app.require_subcommand(1);
    app.set_version_flag("--version", fmt::format("Hygroloom {}, commit {}", program_version(), program_commit()));
    app.footer("Example: hygroloom-cli simulate cloth.hygro -o cloth.hygrorec\nHelp on a verb: hygroloom-cli help simulate");
    app.option_defaults()->always_capture_default();
    Verb verb;
    add_check(app, verb);
    add_plan(app, verb);
    add_simulate(app, verb);
    add_measure(app, verb);
    add_export(app, verb);
    add_import(app, verb);
    add_garment(app, verb);
    add_presets(app, verb);
    add_yarns(app, verb);
    add_devices(app, verb);
    add_compare(app, verb);
    add_card(app, verb);
    add_calibrate(app, verb);
    add_sweep(app, verb);
    add_tradeoff(app, verb);
    add_verify(app, verb);
    add_reference(app, verb);
    add_help(app, verb);

    const std::vector<std::string> given = arguments(count, values);
    const bool json = std::find(given.begin(), given.end(), "--json") != given.end();
    const auto refuse = [&](const std::string& sentence) {
        return report_failure(json, exit_usage, json ? sentence : sentence + "\n" + where_to_read(app, given));
    };
    if (const std::string fault = fault_of(app, given); !fault.empty()) return refuse(fault);
    try {
        std::vector<std::string> reversed(given.rbegin(), given.rend()); // as the library takes them
        app.parse(reversed);
    } catch (const CLI::ParseError& error) {
        if (const std::string fault = fault_of(app, error); !fault.empty()) return refuse(fault);
        if (json && error.get_exit_code() != 0) return report_failure(json, exit_usage, error.what());
        std::ostringstream results, notes;
        const int code = app.exit(error, results, notes);
        write_note(notes.str());
        write_result(results.str());
        return code == 0 ? exit_ok : exit_usage;
    }
    try {
        return verb();
    } catch (const Stop& stop) {
        return report_failure(json, stop.code, stop.what());
    } catch (const std::bad_alloc&) {
        return report_failure(json, exit_failed, "Out of memory; use a smaller sample or a lower fidelity.");
    } catch (const std::exception& error) {
        return report_failure(json, exit_failed, error.what());
    }
}

} // namespace

const Fabric& chosen_fabric(const Design& design, const ProjectOptions& options)
{
    return chosen(design.fabrics, options.fabric, "fabric",
                  "hygroloom-cli presets lists fabrics to begin with; in the window: Fabric, Add Fabric.");
}

namespace {

template <typename Item> std::vector<std::string> names_of(const std::vector<Item>& items)
{
    std::vector<std::string> names;
    for (const Item& item : items) names.push_back(item.name);
    return names;
}

/// That an experiment is on a garment, and which verbs take it.
Stop of_garment(const std::string& subject, const std::string& name)
{
    return {exit_usage, fmt::format("{0} on a garment (type wear), not on a sample of fabric: hygroloom-cli simulate runs it, "
                                    "hygroloom-cli garment plan says what it takes; both with --experiment \"{1}\".",
                                    subject, name)};
}

} // namespace

const Experiment& chosen_experiment(const Design& design, const ProjectOptions& options)
{
    if (find_wear(design, options.experiment) != nullptr)
        throw of_garment("The experiment \"" + options.experiment + "\" is one", options.experiment);
    if (!design.wears.empty() && !options.experiment.empty() && find_experiment(design, options.experiment) == nullptr) {
        std::vector<std::string> names = names_of(design.experiments);
        const std::string samples = names.empty() ? "" : fmt::format("\"{}\" on a sample of fabric and ", fmt::join(names, "\", \""));
        const std::vector<std::string> worn = names_of(design.wears);
        names.insert(names.end(), worn.begin(), worn.end());
        throw Stop(exit_usage, fmt::format("The project has no experiment \"{}\"{} It has {}\"{}\" on a garment.", options.experiment,
                                           did_you_mean(options.experiment, names), samples, fmt::join(worn, "\", \"")));
    }
    if (design.experiments.empty() && !design.wears.empty())
        throw of_garment("The project's only experiments are", design.wears.front().name);
    if (options.experiment.empty() && design.experiments.size() > 1 && !design.wears.empty())
        throw Stop(exit_usage, fmt::format("The project has several experiments; choose one with --experiment: \"{}\" on a sample of "
                                           "fabric, or \"{}\" on a garment, which takes no --fabric.",
                                           fmt::join(names_of(design.experiments), "\", \""), fmt::join(names_of(design.wears), "\", \"")));
    return chosen(design.experiments, options.experiment, "experiment",
                  "hygroloom-cli presets --experiment droplet -o PROJECT adds one; in the window: Experiment, Add Experiment.");
}

void add_devices(CLI::App& app, Verb& verb)
{
    auto options = std::make_shared<DevicesOptions>();
    CLI::App& devices_verb = *app.add_subcommand("devices", "List the backends and GPUs, and why one cannot be used");
    devices_verb.footer("Example: hygroloom-cli devices --json");
    add_common_options(devices_verb, *options);
    devices_verb.callback([&verb, options] { verb = [options] { return devices(*options); }; });
}

} // namespace hygroloom

int main(int count, char** values) // NOLINT(bugprone-exception-escape): where memory for the start is missing, the program ends
{
    hygroloom::prepare_streams();
    hygroloom::keep_learned_times(hygroloom::usual_learned_times());
    hygroloom::keep_tables_in(hygroloom::usual_kept_tables());
    int code = hygroloom::exit_failed;
    try {
        code = hygroloom::run(count, values);
    } catch (const hygroloom::ResultsLost&) {
        // said below
    }
    return hygroloom::results_are_written() || code != hygroloom::exit_ok ? code : hygroloom::exit_failed;
}
