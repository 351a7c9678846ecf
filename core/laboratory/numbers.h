// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The laboratory's numbers of a card that need no run: each with its interval, standard and conditions. In the units that laboratories
// print.
#pragma once

#include "core/design/fitted_fabric.h"
#include "core/laboratory/estimate.h"

#include <string>

namespace hygroloom {

struct LaboratoryNumber {
    std::string key; ///< with its unit at the end
    std::string title, unit, standard, conditions;
    Estimate estimate;
    std::string model; ///< what it was compared with, and how far off it was; empty: nothing
};

/// From formulas and sections alone, at once: mass, thickness, cover, open area, porosity.
std::vector<LaboratoryNumber> quick_numbers(const FittedFabric& fitted);
/// All, in the order of a card. Takes 1 to 10 s of a core where the room's tables are not kept yet. Precondition: validate() found no
/// error.
std::vector<LaboratoryNumber> laboratory_numbers(const Design& design, const Fabric& fabric, const FittedFabric& fitted);

} // namespace hygroloom
