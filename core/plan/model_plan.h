// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a scene needs to be simulated, decided before the run, with the reasons that people read. plan_model() makes it.
#pragma once

#include "core/geometry/textile.h"
#include "core/plan/bundles.h"
#include "core/plan/fidelity.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

/// One part of the physics, on or off, and why, with the number that decided.
struct PlannedPart {
    std::string name; ///< "liquid", "cap", "wicking", "sorption", "vapour", "heat", "growth"
    bool on = false;
    bool forced = false; ///< by the user
    std::string reason;
    std::optional<double> share = std::nullopt; ///< of the water at stake, or of a rate, that it changes at most, by an estimate
    bool watched = false; ///< left out because that share is small; the run switches it on if it is not: see PartWatch
};

/// Of a rate, for a kelvin: surface tension over viscosity follows temperature so, saturation pressure faster.
constexpr double change_per_kelvin = 0.02;

/// What of a scene decides its cost.
struct SceneCounts {
    std::string type;         ///< of the experiment
    std::string closure;      ///< by which liquid moves
    double drops = 0;         ///< that fall
    double landings = 0;      ///< moments at which they fall; 0: not known, one for each drop
    double drop_volume = 0;   ///< m3, of each, on average
    double largest_drop = 0;  ///< m3
    double landing_speed = 0; ///< m/s, of the largest
    double sample_area = 0;   ///< m2; 0: not known, as in files of older versions
    double sample_edge = 0;   ///< m, around it
    double duration = 0;      ///< s
    double frames = 0;        ///< that are shown; 0: not known, as in files of older versions
    double wet_share = 0;     ///< of the sample that can get wet, at most
    double suction = 0;       ///< cosine of the smallest contact angle of a yarn; 0: none wicks
    double uptake = 0;        ///< m3/s, as fast as cloth draws liquid away: pores under a face (m) times their liquid diffusivity; with the
                              ///< closure pores what a metre of cloth conducts times the suction of its pores
    double pores = 0;         ///< m3/m2, of all yarns that draw liquid; with the closure pores also of the room between them
    double drop_base = 0;     ///< area that a small drop first stands on, over its volume to the power 2/3: see base_of_drop()
    double capillarity = 0;   ///< m3/s2, surface tension of the liquid over its density
    double viscosity = 0;     ///< m2/s
    double drawn_cubes = 0;   ///< of the room between yarns, see core/room; 0: not known, as in files of older versions
    double drawn_periods = 0; ///< of so many each
    double drawn_longest = 0; ///< side of one, in those of a cube; 0: not known, as in files of older versions
};

struct ModelPlan {
    Fidelity fidelity = Fidelity::standard;
    std::string fidelity_reason; ///< why auto took it; empty: the user named it
    Knobs knobs;                 ///< the fidelity's, with what the user set on top; what of them this scene needs stands below
    std::map<std::string, std::string> idle_knobs; ///< that change nothing in this scene: name -> why, in a clause: "no drop falls"
    std::vector<PlannedPart> parts;
    double water_at_stake = 0; ///< kg, what shares of the water are of: all that comes, or that fibres exchange
    TextileRegion region;
    std::string region_reason;
    int particles_per_droplet = 0;
    int segments = 0;
    int fibre_shells = 0;       ///< radial cells in a fibre
    int crossings_per_cell = 1; ///< ends, and picks, in a bundle that is simulated as one
    bool whole_bundles = false; ///< see Bundling
    int shown_ends = 0;         ///< cells in which frames show the sample; 0: each segment
    int shown_picks = 0;
    std::string not_in_cells;  ///< why it is not shown in cells although it is large, or they were asked for
    double frame_interval = 0; ///< s
    double rest_tolerance = 0; ///< see Scene; 0: all of the sample is visited
    std::string resolution_reason;
    SceneCounts counts;
    double expected_seconds = 0;
    double expected_bytes = 0;
    std::optional<double> expected_error;          ///< against the reference, relative; none: not measured
    std::map<std::string, double> expected_errors; ///< of each metric by its key, with what the reference itself lacks; see error_scale()
    std::string expectation_source;

    Bundling bundling() const { return {crossings_per_cell, whole_bundles}; }
    bool on(const std::string& part) const;
    bool watches(const std::string& part) const;
};

/// What a run did otherwise than the user may expect, in sentences: that yarns went in bundles, that a knob he set had no effect.
std::vector<std::string> notes_of(const ModelPlan& plan);

/// The same plan with a part switched on while it runs.
ModelPlan with_part(ModelPlan plan, const std::string& part);

/// What the user may force: "heat" -> false.
using ForcedParts = std::map<std::string, bool>;

/// Parses "heat=off,vapour=on". Throws Error naming the parts.
ForcedParts parse_forced_parts(const std::string& text);

} // namespace hygroloom
