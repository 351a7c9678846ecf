// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the verbs of hygroloom-cli share: options, exit codes, loading a project and reporting problems.
#pragma once

#include "app/cli_print.h"

#include "core/base/error.h"
#include "core/design/validate.h"
#include "core/plan/fidelity.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hygroloom {

class Recording;
struct LastWords;

enum ExitCode { exit_ok = 0, exit_failed = 1, exit_usage = 2, exit_invalid = 3, exit_no_device = 4, exit_cancelled = 130 };

/// Ends the program with a code and a sentence on stderr.
struct Stop : Error {
    Stop(ExitCode exit_code, const std::string& sentence) : Error(sentence), code(exit_code) {}
    ExitCode code;
};

struct CommonOptions {
    bool json = false;  ///< one JSON object on stdout, nothing else there
    bool quiet = false; ///< no progress bar, no notes
};

struct ProjectOptions : CommonOptions {
    std::string project;
    std::string fabric;            ///< empty: the only one
    std::string experiment;        ///< empty: the only one
    std::vector<std::string> sets; ///< "path=value"
    bool takes_knobs = false;      ///< whether a path may be fidelity.<knob>
};

/// What the verb of the command line does; returns the exit code.
using Verb = std::function<int()>;

void add_common_options(CLI::App& verb, CommonOptions& options);
void add_project_options(CLI::App& verb, ProjectOptions& options, bool with_experiment);

/// Reads the project and applies --set, but for the knobs. Throws Stop.
Design load_project(const ProjectOptions& options);
/// The knobs set with --set fidelity.<knob>=value. Throws Stop.
KnobSettings knob_settings(const ProjectOptions& options);
/// For --help: each knob with its values and its meaning.
std::string knob_help();

/// On stderr as "file: path: severity: sentence".
void print_issue(const std::string& file, const Issue& issue);
/// Errors on stderr and, unless quiet, the number of warnings.
void print_in_short(const std::string& file, const std::vector<Issue>& issues, bool quiet);
/// Each fabric as its check fitted it, in the design's order.
using FittedFabrics = std::vector<std::shared_ptr<const FittedFabric>>;
/// What a failure is reported with.
LastWords failure_words(bool json, ExitCode code, const std::string& sentence);
/// Prints the design's issues in short. Throws Stop when one is an error.
FittedFabrics require_valid(const Design& design, const ProjectOptions& options);

/// The one of that name, or the only one without a name. Throws Stop with the names of the project.
const Fabric& chosen_fabric(const Design& design, const ProjectOptions& options);
const Experiment& chosen_experiment(const Design& design, const ProjectOptions& options);

/// The chosen fabric as a WIF file, for export.
int export_wif(const ProjectOptions& options, const std::string& output);

/// The frame nearest to a time (s), the last one when it is negative. Warns on stderr when the recording ends well before the time.
int frame_at(const Recording& recording, const std::string& file, double time);

/// Accepts a seed: a whole number that is not negative and fits.
CLI::Validator seed_validator();

/// Accepts a time: a number of seconds, not negative.
CLI::Validator time_validator();

/// Each adds its verb to the program. chosen is set when the command line names the verb.
void add_check(CLI::App& app, Verb& chosen);
void add_card(CLI::App& app, Verb& chosen);
void add_plan(CLI::App& app, Verb& chosen);
void add_simulate(CLI::App& app, Verb& chosen);
void add_measure(CLI::App& app, Verb& chosen);
void add_export(CLI::App& app, Verb& chosen);
void add_import(CLI::App& app, Verb& chosen);
void add_garment(CLI::App& app, Verb& chosen);
void add_presets(CLI::App& app, Verb& chosen);
void add_yarns(CLI::App& app, Verb& chosen);
void add_devices(CLI::App& app, Verb& chosen);
void add_calibrate(CLI::App& app, Verb& chosen);
void add_compare(CLI::App& app, Verb& chosen);
void add_sweep(CLI::App& app, Verb& chosen);
void add_tradeoff(CLI::App& app, Verb& chosen);
void add_verify(CLI::App& app, Verb& chosen);
/// After all others.
void add_reference(CLI::App& app, Verb& chosen);

} // namespace hygroloom
