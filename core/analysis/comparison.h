// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Candidates on the same experiment, ranked by one of the numbers that its type reports.
#pragma once

#include "core/analysis/metrics.h"

#include <map>

namespace hygroloom {

/// A number of the metrics file by which candidates are compared.
struct Criterion {
    std::string name;       ///< its key, with the unit
    std::string title;      ///< for people
    std::string unit;       ///< empty for a plain number
    bool most_first = true; ///< otherwise the least comes first
};

/// Those of a type of experiment. The first ranks unless another is asked for.
std::vector<Criterion> criteria_of(ExperimentType type);

/// A fabric and what its run gave.
struct Candidate {
    std::string fabric;
    std::string metrics;                   ///< the metrics file; empty: the run failed
    std::string failure;                   ///< why, in a sentence
    std::map<std::string, double> numbers; ///< of the criteria; one that could not be determined is absent
    std::vector<std::string> notes;        ///< what limits them, in sentences
    double wall = 0;                       ///< s
};

struct Comparison {
    std::string experiment;
    std::vector<Criterion> criteria; ///< of the experiment's type
    Criterion ranked_by;
    std::vector<Candidate> candidates;
    bool complete = false; ///< whether all that were asked for are among them
};

/// The named criterion, the first for an empty name. Throws Error naming those there are.
Criterion criterion_named(const std::vector<Criterion>& criteria, const std::string& name);

/// What a finished run gave of the criteria.
Candidate candidate_of(const RunRecord& run, const Metrics& metrics, const std::vector<Criterion>& criteria);

/// Best first; those without the number after them, those that failed last, equal ones as they stand.
void rank(Comparison& comparison);

/// The comparison as people read it, with a line for each candidate below one of titles and one of units.
std::string comparison_table(const Comparison& comparison);
/// With the metrics file of each.
std::string comparison_json(const Comparison& comparison);
/// UTF-8, comma, dot decimals; first lines "# key=value", then a header. Numbers that could not be determined are empty.
std::string comparison_csv(const Comparison& comparison);

} // namespace hygroloom
