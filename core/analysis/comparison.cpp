// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/comparison.h"

#include "core/analysis/card.h"
#include "core/analysis/run_trace.h"
#include "core/base/error.h"
#include "core/base/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace hygroloom {
namespace {

/// Where both have the number, in the order of the replicates.
struct PairedValues {
    std::vector<double> values, baseline;
    std::vector<std::vector<double>> places; ///< of both's unknowns
};

const double* number_of(const Candidate& candidate, std::size_t replicate, const std::string& key)
{
    if (replicate >= candidate.replicates.size() || !candidate.replicates[replicate]) return nullptr;
    const auto& numbers = candidate.replicates[replicate]->numbers;
    const auto found = numbers.find(key);
    return found == numbers.end() ? nullptr : &found->second;
}

PairedValues pairs_of(const Candidate& candidate, const Candidate& baseline, const std::string& key)
{
    PairedValues pairs;
    for (std::size_t i = 0; i < candidate.replicates.size(); ++i) {
        const double *a = number_of(candidate, i, key), *b = number_of(baseline, i, key);
        if (!a || !b) continue;
        pairs.values.push_back(*a);
        pairs.baseline.push_back(*b);
        pairs.places.push_back(places_of_pair(candidate, baseline, i));
    }
    return pairs;
}

std::optional<double> numerical_of(const Candidate& candidate, const std::string& key)
{
    const auto found = candidate.numerical.find(key);
    return found == candidate.numerical.end() ? std::nullopt : std::optional(found->second);
}

/// What the number cannot be below.
double least_of(const Candidate& candidate, const std::string& key)
{
    for (const Outcome& outcome : candidate.outcomes)
        if (outcome.key == key) return outcome.may_be_negative ? -std::numeric_limits<double>::infinity() : 0;
    return hygroloom::least_of(key);
}

void find_intervals(Candidate& candidate)
{
    candidate.intervals.clear();
    std::set<std::string> keys;
    for (const auto& run : candidate.replicates)
        if (run)
            for (const auto& [key, value] : run->numbers) keys.insert(key);
    for (const std::string& key : keys) {
        std::vector<double> values;
        std::vector<std::vector<double>> places;
        for (std::size_t i = 0; i < candidate.replicates.size(); ++i)
            if (const double* value = number_of(candidate, i, key)) {
                values.push_back(*value);
                places.push_back(candidate.replicates[i]->places);
            }
        candidate.intervals[key] = interval_of(values, places, numerical_of(candidate, key), least_of(candidate, key));
    }
}

std::string small_letters(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool shows_better(const std::optional<Compared>& found)
{
    return found && (found->verdict == Verdict::better || found->verdict == Verdict::probably_better);
}

bool has_number(const Candidate& candidate, const std::string& key)
{
    return candidate.failure.empty() && candidate.intervals.contains(key);
}

/// The lower, the earlier; where ranks are equal.
double place(const Candidate& candidate, const OutcomeInfo& by)
{
    if (!candidate.failure.empty()) return std::numeric_limits<double>::infinity();
    const auto found = candidate.intervals.find(by.key);
    if (found == candidate.intervals.end()) return std::numeric_limits<double>::max();
    return by.better == Better::less ? found->second.centre : -found->second.centre;
}

/// How many of its runs have the number; none: not all of them have come to their end.
std::optional<int> count_of(const Candidate& candidate, const std::string& key, int replicates)
{
    int count = 0;
    for (int i = 0; i < replicates; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (at >= candidate.replicates.size() || !candidate.replicates[at]) return {};
        count += number_of(candidate, at, key) ? 1 : 0;
    }
    return count;
}

/// Why a candidate's run lacks the number, in a clause; may be empty.
std::string reason_of(const Candidate& candidate, const std::string& key)
{
    for (const Outcome& outcome : candidate.outcomes)
        if (outcome.key == key) return outcome.missing;
    return {};
}

/// " within 10 s"; empty: it is not known how long its experiment takes.
std::string within_text(const Candidate& candidate)
{
    return candidate.duration > 0 ? fmt::format(" within {:g} s", candidate.duration) : std::string();
}

void rank(Comparison& comparison)
{
    const OutcomeInfo& by = comparison.ranked_by;
    std::vector<Candidate>& all = comparison.candidates;
    std::vector<std::optional<int>> better; // how many are, of those that have the number
    for (const Candidate& candidate : all) {
        better.emplace_back();
        if (!has_number(candidate, by.key)) continue;
        better.back() = static_cast<int>(std::count_if(all.begin(), all.end(), [&](const Candidate& other) {
            return &other != &candidate && shows_better(compared(other, candidate, by, comparison.replicates));
        }));
    }
    // Not one more than are better: what one of three at the top is better than is the fourth, though the others are not shown to be.
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto own = better[i];
        const auto count = [&](auto&& holds) { return std::count_if(better.begin(), better.end(), holds); };
        all[i].rank = own ? 1 + static_cast<int>(count([&](const auto& other) { return other && *other < *own; })) : 0;
        all[i].tied = own && count([&](const auto& other) { return other == own; }) > 1;
    }
    std::stable_sort(all.begin(), all.end(), [&](const Candidate& a, const Candidate& b) {
        const int last = std::numeric_limits<int>::max();
        return std::pair(a.rank > 0 ? a.rank : last, place(a, by)) < std::pair(b.rank > 0 ? b.rank : last, place(b, by));
    });
}

} // namespace

