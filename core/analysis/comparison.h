// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fabrics on the same experiment, ranked by one of the numbers that its type reports.
#pragma once

#include "core/analysis/outcomes.h"

#include <map>
#include <memory>

namespace hygroloom {

/// A fabric and what its run gave.
struct Candidate {
    std::string fabric;
    std::shared_ptr<const RunRecord> run; ///< none: the run failed
    std::shared_ptr<const Metrics> metrics;
    std::string failure;                   ///< why, in a sentence
    std::map<std::string, double> numbers; ///< by key; those that could not be determined are absent
    std::vector<std::string> notes;        ///< what limits them, in sentences
    double wall = 0;                       ///< s
};

struct Comparison {
    std::string experiment;
    std::vector<OutcomeInfo> criteria; ///< see compared_by()
    OutcomeInfo ranked_by;
    std::vector<Candidate> candidates;
    bool complete = false; ///< whether all fabrics of the comparison are among them
};

/// The criterion of that key, the first for an empty key. Throws Error naming those there are.
OutcomeInfo criterion_named(const std::vector<OutcomeInfo>& criteria, const std::string& key);

/// What a finished run gave.
Candidate candidate_of(std::shared_ptr<const RunRecord> run, std::shared_ptr<const Metrics> metrics);

/// Best first; those without the number after them, those that failed last, equal ones in their order.
void rank(Comparison& comparison);

/// A table for people: a line for each candidate below the titles and the units.
std::string comparison_table(const Comparison& comparison);
/// With the metrics file of each.
std::string comparison_json(const Comparison& comparison);
/// UTF-8, comma, dot decimals; first lines "# key=value", then a header. Numbers that could not be determined are empty.
std::string comparison_csv(const Comparison& comparison);

} // namespace hygroloom
