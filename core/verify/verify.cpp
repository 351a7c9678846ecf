// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/verify.h"

#include "core/base/error.h"
#include "core/base/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>

namespace hygroloom {
namespace {

/// The allowed values of a parameter.
std::string range_in_words(const VerifyParameter& p)
{
    if (p.whole && p.smallest == 0 && p.largest == 1) return "0 or 1";
    return fmt::format("a {}number from {:g} to {:g}", p.whole ? "whole " : "", p.smallest, p.largest);
}

/// The number that a text gives for a parameter. Throws Error with what it may be.
double number_for(const VerifyParameter& p, const std::string& text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool allowed = error == std::errc() && end == text.data() + text.size() && value >= p.smallest && value <= p.largest;
    if (!allowed || (p.whole && value != std::floor(value)))
        throw Error(fmt::format("{}: must be {}; \"{}\" was given.", p.name, range_in_words(p), text));
    return value;
}

} // namespace

bool VerifyReport::pass() const
{
    return std::all_of(results.begin(), results.end(), [](const VerifyResult& r) { return r.pass(); });
}

bool VerifyReport::as_expected() const
{
    return std::all_of(results.begin(), results.end(), [](const VerifyResult& r) { return r.pass() || r.misses_as_known(); });
}

const std::vector<VerifyCase>& verify_cases()
{
    static const std::vector<VerifyCase> cases = [] {
        std::vector<VerifyCase> all;
        for (auto part : {wicking_cases(),        pore_cases(),       pore_flow_cases(),      retention_column_cases(),
                          pore_fabric_cases(),    morphology_cases(), moisture_cases(),       heat_cases(),
                          laboratory_cases(),     tester_cases(),     liquid_cases(),         cap_cases(),
                          yarn_drop_cases(),      cloth_cases(),      room_cases(),           sett_cases(),
                          section_cases(),        stain_cases(),      evenness_cases(),       finish_cases(),
                          convergence_cases(),    whole_run_cases(),  measured_fibre_cases(), measured_wicking_cases(),
                          measured_cloth_cases(), air_cases()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return cases;
}

std::vector<std::string> verify_names(const std::string& word)
{
    if (!word.empty() && word != "measured") return {word};
    std::vector<std::string> names;
    for (const VerifyCase& c : verify_cases())
        if (word.empty() || !c.source.empty()) names.push_back(c.name);
    return names;
}

VerifyReport run_verify_case(const std::string& name, const std::map<std::string, std::string>& changes, Backend& backend)
{
    const auto& cases = verify_cases();
    const auto found = std::find_if(cases.begin(), cases.end(), [&](const VerifyCase& c) { return c.name == name; });
    if (found == cases.end()) {
        const std::vector<std::string> names = verify_names({});
        throw Error(fmt::format("There is no case \"{}\"{} There are: {}.", name, did_you_mean(name, names), fmt::join(names, ", ")));
    }
    VerifyReport report{found->name, found->parameters, {}, 0, found->source, found->not_applicable};
    for (const auto& [key, text] : changes) {
        const std::string& wanted = key;
        const auto parameter =
            std::find_if(report.parameters.begin(), report.parameters.end(), [&](const VerifyParameter& p) { return p.name == wanted; });
        if (parameter == report.parameters.end()) {
            std::vector<std::string> names;
            for (const VerifyParameter& p : found->parameters) names.push_back(p.name);
            throw Error(fmt::format("The case {} has no parameter \"{}\"{} It has: {}.", name, key, did_you_mean(key, names),
                                    fmt::join(names, ", ")));
        }
        if (parameter->word.empty())
            parameter->value = number_for(*parameter, text);
        else
            parameter->word = text;
    }
    VerifyValues values;
    for (const VerifyParameter& p : report.parameters) values[p.name] = p;
    const auto start = std::chrono::steady_clock::now();
    if (found->run) report.results = found->run(values, backend);
    report.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

} // namespace hygroloom
