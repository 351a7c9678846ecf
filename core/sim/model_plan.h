// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a scene needs to be simulated, decided before the run and told with the reason: people read this.
#pragma once

#include "core/geometry/textile.h"

#include <cstdint>
#include <map>

namespace hygroloom {

enum class Fidelity { draft, standard, reference };

const char* name_of(Fidelity fidelity);
/// Throws Error naming the allowed words.
Fidelity fidelity_from_name(const std::string& name);

/// One part of the physics, on or off, and why, with the number that decided.
struct PlannedPart {
    std::string name; ///< "liquid", "wicking", "sorption", "vapour", "heat", "growth"
    bool on = false;
    bool forced = false; ///< by the user
    std::string reason;
};

struct ModelPlan {
    Fidelity fidelity = Fidelity::standard;
    std::vector<PlannedPart> parts;
    TextileRegion region;
    std::string region_reason;
    int particles_per_droplet = 0;
    int segments = 0;
    int fibre_shells = 0;          ///< radial cells in a fibre
    double frame_interval = 0;     ///< s
    double network_step_limit = 0; ///< s
    double saturation_change = 0;  ///< that a network step aims at while drops are about
    double rest_tolerance = 0;     ///< see Scene; 0: all of the sample is visited
    double step_error = 0;         ///< of a step without drops: part of the water and heat at stake that it may misplace
    double density_tolerance = 0;  ///< of the pressure loop, fraction
    double settle_share = 0;       ///< of liquid at rest that yarns drink before it settles anew; 0: it never rests
    std::string resolution_reason;
    double expected_seconds = 0;
    double expected_bytes = 0;
    std::string expectation_source;

    bool on(const std::string& part) const;
};

/// What the user may force: "heat" -> false.
using ForcedParts = std::map<std::string, bool>;

/// Parses "heat=off,vapour=on". Throws Error naming the parts.
ForcedParts parse_forced_parts(const std::string& text);

/// The textile as the experiment takes it: build_textile(), but with the paper's closure a fabric that gives no contact angle of its own
/// has that of cotton, whatever its fibres are.
Textile textile_of_run(const Design& design, const Fabric& fabric, const Experiment& experiment, const TextileRegion& region);

/// Precondition: validate() found no error. Throws Error when the experiment cannot be run on the fabric.
ModelPlan plan_model(const Design& design, const Fabric& fabric, const Experiment& experiment, Fidelity fidelity,
                     const ForcedParts& forced = {});

} // namespace hygroloom