OutcomeInfo criterion_named(const std::vector<OutcomeInfo>& criteria, const std::string& name)
{
    std::string keys;
    std::vector<std::string> known;
    std::string begun; // the first whose key or title begins like the name
    const std::string wanted = small_letters(name);
    for (const OutcomeInfo& criterion : criteria) {
        const std::string title = small_letters(full_title(criterion));
        if (name.empty() || wanted == criterion.key || wanted == title) return criterion;
        if (begun.empty() && (criterion.key.starts_with(wanted) || title.starts_with(wanted))) begun = criterion.key;
        known.insert(known.end(), {criterion.key, full_title(criterion)});
        keys += (keys.empty() ? "" : ", ") + criterion.key;
    }
    const std::string near = begun.empty() ? did_you_mean(name, known) : fmt::format("; did you mean \"{}\"?", begun);
    throw Error(fmt::format("This experiment has no number \"{}\" to rank by{} It has {}.", name, near, keys));
}

Candidate candidate_of(std::shared_ptr<const RunRecord> run, std::shared_ptr<const Metrics> metrics)
{
    Candidate candidate;
    candidate.fabric = run->fabric;
    candidate.notes = notes_of(*metrics);
    candidate.wall = run->wall;
    candidate.timed = run->wall > 0 ? 1 : 0;
    ReplicateRun first;
    candidate.outcomes = outcomes_of(*run, *metrics);
    for (const Outcome& outcome : candidate.outcomes) {
        if (!outcome.value) continue;
        first.numbers[outcome.key] = *outcome.value;
        if (const auto error = numerical_error(*run, outcome.key, *outcome.value)) candidate.numerical[outcome.key] = *error;
    }
    first.edge_time = metrics->edge_time;
    const Experiment* experiment = find_experiment(run->design, run->experiment);
    candidate.duration = experiment ? experiment->duration_s : 0;
    const auto& times = metrics->series.time;
    first.trace = std::make_shared<const RunTrace>(trace_of(*metrics, experiment || times.empty() ? candidate.duration : times.back()));
    candidate.replicates.emplace_back(std::move(first));
    for (std::string& note : notes_of(run->plan)) candidate.notes.push_back(std::move(note));
    candidate.run = std::move(run);
    candidate.metrics = std::move(metrics);
    find_intervals(candidate);
    return candidate;
}

void add_replicate(Candidate& candidate, const Candidate& run, int number)
{
    const auto at = static_cast<std::size_t>(number);
    std::vector<std::optional<ReplicateRun>> replicates = std::move(candidate.replicates);
    const double wall = candidate.wall + run.wall;
    const int timed = candidate.timed + run.timed;
    std::vector<std::string> notes = std::move(candidate.notes);
    if (number == 0) {
        candidate = run;
        notes.insert(notes.begin(), run.notes.begin(), run.notes.end());
    } else if (!run.failure.empty()) {
        notes.push_back(fmt::format("Replicate {} is missing: {}", number + 1, run.failure));
    }
    candidate.fabric = run.fabric;
    candidate.notes = std::move(notes);
    candidate.wall = wall;
    candidate.timed = timed;
    if (run.failure.empty()) candidate.unknowns = run.unknowns;
    candidate.replicates = std::move(replicates);
    candidate.replicates.resize(std::max(candidate.replicates.size(), at + 1));
    if (run.failure.empty()) candidate.replicates[at] = run.replicates.front();
}

std::optional<Compared> compared(const Candidate& candidate, const Candidate& baseline, const OutcomeInfo& criterion, int replicates)
{
    const PairedValues pairs = pairs_of(candidate, baseline, criterion.key);
    if (pairs.values.empty() || 2 * static_cast<int>(pairs.values.size()) < replicates) return {};
    const bool known = candidate.numerical.contains(criterion.key) && baseline.numerical.contains(criterion.key);
    if (pairs.values.size() == 1 && !known) return {};
    // The errors of runs that are alike have the same direction; what they do not share is at most the larger of both.
    const double numerical =
        std::max(numerical_of(candidate, criterion.key).value_or(0), numerical_of(baseline, criterion.key).value_or(0));
    Compared found = compare_pairs(pairs.values, pairs.baseline, pairs.places, numerical, criterion.better);
    found.metric = criterion.key;
    found.fabric = candidate.fabric;
    found.baseline = baseline.fabric;
    return found;
}

