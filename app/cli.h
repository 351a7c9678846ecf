// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the verbs of hygroloom-cli share: options, exit codes, how a project is loaded and problems are told.
#pragma once

#include "core/base/error.h"
#include "core/design/validate.h"
#include "core/plan/fidelity.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace hygroloom {

class Recording;

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

/// A verb fills this in when the command line names it.
using Verb = std::function<int()>;

void add_common_options(CLI::App& verb, CommonOptions& options);
void add_project_options(CLI::App& verb, ProjectOptions& options, bool with_experiment);

/// Reads the project and applies --set, but for the knobs. Throws Stop.
Design load_project(const ProjectOptions& options);
/// What --set fidelity.<knob>=value says. Throws Stop.
KnobSettings knob_settings(const ProjectOptions& options);
/// For --help: each knob with its values and what it means.
std::string knob_help();

/// On stderr as "file: path: severity: sentence".
void print_issue(const std::string& file, const Issue& issue);
/// Errors on stderr, and unless quiet how many warnings there are, which check shows.
void print_in_short(const std::string& file, const std::vector<Issue>& issues, bool quiet);
/// Prints the design's issues in short. Throws Stop when one is an error.
void require_valid(const Design& design, const ProjectOptions& options);

/// The one named, or the only one when no name is given. Throws Stop with the names there are.
const Fabric& chosen_fabric(const Design& design, const ProjectOptions& options);
const Experiment& chosen_experiment(const Design& design, const ProjectOptions& options);

/// The chosen fabric as a WIF file, for export.
int export_wif(const ProjectOptions& options, const std::string& output);

/// The frame nearest to a moment, the last one when it is negative. Says on stderr when the recording ends well before the moment.
int frame_at(const Recording& recording, const std::string& file, double moment);

/// Accepts a time: a number of seconds, not negative.
CLI::Validator moment();

/// Each adds its verb to the program; when the command line names it, chosen is set.
void add_check(CLI::App& app, Verb& chosen);
void add_plan(CLI::App& app, Verb& chosen);
void add_simulate(CLI::App& app, Verb& chosen);
void add_measure(CLI::App& app, Verb& chosen);
void add_export(CLI::App& app, Verb& chosen);
void add_import(CLI::App& app, Verb& chosen);
void add_presets(CLI::App& app, Verb& chosen);
void add_devices(CLI::App& app, Verb& chosen);
void add_compare(CLI::App& app, Verb& chosen);
void add_tradeoff(CLI::App& app, Verb& chosen);
void add_verify(CLI::App& app, Verb& chosen);

} // namespace hygroloom
