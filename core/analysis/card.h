// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The technical card of a fabric: construction, yarn consumption, cost and the laboratory's numbers, as JSON, table or page.
#pragma once

#include "core/analysis/outcomes.h"
#include "core/analysis/page.h"
#include "core/analysis/reader_units.h"
#include "core/laboratory/numbers.h"
#include "core/laboratory/technical.h"

#include <nlohmann/json_fwd.hpp>

namespace hygroloom {

struct Card {
    std::string fabric;
    std::string description; ///< the fabric as a project file has it: JSON
    FabricQuantities quantities;
    double ends_per_cm = 0, picks_per_cm = 0;
    TechnicalCard technical;
    LaboratoryNumbers numbers;
    double length_m = 0; ///< that is ordered
    std::string made_at; ///< UTC
    double seconds = 0;  ///< that the numbers took
};

/// Precondition: validate() found no error.
Card card_of(const Design& design, const Fabric& fabric, const FittedFabric& fitted, const CardRequest& request = {});

/// The same at once, without what a laboratory measures.
Card card_without_numbers(const Design& design, const Fabric& fabric, const FittedFabric& fitted, const CardRequest& request = {});

/// What stands beside the runs of a comparison: the laboratory's numbers that need no run, and what the yarn of a metre costs where all
/// yarns have a price. Precondition as above.
LaboratoryNumbers compared_numbers(const Design& design, const Fabric& fabric, const FittedFabric& fitted);
/// All that it may find.
const std::vector<OutcomeInfo>& card_metrics();

/// "warp", "weft, extra yarn 1".
std::string name_of(const YarnConsumption& use);
/// Metres that the kilograms are told for: those that are ordered, else 100.
double told_length_m(const Card& card);
/// Whether a yarn has a price.
bool has_prices(const Card& card);
/// What stands below the numbers, in sentences: on yarn and loom, how far off numbers were where they were compared, what is missing and
/// why, and what limits others.
std::vector<std::string> sentences_below(const Card& card);
/// Setts, loom, width, counts and crimps, each a name, a number and its unit.
std::vector<PageRow> construction_rows(const Card& card, const ReaderUnits& units = {});
/// In the reader's unit.
LaboratoryNumber in_units(LaboratoryNumber number, const ReaderUnits& units);
/// A number of the laboratory or its class, "grade 3 of 5" or nothing, and its range "50 to 120", which is empty where it is exact.
std::string value_text(const LaboratoryNumber& number);
std::string grade_text(const LaboratoryNumber& number);
std::string range_text(const Estimate& estimate);
/// {"fabric", "construction": {…}, "laboratory": {"air_permeability_mm_s": {"value", "low", "high", …}, …}, "missing": sentences}
nlohmann::ordered_json card_json(const Card& card);
/// {"air_permeability_mm_s": {"value", "low", "high", "unit", …}, …}
nlohmann::ordered_json laboratory_json(const std::vector<LaboratoryNumber>& numbers);
/// key, title, value, low, high, unit, standard, conditions, run. Of what could not be computed a row "missing" with a sentence as its
/// title, of all else that stands below the numbers a row "note".
std::string card_csv(const Card& card);
/// Both faces at true scale, as many repeats as make them 20 mm wide and high at least; and the top face from near, unless a repeat is more
/// than 12 mm. None where a repeat is more than 100 mm. Precondition: validate() found no error.
std::vector<ReportPicture> card_pictures(const Design& design, const Fabric& fabric, const FittedFabric& fitted);
ReportPage card_page(const Card& card, const std::vector<ReportPicture>& pictures, const ReaderUnits& units = {});

} // namespace hygroloom
