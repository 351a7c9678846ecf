// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Verbs on garments that are worn.
#pragma once

#include "app/cli_run.h"

namespace hygroloom {

struct WearVerbOptions : RunVerbOptions {
    std::string fidelity = "standard";
    double cell_mm = 0;  ///< 0: by fidelity
    double shown_mm = 0; ///< see ShownSize
    std::vector<std::string> detail;
    std::string output;
};

/// The experiment of that name on a garment; without a name the project's only experiment, if it is on a garment; else nullptr.
const WearExperiment* chosen_wear(const Design& design, const ProjectOptions& options);
int simulate_wear(const Design& design, const WearExperiment& wear, const WearVerbOptions& options);
int plan_garment(const WearVerbOptions& options);
/// Prints what a recorded garment came to. Throws Stop.
int measure_garment(const std::string& recording, const CommonOptions& options);

struct WearMapVerbOptions : CommonOptions {
    std::string recording, output;
    double time = -1;           ///< s; less than 0: the end
    std::string cells = "auto"; ///< crossings
    std::string scale = "same";
    double most = 0;
};
int map_garment(const WearMapVerbOptions& options);

} // namespace hygroloom
