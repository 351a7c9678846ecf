// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// --fidelity of the verbs that plan and run: a name, or auto with a limit of error or time.
#pragma once

#include "app/cli_run.h"

#include "core/plan/expectation.h"

namespace hygroloom {

struct FidelityOptions : RunVerbOptions {
    std::string fidelity = "standard";
    std::string error, time; ///< of --fidelity auto
    bool recorded = false;   ///< whether its time counts the recording
};

/// --fidelity, --error and --time. whose ends the help of the last two: empty, or ", for all runs together".
void add_fidelity_options(CLI::App& verb, FidelityOptions& options, const std::string& whose);

/// Refuses an unknown fidelity and options that do not go together, before the project is read. Throws Stop.
void check_fidelity(const FidelityOptions& options);

/// With the expected time, memory and error on the backend of the options.
ModelPlan planned(const FidelityOptions& options, const Design& design, const Textile& textile, Fidelity fidelity,
                  const ForcedParts& forced, const KnobSettings& knobs);

/// The named fidelity, or the one that auto chooses for all textiles together: see expected_of_all(). Among several, one that the
/// experiment cannot run on is skipped; its own run reports the reason. Throws Error and Stop.
FidelityChoice chosen_fidelity(const FidelityOptions& options, const Design& design, const std::vector<Textile>& textiles,
                               const ForcedParts& forced, const KnobSettings& knobs);

/// The fidelity that auto chose and why, as a line; empty where the user named it.
std::string fidelity_text(const FidelityChoice& choice);

} // namespace hygroloom
