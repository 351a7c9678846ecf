// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Set-ups with known answers, run through a backend as a simulation would be: computed by the solver, expected from a closed form.
#pragma once

#include "core/sim/backend.h"

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace hygroloom {

/// What a case may be given; its unit is the end of its name. A word for the few that are no numbers.
struct VerifyParameter {
    std::string name;
    double value = 0;
    double smallest = 0;
    double largest = 0;
    std::string word; ///< not empty: the parameter is a word
};

struct VerifyResult {
    std::string name;
    double computed = 0;
    double expected = 0;
    double tolerance = 0; ///< of the difference, in the result's unit
    bool pass() const { return std::abs(computed - expected) <= tolerance; } ///< a NaN never passes
};

using VerifyValues = std::map<std::string, VerifyParameter>;

struct VerifyCase {
    std::string name;
    std::string about;
    std::vector<VerifyParameter> parameters; ///< with the public values
    std::function<std::vector<VerifyResult>(const VerifyValues&, Backend&)> run;
};

struct VerifyReport {
    std::string name;
    std::vector<VerifyParameter> parameters;
    std::vector<VerifyResult> results;
    double wall = 0; ///< s
    bool pass() const;
};

const std::vector<VerifyCase>& verify_cases();

/// Runs one case with some of its parameters changed. Throws Error naming the case, the parameter, its range and what was given.
VerifyReport run_verify_case(const std::string& name, const std::map<std::string, std::string>& changes, Backend& backend);

// The cases by subject; each file adds its own.
std::vector<VerifyCase> wicking_cases();
std::vector<VerifyCase> moisture_cases();
std::vector<VerifyCase> heat_cases();
std::vector<VerifyCase> laboratory_cases();
std::vector<VerifyCase> whole_run_cases();

} // namespace hygroloom