std::vector<double> places_of_pair(const Candidate& candidate, const Candidate& baseline, std::size_t replicate)
{
    std::vector<double> places = candidate.replicates[replicate]->places;
    for (std::size_t i = 0; i < baseline.unknowns.size(); ++i)
        if (std::find(candidate.unknowns.begin(), candidate.unknowns.end(), baseline.unknowns[i]) == candidate.unknowns.end())
            places.push_back(baseline.replicates[replicate]->places[i]);
    return places;
}

std::optional<LoneNumber> lone_number(const Candidate& candidate, const Candidate& baseline, const OutcomeInfo& criterion, int replicates)
{
    if (!candidate.failure.empty() || !baseline.failure.empty()) return {};
    const auto own = count_of(candidate, criterion.key, replicates), other = count_of(baseline, criterion.key, replicates);
    if (!own || !other || (*own == 0) == (*other == 0)) return {};
    LoneNumber lone{criterion.key, candidate.fabric, baseline.fabric, *own > 0, {}, {}};
    const Candidate &with = lone.fabric_has ? candidate : baseline, &without = lone.fabric_has ? baseline : candidate;
    const int count = std::max(*own, *other);
    const std::string in = count < replicates ? fmt::format(" in {} of {} replicates", count, replicates) : std::string();
    if (criterion.key == "absorbency_time_s") {
        lone.words = lone.fabric_has ? "absorbs, baseline does not" : "does not absorb, baseline does";
        lone.sentence =
            fmt::format("{} absorbs all of the liquid{}, {} does not{}.", with.fabric, in, without.fabric, within_text(without));
    } else {
        const std::string why = reason_of(without, criterion.key);
        lone.words = lone.fabric_has ? "only this has it" : "only baseline has it";
        lone.sentence = fmt::format("Only {} has the {}{}; {} has none{}.", with.fabric, full_title(criterion), in, without.fabric,
                                    why.empty() ? why : " (" + why + ")");
    }
    return lone;
}

Comparison with_card_numbers(Comparison comparison)
{
    for (const LaboratoryNumber* number : card_numbers(comparison)) {
        const auto info =
            std::find_if(card_metrics().begin(), card_metrics().end(), [&](const auto& each) { return each.key == number->key; });
        if (info == card_metrics().end()) continue;
        comparison.criteria.push_back(*info);
        for (Candidate& candidate : comparison.candidates) {
            const LaboratoryNumber* own = card_number_of(comparison, candidate.fabric, number->key);
            if (!own) continue;
            Interval& interval = candidate.intervals[number->key];
            interval.centre = own->estimate.value;
            interval.low = own->estimate.low;
            interval.high = own->estimate.high;
        }
    }
    return comparison;
}

std::vector<std::string> all_notes(const Comparison& comparison, const Candidate& candidate)
{
    std::vector<std::string> notes = candidate.notes;
    std::size_t runs = 0, at_edge = 0;
    double first = std::numeric_limits<double>::infinity();
    for (const auto& run : candidate.replicates) {
        runs += run ? 1 : 0;
        if (!run || !run->edge_time) continue;
        ++at_edge;
        first = std::min(first, *run->edge_time);
    }
    if (comparison.replicates > 1 && at_edge > 0)
        notes.push_back(fmt::format("In {} of {} replicates water reached the edge of the sample, after {:.3g} s at the earliest; a larger "
                                    "sample changes their numbers.",
                                    at_edge, runs, first));
    if (const auto card = comparison.cards.find(candidate.fabric); card != comparison.cards.end())
        notes.insert(notes.end(), card->second.missing.begin(), card->second.missing.end());
    return notes;
}

int runs_of(const Candidate& candidate)
{
    return static_cast<int>(std::count_if(candidate.replicates.begin(), candidate.replicates.end(),
                                          [](const std::optional<ReplicateRun>& run) { return run.has_value(); }));
}

std::string rank_text(const Candidate& candidate)
{
    return candidate.rank == 0 ? std::string() : std::to_string(candidate.rank) + (candidate.tied ? "=" : "");
}

void judge(Comparison& comparison)
{
    for (Candidate& candidate : comparison.candidates) find_intervals(candidate);
    rank(comparison);
    comparison.verdicts.clear();
    comparison.lone.clear();
    const auto base = std::find_if(comparison.candidates.begin(), comparison.candidates.end(),
                                   [&](const Candidate& c) { return c.fabric == comparison.baseline; });
    if (base == comparison.candidates.end()) return;
    for (const OutcomeInfo& criterion : comparison.criteria)
        for (const Candidate& candidate : comparison.candidates) {
            if (&candidate == &*base) continue;
            if (auto found = compared(candidate, *base, criterion, comparison.replicates))
                comparison.verdicts.push_back(std::move(*found));
            else if (auto lone = lone_number(candidate, *base, criterion, comparison.replicates))
                comparison.lone.push_back(std::move(*lone));
        }
}

} // namespace hygroloom
