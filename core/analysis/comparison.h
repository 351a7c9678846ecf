// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fabrics on the same experiment: how sure their numbers are, which differences are real, and a ranking in which what does not differ ties.
#pragma once

#include "core/analysis/intervals.h"
#include "core/analysis/laboratory_table.h"
#include "core/design/unknowns.h"
#include "core/laboratory/numbers.h"

#include <map>
#include <memory>

namespace hygroloom {

struct RunTrace;

/// One run of a candidate. The first has all inputs as given; the others are drawn, see drawn().
struct ReplicateRun {
    std::map<std::string, double> numbers;   ///< by key, of all outcomes that could be determined
    std::vector<double> places;              ///< of each of the candidate's unknowns, see place_in_range()
    std::optional<double> edge_time{};       ///< s, when water was first seen where the sample ends
    std::shared_ptr<const RunTrace> trace{}; ///< its curves and maps; nullptr: they were not kept
};

/// What a report says of the first run of a garment, which has no RunRecord.
struct WornCandidate {
    std::string json;   ///< its numbers, as `simulate --json` prints them
    Design used;        ///< the garment, its experiment, the fabrics that it is cut from, the project's materials
    std::string how;    ///< fidelity and backend
    std::string device; ///< in words
};

/// A fabric or a garment and what its runs gave.
struct Candidate {
    std::string fabric;                   ///< its name; of a garment that of the fabric it is cut from, or of its project
    std::shared_ptr<const RunRecord> run; ///< the first replicate's; none: it failed, or it is of a garment
    std::shared_ptr<const Metrics> metrics;
    std::shared_ptr<const WornCandidate> worn;           ///< of a garment, of its first replicate
    std::vector<Outcome> outcomes;                       ///< of the first replicate
    double duration = 0;                                 ///< s, of its experiment; 0: not known
    std::string failure;                                 ///< why, in a sentence
    std::map<std::string, double> numerical;             ///< half width of the numerical error, by key; absent: not known
    std::vector<std::optional<ReplicateRun>> replicates; ///< by number; none: it failed or is missing
    std::vector<std::string> unknowns;                   ///< names of the inputs that were drawn
    std::map<std::string, Interval> intervals;           ///< by key
    std::vector<std::string> notes;                      ///< what limits the numbers, in sentences
    double wall = 0;                                     ///< s, of the runs whose time is known
    int timed = 0;                                       ///< how many those are
    int rank = 0;                                        ///< from 1; see judge(); 0: no number to rank by
    bool tied = false;
};

/// Instead of a verdict: one of the two has the number, and in no replicate has the other.
struct LoneNumber {
    std::string metric, fabric, baseline;
    bool fabric_has = false;
    std::string words;    ///< "absorbs, baseline does not"
    std::string sentence; ///< "Cotton absorbs all of the liquid, hemp does not within 10 s."
};

struct Why;

struct Comparison {
    std::string experiment;
    std::vector<OutcomeInfo> criteria; ///< see compared_by()
    OutcomeInfo ranked_by;
    std::string baseline; ///< fabric that the verdicts are against
    int replicates = 1;
    std::vector<Candidate> candidates;
    std::vector<Compared> verdicts;                 ///< each candidate against the baseline, by each criterion
    std::vector<LoneNumber> lone;                   ///< where there is no verdict, as only one of both has the number
    LaboratoryTable measured;                       ///< of a laboratory, beside the simulated
    std::map<std::string, LaboratoryNumbers> cards; ///< of technical cards, by fabric; empty: nobody asked
    bool complete = false;                          ///< whether all runs of all fabrics are among them
    bool of_garments = false;                       ///< the candidates are garments, whose numerical error is not known
    std::shared_ptr<const Why> why;                 ///< of one fabric against another; nullptr: nobody asked
};

/// The criterion of that key or full title, in small or capital letters; the first for an empty name. Throws Error naming those there are,
/// and the one that may be meant.
OutcomeInfo criterion_named(const std::vector<OutcomeInfo>& criteria, const std::string& name);

/// What a finished run gave, as the first replicate.
Candidate candidate_of(std::shared_ptr<const RunRecord> run, std::shared_ptr<const Metrics> metrics);

/// Takes up one more run of the candidate, replicate number's; the first, whichever number it has, brings the record.
void add_replicate(Candidate& candidate, const Candidate& run, int number);

/// One fabric against another by one criterion, over the replicates that both have; none: fewer than half of them have the
/// number, or there is one pair and its numerical error is not known.
std::optional<Compared> compared(const Candidate& candidate, const Candidate& baseline, const OutcomeInfo& criterion, int replicates);

/// Where the unknown inputs of both lie in a replicate, what they have in common once. Precondition: both have the replicate.
std::vector<double> places_of_pair(const Candidate& candidate, const Candidate& baseline, std::size_t replicate);

/// none: both have the number, or neither, or one of their runs failed or is missing.
std::optional<LoneNumber> lone_number(const Candidate& candidate, const Candidate& baseline, const OutcomeInfo& criterion, int replicates);

/// Intervals, ranks and verdicts from the runs that there are. A candidate stands before another where fewer are better or probably better
/// than it; its rank is one more than the number of candidates before it, so that of three that share the first the next is the fourth.
/// The order is by rank, then by number; those without the number come after them, those that failed last.
void judge(Comparison& comparison);

/// "2", or "2=" where others share the rank; empty: it has none.
std::string rank_text(const Candidate& candidate);

/// nullptr: there is none.
const Compared* verdict_of(const Comparison& comparison, const std::string& fabric, const std::string& metric);
const LoneNumber* lone_number_of(const Comparison& comparison, const std::string& fabric, const std::string& metric);
const LaboratoryValue* measured_of(const Comparison& comparison, const std::string& fabric, const std::string& metric);
const LaboratoryNumber* card_number_of(const Comparison& comparison, const std::string& fabric, const std::string& key);

/// Each number that some technical card has, once, in the order of the cards.
std::vector<const LaboratoryNumber*> card_numbers(const Comparison& comparison);

/// The numbers of the cards as criteria behind the others, with their ranges as the candidates' intervals; they have no verdicts. For
/// tables and charts: judge() takes them away again.
Comparison with_card_numbers(Comparison comparison);

/// What limits a candidate's numbers, in sentences: its notes, in how many replicates water reached the edge, what its card lacks.
std::vector<std::string> all_notes(const Comparison& comparison, const Candidate& candidate);

/// How many of its runs have come to their end.
int runs_of(const Candidate& candidate);

/// "3.25 ± 0.04", in the unit that people read, or in the reader's own.
std::string with_interval(const OutcomeInfo& criterion, const Interval& interval, const ReaderUnits& units = {});

/// A table for people: numbers with intervals below titles and units, then the verdicts in words.
std::string comparison_table(const Comparison& comparison);
/// With the metrics file of each.
std::string comparison_json(const Comparison& comparison);
/// UTF-8, comma, dot decimals; first lines "# key=value", then a header. Numbers that could not be determined are empty.
std::string comparison_csv(const Comparison& comparison);

/// What the intervals rest on, in a sentence.
std::string basis_text(const Comparison& comparison);

} // namespace hygroloom
