// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Set-ups with known answers, run through a backend like a simulation: computed by the solver, expected from a closed form.
#pragma once

#include "core/solver/backend.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace hygroloom {

/// A parameter of a case; its name ends in its unit. A few are words.
struct VerifyParameter {
    std::string name;
    double value = 0;
    double smallest = 0;
    double largest = 0;
    std::string word;   ///< not empty: the parameter is a word
    bool whole = false; ///< only whole numbers count; from 0 to 1: a switch
};

inline VerifyParameter whole_number(const std::string& name, double value, double smallest, double largest)
{
    return {name, value, smallest, largest, "", true};
}
inline VerifyParameter on_or_off(const std::string& name, bool on) { return whole_number(name, on, 0, 1); }

/// How a computed value is compared with the expected one.
enum class Rule { near, at_most, at_least };

/// One whole number of a result that has several, such as a grade.
struct VerifyPart {
    std::string name;
    int computed = 0;
    int expected = 0;
};

struct VerifyResult {
    std::string name;
    double computed = 0;
    double expected = 0;
    double tolerance = 0; ///< of the difference, in the result's unit
    Rule rule = Rule::near;
    std::string known_miss = {};        ///< why it is known not to hold; empty: it must hold
    std::vector<VerifyPart> parts = {}; ///< not empty: the result is these, each of which must be as expected
    bool blind = false;                 ///< inputs that differ gave the same: nothing is shown, whatever the rule says
    double miss_bound = 0;              ///< by how much a known miss may miss what is expected, in the result's unit
    bool known_blind = false;           ///< as is known of it
    bool pass() const                   ///< a NaN never passes
    {
        if (blind) return false;
        if (!parts.empty()) return std::ranges::all_of(parts, [](const VerifyPart& p) { return p.computed == p.expected; });
        if (rule == Rule::at_most) return computed <= expected + tolerance;
        if (rule == Rule::at_least) return computed >= expected - tolerance;
        return std::abs(computed - expected) <= tolerance;
    }
    /// Whether it misses by what is known of it: neither by more nor blindly. A NaN never does.
    bool misses_as_known() const { return !known_miss.empty() && (!blind || known_blind) && std::abs(computed - expected) <= miss_bound; }
};

using VerifyValues = std::map<std::string, VerifyParameter>;
inline double value(const VerifyValues& values, const std::string& name) { return values.at(name).value; }

struct VerifyCase {
    std::string name;
    std::string about;
    std::vector<VerifyParameter> parameters; ///< with the public values
    std::function<std::vector<VerifyResult>(const VerifyValues&, Backend&)> run;
    std::string source = {};         ///< of the measurements a comparison is made with; empty: the case has a known answer
    std::string not_applicable = {}; ///< why a comparison cannot be made: it has no results
};

struct VerifyReport {
    std::string name;
    std::vector<VerifyParameter> parameters;
    std::vector<VerifyResult> results;
    double wall = 0; ///< s
    std::string source = {};
    std::string not_applicable = {};
    bool pass() const;        ///< every result holds
    bool as_expected() const; ///< every result holds or misses as is known
};

const std::vector<VerifyCase>& verify_cases();

/// The cases that a word of the command line means: "" all, "measured" every comparison with measurements, else the one of that name.
std::vector<std::string> verify_names(const std::string& word);

/// Runs one case with some of its parameters changed. Throws Error naming the case, the parameter, its range and what was given.
VerifyReport run_verify_case(const std::string& name, const std::map<std::string, std::string>& changes, Backend& backend);

// The cases by subject; each file adds its own.
std::vector<VerifyCase> wicking_cases();
std::vector<VerifyCase> pore_cases();
std::vector<VerifyCase> pore_flow_cases();
std::vector<VerifyCase> retention_column_cases();
std::vector<VerifyCase> pore_fabric_cases();
std::vector<VerifyCase> morphology_cases();
std::vector<VerifyCase> moisture_cases();
std::vector<VerifyCase> heat_cases();
std::vector<VerifyCase> laboratory_cases();
std::vector<VerifyCase> tester_cases();
std::vector<VerifyCase> liquid_cases();
std::vector<VerifyCase> cap_cases();
std::vector<VerifyCase> yarn_drop_cases();
std::vector<VerifyCase> cloth_cases();
std::vector<VerifyCase> sett_cases();
std::vector<VerifyCase> section_cases();
std::vector<VerifyCase> stain_cases();
std::vector<VerifyCase> room_cases();
std::vector<VerifyCase> evenness_cases();
std::vector<VerifyCase> finish_cases();
std::vector<VerifyCase> whole_run_cases();
std::vector<VerifyCase> convergence_cases();
std::vector<VerifyCase> measured_fibre_cases();
std::vector<VerifyCase> measured_wicking_cases();
std::vector<VerifyCase> measured_cloth_cases();
std::vector<VerifyCase> air_cases();

} // namespace hygroloom
