// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The laboratory's numbers of a card: each with its interval, standard and conditions. In the units that laboratories print. Here are
// those that need no run.
#pragma once

#include "core/design/fitted_fabric.h"
#include "core/laboratory/estimate.h"

#include <functional>
#include <string>

namespace hygroloom {

struct LaboratoryNumber {
    std::string key; ///< with its unit at the end
    std::string title, unit, standard, conditions;
    Estimate estimate;
    std::string model;  ///< what it was compared with, and the case of `verify` that says how far off it was; empty: nothing
    std::string run{};  ///< how its test was run: "live, cpu"; empty: it needs no run
    std::string text{}; ///< a class in words instead of a number
    int grade = 0;      ///< 1 poor to 5 excellent; 0: it has none
};

struct LaboratoryNumbers {
    std::vector<LaboratoryNumber> found; ///< in the order of a card
    std::vector<std::string> missing;    ///< what could not be computed and why, a sentence or two each
    std::vector<std::string> notes{};    ///< what limits the numbers, in sentences
};

/// All that laboratory_numbers() may find, without values.
std::vector<LaboratoryNumber> numbers_of_cards();
/// From formulas and sections alone, at once: mass, thickness at 1 kPa, cover, open area, thickness as drawn, porosity.
std::vector<LaboratoryNumber> quick_numbers(const FittedFabric& fitted);
/// All. Takes 1 to 10 s of a core where the room's tables are not kept yet. Precondition: validate() found no error.
LaboratoryNumbers laboratory_numbers(const Design& design, const Fabric& fabric, const FittedFabric& fitted);

/// Adds what is computed. Where that throws Error, nothing of it is there, and `missing` says that what is called so is missing.
void add_computed(LaboratoryNumbers& numbers, const char* what, const std::function<void(std::vector<LaboratoryNumber>&)>& compute);

} // namespace hygroloom
