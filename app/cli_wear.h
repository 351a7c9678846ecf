// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Verbs on garments that are worn.
#pragma once

#include "app/cli_run.h"

#include "core/queue/compared_runs.h"
#include "core/wear/worn_candidate.h"

namespace hygroloom {

struct WearVerbOptions : RunVerbOptions {
    std::string fidelity = "standard";
    double cell_mm = 0;  ///< 0: by fidelity
    double shown_mm = 0; ///< see ShownSize
    std::vector<std::string> detail;
    bool profile = false;
    int replicates = 1, at_once = 0;
    std::string output;
};

/// The experiment of that name on a garment; without a name the project's only experiment, if it is on a garment; else nullptr.
const WearExperiment* chosen_wear(const Design& design, const ProjectOptions& options);
/// The folder that files of the project's garments are relative to.
std::filesystem::path folder_of(const std::string& project);
/// Runs every candidate as the options say, as often as the comparison has replicates, and judges it; ended: after each run. What the first
/// of each gave, empty where it failed or was cancelled. Throws Stop.
std::vector<FinishedGarment> run_garments(Comparison& comparison, std::vector<NamedJob> candidates, const WearVerbOptions& options,
                                          int at_once, const std::atomic<bool>& cancel, const std::function<void()>& ended);
int simulate_wear(const Design& design, const WearExperiment& wear, const WearVerbOptions& options);
int plan_garment(const WearVerbOptions& options);
/// Prints what a recorded garment came to, and writes a report of it where its name is not empty; time: s, of its maps, less than 0: some.
/// Throws Stop.
int measure_garment(const std::string& recording, const CommonOptions& options, const std::string& report, double time);

struct WearMapVerbOptions : CommonOptions {
    std::string recording, output;
    double time = -1;           ///< s; less than 0: the end
    std::string cells = "auto"; ///< crossings
    std::string scale = "same";
    double most = 0;
    std::vector<double> steps; ///< ends of the eight colours, instead of most
    std::string report;
    std::vector<double> times; ///< s, of the report's maps
};
int map_garment(const WearMapVerbOptions& options);

} // namespace hygroloom
