// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run found, as a list of numbers with their names and units, made from one table of metrics per type of experiment. The command
// line, the metrics file, comparisons, reports, trade-offs and the window read this list.
#pragma once

#include "core/analysis/plots.h"
#include "core/analysis/run_metrics.h"
#include "core/run/run_record.h"

#include <string>
#include <vector>

namespace hygroloom {

enum class Better { more, less, neither };

/// What a number is.
struct OutcomeInfo {
    std::string key;   ///< in the metrics file, ending in its unit
    std::string title; ///< "wetted radius"
    std::string part;  ///< "top", "bottom"; of a garment "panel front", "zone chest"; empty: the whole
    std::string unit;  ///< of the value; empty for a plain number
    Better better = Better::neither;
    bool in_rings = false;        ///< another number, rounded to the rings of a tester
    bool may_be_negative = false; ///< others, as lengths, times and amounts, are 0 at least
    bool of_whole_test = false;   ///< an index of the test from its beginning to its end: of a part it says nothing
};

/// "wetted radius, top"
std::string full_title(const OutcomeInfo& info);

struct Outcome : OutcomeInfo {
    std::optional<double> value; ///< none: it could not be determined
    std::string missing;         ///< why there is no value, in a clause
    std::string remark;          ///< what limits the value, in a clause; may be empty
    std::optional<int> grade;    ///< 1 poor to 5 excellent
    std::string text;            ///< a class in words, instead of a value
    int rank = 0;                ///< its place among the numbers that fabrics are compared by, from 1; 0: not among them
};

/// Fills in what the type of experiment reports beyond the stain. area: of the sample, m2.
void compute_results(Metrics& metrics, const Experiment& experiment, double area);

/// Of the type of the run's experiment, in the order of the metrics file. Numbers that do not apply to the run are absent. Where the run
/// ended early, or is a part of the test, indices, grades and the class are missing.
std::vector<Outcome> outcomes_of(const RunRecord& run, const Metrics& metrics, bool part = false);

/// Whether its frames do not reach the experiment's end.
bool is_part_of_test(const RunRecord& run, const Metrics& metrics);

/// Whether people read it: rings stand beside the exact number only where they are graded.
bool is_shown(const Outcome& outcome);

/// A value and its unit as people read them; a regain is in percent.
struct ShownValue {
    double value = 0;
    std::string unit;
};
ShownValue shown(const OutcomeInfo& info, double value);

/// Of the metric of that key; true for an unknown one.
bool may_be_negative(const std::string& key);

/// The numbers by which fabrics are compared on a type of experiment. The first ranks by default.
std::vector<OutcomeInfo> compared_by(ExperimentType type);
/// All numbers that the type of experiment may report.
std::vector<OutcomeInfo> reported_by(ExperimentType type);

/// The curves of what the type of experiment measures.
const Plot& subject_plot(ExperimentType type);

/// A row of the water balance or of its check.
struct BalanceRow {
    std::string title;
    double value = 0;
    std::string unit;
};
/// Where the water is at the end.
std::vector<BalanceRow> water_balance(const Ledger& ledger);
/// What the balance lacks, and the energy.
std::vector<BalanceRow> balance_check(const Ledger& ledger);

} // namespace hygroloom
