// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Small scenes that the cases are made of.
#pragma once

#include "core/analysis/metrics.h"
#include "core/scene/scene.h"
#include "core/solver/backend.h"

namespace hygroloom {

/// ends x picks crossings of plain weave, pitch apart; climate of water at a temperature, everything else off.
/// Yarn 0 is the warp's, 1 the weft's.
Scene bare_scene(int ends, int picks, double pitch, double temperature);

/// Loads, advances and returns the frame at each time, in order.
std::vector<Frame> frames_at(Backend& backend, const Scene& scene, const std::vector<double>& times);

/// Throws Error naming it when the library has none of that name.
const Material& library_material(const std::string& name);
/// Of the shipped library; the paper's textiles by their letter alone, too. Throws Error with the names there are.
const Fabric& library_fabric(const std::string& name);
/// Of yarns that are nowhere thicker than elsewhere, where one draw of thick places would hide what is looked for.
Fabric of_even_yarns(Fabric fabric);

Isotherm isotherm_of(const Material& material);

/// Dry fibre in air of a climate, and the time after which nothing changes any more, s.
Scene fibre_in_air(const Material& material, double temperature, double humidity);
constexpr double time_to_condition = 4e4;

/// Dry fibre that has just as much liquid in its pores as makes this regain, and keeps the heat; isotherm as measured at 20 C.
Scene fibre_with_liquid(const Material& material, double regain);

/// A sheet of fibres in air, both faces alike.
struct SheetClimate {
    double areal_density;              ///< kg/m2
    double mass_transfer;              ///< m/s
    double heat_transfer;              ///< W/(m2 K)
    double diffusivity;                ///< m2/s in the fibres; 0: they are always in equilibrium
    double from_humidity, to_humidity; ///< the fibres', the air's
    double temperature;                ///< K
};
Scene sheet_in_air(const Material& material, const Isotherm& isotherm, const SheetClimate& climate);

/// A yarn of fibre alone, warm by 1 K, with its first segment (and its last) kept at 0.
Scene warm_yarn(int cells, double cell, double diffusivity, bool both_ends);

/// The yarn network alone: a wet spot wicks, sorbs, dries and cools on 37 x 41 crossings (odd, more than a block).
Scene wet_spot();

/// A fabric and one experiment on it, which is named by its type.
Design design_of(Fabric fabric, Experiment experiment);

/// Textile F of the paper, 12 x 12 mm, with one drop of a volume in µl; s, degrees.
Design drop_on_cotton(double volume, double duration, double contact_angle);

/// A whole run as the program makes it, of a design's first fabric and first experiment.
struct WholeRun {
    RunRecord record;
    Metrics metrics;
    Frame last;
};
WholeRun run_whole(const Design& design, Fidelity fidelity, Backend& backend, const KnobSettings& knobs = {});

} // namespace hygroloom
