// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A whole project: what a designer edits. Copying is cheap (weave matrices are shared).
#pragma once

#include "core/design/experiment.h"
#include "core/design/fabric.h"
#include "core/design/garment.h"
#include "core/design/liquid.h"
#include "core/design/wear.h"

namespace hygroloom {

struct Design {
    std::vector<Material> materials; ///< the project's own, before the library's
    std::vector<Liquid> liquids;     ///< the same
    std::vector<Fabric> fabrics;
    std::vector<Experiment> experiments;
    std::vector<Garment> garments;
    std::vector<WearExperiment> wears; ///< experiments on garments; all experiments' names differ
    bool operator==(const Design&) const = default;
};

/// The project's material of that name, else the library's, else nullptr.
const Material* find_material(const Design& design, const std::string& name);

/// The same of a liquid.
const Liquid* find_liquid(const Design& design, const std::string& name);

/// The substance of a blend: density by volume, the rest weighted by mass; radius of equal mean surface. The isotherm has the shape of
/// the hygroscopic fibres' and passes through the blend's standard regain. The cross-section's factor is weighted by surface.
/// Precondition: validate() found no error in it.
Material blended_material(const Design& design, const std::vector<MaterialShare>& shares);

/// The mean substance of all that a yarn is made of. A core counts in density, regain and heat by its mass; how thick and how wettable
/// the fibres are, and how fast they take water up, is said of those round it alone. Precondition as above.
Material yarn_substance(const Design& design, const Yarn& yarn);
/// Share of the yarn's solids that the core is, by volume; 0 without one.
double core_of_solids(const Design& design, const Yarn& yarn);

/// Receding angle of water on a blend's fibres, by mass, whose contact angle is their own or a finish's. Degrees; at most the contact
/// angle. Precondition as above.
double receding_angle_of(const Design& design, const std::vector<MaterialShare>& shares, std::optional<double> finish_deg);

const Fabric* find_fabric(const Design& design, const std::string& name);
const Experiment* find_experiment(const Design& design, const std::string& name);
const Garment* find_garment(const Design& design, const std::string& name);
const WearExperiment* find_wear(const Design& design, const std::string& name);

} // namespace hygroloom
