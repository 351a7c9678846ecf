// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// --fidelity of the verbs that plan and run: one by name, or auto and what it has to keep.
#pragma once

#include "app/cli_run.h"

#include "core/plan/expectation.h"

namespace hygroloom {

struct FidelityOptions : RunVerbOptions {
    std::string fidelity = "standard";
    std::string error, time; ///< of --fidelity auto
};

/// --fidelity, --error and --time; whose: what auto's error and time are of, if not of one run, to end the help's sentences.
void add_fidelity_options(CLI::App& verb, FidelityOptions& options, const std::string& whose);

/// Refuses a wrong word, and options that do not go together, before the project is read. Throws Stop.
void check_fidelity(const FidelityOptions& options);

/// With what is expected of the machine that the run would go to.
ModelPlan planned(const FidelityOptions& options, const Design& design, const Fabric& fabric, Fidelity fidelity, const ForcedParts& forced,
                  const KnobSettings& knobs);

/// As named, or the one that keeps what auto was told of the fabrics together: see expected_of_all(). A fabric that the experiment cannot
/// be run on is left aside where there are others; its own run will say so. Throws Error and Stop.
FidelityChoice chosen_fidelity(const FidelityOptions& options, const Design& design, const std::vector<std::string>& fabrics,
                               const ForcedParts& forced, const KnobSettings& knobs);

/// Which one auto took and why, a line for people; empty where the user named it.
std::string fidelity_text(const FidelityChoice& choice);

} // namespace hygroloom
