// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// verify: the built-in cases with known answers.
#include "app/cli.h"

#include "core/verify/verify_json.h"
#include "gpu/backends.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

struct VerifyOptions : CommonOptions {
    std::string name;
    bool list = false;
    std::vector<std::string> sets;
    std::string backend = "auto";
    int threads = 0;
};

const char* word_for(const VerifyReport& report, const VerifyResult& r)
{
    if (r.pass()) return "pass";
    return r.misses_as_known() ? "miss" : report.source.empty() ? "FAIL" : "MISS";
}

void print_parts(const VerifyReport& report, const VerifyResult& r)
{
    std::string computed, expected;
    for (const VerifyPart& p : r.parts) {
        computed += fmt::format(" {}", p.computed);
        expected += fmt::format(" {}", p.expected);
    }
    print_result("  {:<4} {:<24} computed{}  expected{}\n", word_for(report, r), r.name, computed, expected);
}

void print_report(const VerifyReport& report)
{
    print_result("{} ({:.2f} s)\n", report.name, report.wall);
    if (!report.source.empty()) print_result("  compared with a measurement: {}\n", report.source);
    if (!report.not_applicable.empty()) print_result("  not applicable: {}\n", report.not_applicable);
    for (const VerifyResult& r : report.results) {
        if (!r.parts.empty()) {
            print_parts(report, r);
            continue;
        }
        const char* rule = r.rule == Rule::near ? "expected" : r.rule == Rule::at_most ? "at most" : "at least";
        print_result("  {:<4} {:<24} computed {:<12.6g} {:<8} {:<12.6g} tolerance {:.3g}\n", word_for(report, r), r.name, r.computed, rule,
                     r.expected, r.tolerance);
        if (r.blind) print_result("       blind: inputs that differ give the same\n");
        if (!r.known_miss.empty())
            print_result("       {} {:.3g}: {}\n", r.misses_as_known() ? "known miss, by at most" : "misses by more than the known",
                         r.miss_bound, r.known_miss);
    }
}

/// One line for all cases with known answers, one for all comparisons.
void print_summary(const std::vector<VerifyReport>& reports)
{
    int known = 0, passed = 0, compared = 0, held = 0, left_out = 0;
    std::string misses;
    for (const VerifyReport& report : reports) {
        if (!report.not_applicable.empty()) {
            ++left_out;
            continue;
        }
        (report.source.empty() ? known : compared) += 1;
        (report.source.empty() ? passed : held) += report.pass();
        for (const VerifyResult& r : report.results)
            if (!r.pass()) misses += fmt::format("\n  {} {}{}", report.name, r.name, r.misses_as_known() ? ", known: " + r.known_miss : "");
    }
    if (known > 0) print_result("{} of {} cases with known answers pass.\n", passed, known);
    if (compared > 0) print_result("{} of {} comparisons with measurements hold; {} do not apply.\n", held, compared, left_out);
    if (!misses.empty()) print_result("Misses:{}\n", misses);
}

int list_cases(const VerifyOptions& options)
{
    Json list = Json::array();
    for (const VerifyCase& c : verify_cases()) {
        Json entry{{"case", c.name}, {"about", c.about}, {"parameters", parameters_value(c.parameters)}};
        if (!c.source.empty()) entry["compared_with"] = c.source;
        if (!c.not_applicable.empty()) entry["not_applicable"] = c.not_applicable;
        list.push_back(entry);
        if (!options.json) print_result("{:<26} {}\n", c.name, c.about);
    }
    if (options.json) print_json(Json{{"cases", list}});
    return exit_ok;
}

int verify(const VerifyOptions& options)
{
    if (options.list) return list_cases(options);
    std::map<std::string, std::string> changes;
    for (const std::string& set : options.sets) {
        const std::size_t sign = set.find('=');
        if (sign == std::string::npos || sign == 0) throw Stop(exit_usage, "--set " + set + ": Write it as name=value.");
        changes[set.substr(0, sign)] = set.substr(sign + 1);
    }
    std::unique_ptr<Backend> backend;
    try {
        backend = make_backend(options.backend);
    } catch (const DeviceError& error) {
        throw Stop(exit_no_device, error.what());
    } catch (const Error& error) {
        throw Stop(exit_usage, error.what());
    }
    backend->set_threads(options.threads);

    const std::vector<std::string> names = verify_names(options.name);
    const bool several = names.size() > 1;
    if (several && !changes.empty()) throw Stop(exit_usage, "--set works with one case; name it.");
    std::vector<VerifyReport> reports;
    for (const std::string& name : names) {
        try {
            reports.push_back(run_verify_case(name, changes, *backend));
        } catch (const DeviceError&) {
            throw;
        } catch (const Error& error) {
            throw Stop(exit_usage, error.what());
        }
        if (!options.json) print_report(reports.back());
        flush_results();
    }
    if (options.json) {
        Json all = Json::array();
        for (const VerifyReport& report : reports) all.push_back(report_value(report));
        print_json((several ? Json{{"reports", all}} : all[0]));
    } else if (several) {
        print_summary(reports);
    }
    return std::all_of(reports.begin(), reports.end(), [](const VerifyReport& r) { return r.as_expected(); }) ? exit_ok : exit_failed;
}

} // namespace

void add_verify(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<VerifyOptions>();
    CLI::App& verb = *app.add_subcommand("verify", "Run physics cases with known answers: computed, expected, tolerance, pass or fail");
    verb.footer("Example: hygroloom-cli verify washburn --set radius_um=20 --set contact_angle_deg=45 --json");
    verb.add_option("case", options->name,
                    "One case by name, or \"measured\" for all comparisons with measurements; all cases when left out");
    verb.add_flag("--list", options->list, "List the cases");
    verb.add_option("--set", options->sets, "Change a parameter of the case, e.g. radius_um=20")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    verb.add_option("--backend", options->backend, "Backend: auto, cpu or cuda")->type_name("{auto,cpu,cuda}");
    verb.add_option("--threads", options->threads, "CPU threads; 0: all")->check(CLI::Range(0, 1024));
    add_common_options(verb, *options);
    verb.callback([&chosen, options] { chosen = [options] { return verify(*options); }; });
}

} // namespace hygroloom
