// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/comparison.h"

#include "core/analysis/metrics_json.h"
#include "core/base/error.h"
#include "core/base/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace hygroloom {

namespace {

using Json = nlohmann::ordered_json;

std::string one_line(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

/// A CSV field.
std::string csv_field(const std::string& text)
{
    std::string inside;
    for (const char c : one_line(text)) inside += c == '"' ? "\"\"" : std::string(1, c);
    return '"' + inside + '"';
}

bool most_first(const OutcomeInfo& criterion) { return criterion.better != Better::less; }
const char* order_words(const OutcomeInfo& criterion) { return most_first(criterion) ? "largest first" : "smallest first"; }

} // namespace

OutcomeInfo criterion_named(const std::vector<OutcomeInfo>& criteria, const std::string& key)
{
    std::string keys;
    for (const OutcomeInfo& criterion : criteria) {
        if (criterion.key == key || key.empty()) return criterion;
        keys += (keys.empty() ? "" : ", ") + criterion.key;
    }
    throw Error(fmt::format("This experiment has no number \"{}\" to rank by; it has {}.", key, keys));
}

Candidate candidate_of(std::shared_ptr<const RunRecord> run, std::shared_ptr<const Metrics> metrics)
{
    Candidate candidate;
    candidate.fabric = run->fabric;
    candidate.notes = metrics->notes;
    candidate.wall = run->wall;
    for (const Outcome& outcome : outcomes_of(*run, *metrics))
        if (outcome.rank > 0 && outcome.value) candidate.numbers[outcome.key] = *outcome.value;
    for (std::string& note : notes_of(run->plan)) candidate.notes.push_back(std::move(note));
    if (const std::optional<double>& error = run->plan.expected_error; error && *error > 0)
        candidate.notes.push_back(fmt::format("The largest numerical error is {} %.", rounded_text(100 * *error, 2)));
    candidate.run = std::move(run);
    candidate.metrics = std::move(metrics);
    return candidate;
}

void rank(Comparison& comparison)
{
    const OutcomeInfo& by = comparison.ranked_by;
    const auto place = [&](const Candidate& candidate) { // the lower, the better
        if (!candidate.failure.empty()) return std::numeric_limits<double>::infinity();
        const auto found = candidate.numbers.find(by.key);
        if (found == candidate.numbers.end()) return std::numeric_limits<double>::max();
        return most_first(by) ? -found->second : found->second;
    };
    std::stable_sort(comparison.candidates.begin(), comparison.candidates.end(),
                     [&](const Candidate& a, const Candidate& b) { return place(a) < place(b); });
}

std::string comparison_table(const Comparison& comparison)
{
    std::string text =
        fmt::format("{}: ranked by {} ({})\n", comparison.experiment, full_title(comparison.ranked_by), order_words(comparison.ranked_by));
    std::size_t widest = 6;
    for (const Candidate& c : comparison.candidates) widest = std::max(widest, c.fabric.size());
    std::vector<std::size_t> widths;
    for (const OutcomeInfo& criterion : comparison.criteria) widths.push_back(std::max(full_title(criterion).size(), std::size_t{9}));
    const auto row = [&](const std::string& rank, const std::string& fabric, const auto& cell, const std::string& run_time) {
        text += fmt::format("{:>2}  {:<{}}", rank, fabric, widest);
        for (std::size_t i = 0; i < widths.size(); ++i) text += fmt::format("  {:>{}}", cell(comparison.criteria[i]), widths[i]);
        text += fmt::format("  {:>8}\n", run_time);
    };
    row(
        "", "fabric", [](const OutcomeInfo& criterion) { return full_title(criterion); }, "run time");
    row(
        "", "", [](const OutcomeInfo& criterion) { return shown(criterion, 0).unit; }, "s");
    int rank = 0;
    for (const Candidate& c : comparison.candidates) {
        ++rank;
        if (!c.failure.empty()) {
            text += fmt::format("{:>2}  {:<{}}  {}\n", rank, c.fabric, widest, c.failure);
            continue;
        }
        const auto number = [&](const OutcomeInfo& criterion) {
            const auto found = c.numbers.find(criterion.key);
            return found == c.numbers.end() ? std::string("-") : fmt::format("{:.4g}", shown(criterion, found->second).value);
        };
        row(std::to_string(rank), c.fabric, number, fmt::format("{:.3g}", c.wall));
    }
    for (const Candidate& c : comparison.candidates)
        for (const std::string& note : c.notes) text += fmt::format("  {}: {}\n", c.fabric, note);
    return text;
}

std::string comparison_json(const Comparison& comparison)
{
    Json candidates = Json::array();
    for (const Candidate& c : comparison.candidates) {
        Json candidate{{"rank", candidates.size() + 1}, {"fabric", c.fabric}};
        if (c.run && c.metrics)
            candidate["run"] = metrics_value(*c.run, *c.metrics);
        else
            candidate["failure"] = c.failure;
        candidates.push_back(std::move(candidate));
    }
    return Json{{"format", "hygroloom-comparison"},
                {"version", 1},
                {"experiment", comparison.experiment},
                {"ranked_by", comparison.ranked_by.key},
                {"first", most_first(comparison.ranked_by) ? "most" : "least"},
                {"complete", comparison.complete},
                {"candidates", candidates}}
               .dump(2) +
           "\n";
}

std::string comparison_csv(const Comparison& comparison)
{
    std::string text = fmt::format("# experiment={}\n# ranked_by={}\n# complete={}\nrank,fabric", one_line(comparison.experiment),
                                   comparison.ranked_by.key + ", " + order_words(comparison.ranked_by), comparison.complete ? "yes" : "no");
    for (const OutcomeInfo& criterion : comparison.criteria) text += "," + criterion.key;
    text += ",wall_s,notes\n";
    int rank = 0;
    for (const Candidate& c : comparison.candidates) {
        text += fmt::format("{},{}", ++rank, csv_field(c.fabric));
        for (const OutcomeInfo& criterion : comparison.criteria) {
            const auto found = c.numbers.find(criterion.key);
            text += found == c.numbers.end() ? "," : fmt::format(",{:.6g}", found->second);
        }
        std::string notes = c.failure;
        for (const std::string& note : c.notes) notes += (notes.empty() ? "" : " ") + note;
        text += fmt::format(",{:.4g},{}\n", c.wall, csv_field(notes));
    }
    return text;
}

} // namespace hygroloom
