// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// verify: the built-in cases with known answers.
#include "app/cli.h"

#include "core/verify/verify.h"
#include "gpu/backends.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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

Json parameters_json(const std::vector<VerifyParameter>& parameters)
{
    Json json = Json::object();
    for (const VerifyParameter& p : parameters) json[p.name] = p.word.empty() ? Json(p.value) : Json(p.word);
    return json;
}

Json report_json(const VerifyReport& report)
{
    Json results = Json::array();
    for (const VerifyResult& r : report.results)
        results.push_back(
            {{"name", r.name}, {"computed", r.computed}, {"expected", r.expected}, {"tolerance", r.tolerance}, {"pass", r.pass()}});
    return {{"case", report.name}, {"parameters", parameters_json(report.parameters)}, {"results", results}, {"wall_s", report.wall}};
}

void print_report(const VerifyReport& report)
{
    fmt::print("{} ({:.2f} s)\n", report.name, report.wall);
    for (const VerifyResult& r : report.results)
        fmt::print("  {:<4} {:<24} computed {:<12.6g} expected {:<12.6g} tolerance {:.3g}\n", r.pass() ? "pass" : "FAIL", r.name,
                   r.computed, r.expected, r.tolerance);
}

int list_cases(const VerifyOptions& options)
{
    Json list = Json::array();
    for (const VerifyCase& c : verify_cases()) {
        list.push_back({{"case", c.name}, {"about", c.about}, {"parameters", parameters_json(c.parameters)}});
        if (!options.json) fmt::print("{:<26} {}\n", c.name, c.about);
    }
    if (options.json) fmt::print("{}\n", Json{{"cases", list}}.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return exit_ok;
}

int verify(const VerifyOptions& options)
{
    if (options.list) return list_cases(options);
    std::map<std::string, std::string> changes;
    for (const std::string& set : options.sets) {
        const std::size_t sign = set.find('=');
        if (sign == std::string::npos || sign == 0) throw Stop(exit_usage, "--set " + set + ": Give a name, =, and a value.");
        changes[set.substr(0, sign)] = set.substr(sign + 1);
    }
    if (options.name.empty() && !changes.empty()) throw Stop(exit_usage, "--set needs the name of one case.");
    std::unique_ptr<Backend> backend;
    try {
        backend = make_backend(options.backend);
    } catch (const DeviceError& error) {
        throw Stop(exit_no_device, error.what());
    } catch (const Error& error) {
        throw Stop(exit_usage, error.what());
    }
    backend->set_threads(options.threads);

    std::vector<std::string> names{options.name};
    if (options.name.empty()) {
        names.clear();
        for (const VerifyCase& c : verify_cases()) names.push_back(c.name);
    }
    bool pass = true;
    Json reports = Json::array();
    for (const std::string& name : names) {
        VerifyReport report;
        try {
            report = run_verify_case(name, changes, *backend);
        } catch (const DeviceError&) {
            throw;
        } catch (const Error& error) {
            throw Stop(exit_usage, error.what());
        }
        pass = pass && report.pass();
        if (options.json)
            reports.push_back(report_json(report));
        else
            print_report(report);
    }
    if (options.json)
        fmt::print("{}\n", options.name.empty() ? Json{{"reports", reports}}.dump(2)
                                                : reports[0].dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return pass ? exit_ok : exit_failed;
}

} // namespace

void add_verify(CLI::App& app, Verb& chosen)
{
    auto options = std::make_shared<VerifyOptions>();
    CLI::App& verb = *app.add_subcommand("verify", "Physics cases with known answers: computed, expected, tolerance, pass or fail");
    verb.footer("Example: hygroloom-cli verify washburn --set radius_um=20 --set contact_angle_deg=45 --json");
    verb.add_option("case", options->name, "Name of one case; all when left out");
    verb.add_flag("--list", options->list, "Only list the cases");
    verb.add_option("--set", options->sets, "Change a parameter of the case, e.g. radius_um=20")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    verb.add_option("--backend", options->backend, "auto, cpu or cuda");
    verb.add_option("--threads", options->threads, "Threads of the CPU; 0 for all")->check(CLI::Range(0, 1024));
    add_common_options(verb, *options);
    verb.callback([&chosen, options] { chosen = [options] { return verify(*options); }; });
}

} // namespace hygroloom
