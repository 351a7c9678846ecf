// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/comparison.h"

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

constexpr bool most = true, least = false;

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

const char* order_words(const Criterion& criterion) { return criterion.most_first ? "the most first" : "the least first"; }

} // namespace

std::vector<Criterion> criteria_of(ExperimentType type)
{
    const Criterion radius_top{"maximum_wetted_radius_top_mm", "wetted radius, top", "mm", most};
    const Criterion radius_bottom{"maximum_wetted_radius_bottom_mm", "wetted radius, bottom", "mm", most};
    const Criterion absorbency{"absorbency_time_s", "absorbency time", "s", least};
    switch (type) {
    case ExperimentType::droplet: return {radius_top, radius_bottom, absorbency};
    case ExperimentType::horizontal_wicking: return {{"wick_rate_mm2_s", "wicking rate", "mm2/s", most}, radius_top, absorbency};
    case ExperimentType::moisture_management:
        return {{"ommc", "overall capability (OMMC)", "", most},
                {"one_way_transport_pct", "one-way transport", "%", most},
                {"spreading_speed_bottom_mm_s", "spreading speed, bottom", "mm/s", most},
                {"absorption_rate_bottom_pct_s", "absorption rate, bottom", "%/s", most},
                {"wetting_time_top_s", "wetting time, top", "s", least}};
    case ExperimentType::vertical_wicking:
        return {{"wick_height_mm", "height", "mm", most}, {"wick_rate_mm_s05", "wicking rate", "mm/s^0.5", most}};
    case ExperimentType::drying:
        return {{"time_to_dry_s", "time to dry", "s", least},
                {"drying_rate_g_m2_h", "steady drying rate", "g/(m2 h)", most},
                {"surface_temperature_steady_c", "steady temperature", "C", least}};
    case ExperimentType::conditioning:
        return {{"regain_half_time_s", "half of the change after", "s", least},
                {"regain_end", "regain at the end", "", most},
                {"temperature_peak_rise_c", "warmer than the air by", "K", least}};
    case ExperimentType::sweat: return {radius_bottom, radius_top};
    }
    return {};
}

Criterion criterion_named(const std::vector<Criterion>& criteria, const std::string& name)
{
    std::string names;
    for (const Criterion& criterion : criteria) {
        if (criterion.name == name || name.empty()) return criterion;
        names += (names.empty() ? "" : ", ") + criterion.name;
    }
    throw Error(fmt::format("This experiment has no number \"{}\" to rank by; there are: {}.", name, names));
}

Candidate candidate_of(const RunRecord& run, const Metrics& metrics, const std::vector<Criterion>& criteria)
{
    Candidate candidate{run.fabric, metrics_json(run, metrics), {}, {}, metrics.notes, run.wall};
    const Json all = Json::parse(candidate.metrics).at("metrics");
    for (const Criterion& criterion : criteria)
        if (const auto found = all.find(criterion.name); found != all.end() && found->is_number())
            candidate.numbers[criterion.name] = *found;
    for (std::string& note : notes_of(run.plan)) candidate.notes.push_back(std::move(note));
    if (const std::optional<double>& error = run.plan.expected_error; error && *error > 0)
        candidate.notes.push_back(fmt::format("The error to be expected is {} %.", rounded_text(100 * *error, 2)));
    return candidate;
}

void rank(Comparison& comparison)
{
    const Criterion& by = comparison.ranked_by;
    const auto place = [&](const Candidate& candidate) { // the lower, the better
        if (!candidate.failure.empty()) return std::numeric_limits<double>::infinity();
        const auto found = candidate.numbers.find(by.name);
        if (found == candidate.numbers.end()) return std::numeric_limits<double>::max();
        return by.most_first ? -found->second : found->second;
    };
    std::stable_sort(comparison.candidates.begin(), comparison.candidates.end(),
                     [&](const Candidate& a, const Candidate& b) { return place(a) < place(b); });
}

std::string comparison_table(const Comparison& comparison)
{
    std::string text =
        fmt::format("{}: ranked by {} ({})\n", comparison.experiment, comparison.ranked_by.title, order_words(comparison.ranked_by));
    std::size_t widest = 6;
    for (const Candidate& c : comparison.candidates) widest = std::max(widest, c.fabric.size());
    std::vector<std::size_t> widths;
    for (const Criterion& criterion : comparison.criteria) widths.push_back(std::max(criterion.title.size(), std::size_t{9}));
    const auto row = [&](const std::string& rank, const std::string& fabric, const auto& cell, const std::string& run_time) {
        text += fmt::format("{:>2}  {:<{}}", rank, fabric, widest);
        for (std::size_t i = 0; i < widths.size(); ++i) text += fmt::format("  {:>{}}", cell(comparison.criteria[i]), widths[i]);
        text += fmt::format("  {:>8}\n", run_time);
    };
    row(
        "", "fabric", [](const Criterion& criterion) { return criterion.title; }, "run time");
    row(
        "", "", [](const Criterion& criterion) { return criterion.unit; }, "s");
    int rank = 0;
    for (const Candidate& c : comparison.candidates) {
        ++rank;
        if (!c.failure.empty()) {
            text += fmt::format("{:>2}  {:<{}}  {}\n", rank, c.fabric, widest, c.failure);
            continue;
        }
        const auto number = [&](const Criterion& criterion) {
            const auto found = c.numbers.find(criterion.name);
            return found == c.numbers.end() ? std::string("-") : fmt::format("{:.4g}", found->second);
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
        if (c.failure.empty())
            candidate["run"] = Json::parse(c.metrics);
        else
            candidate["failure"] = c.failure;
        candidates.push_back(std::move(candidate));
    }
    return Json{{"format", "hygroloom-comparison"},
                {"version", 1},
                {"experiment", comparison.experiment},
                {"ranked_by", comparison.ranked_by.name},
                {"first", comparison.ranked_by.most_first ? "most" : "least"},
                {"complete", comparison.complete},
                {"candidates", candidates}}
               .dump(2) +
           "\n";
}

std::string comparison_csv(const Comparison& comparison)
{
    std::string text =
        fmt::format("# experiment={}\n# ranked_by={}\n# complete={}\nrank,fabric", one_line(comparison.experiment),
                    comparison.ranked_by.name + ", " + order_words(comparison.ranked_by), comparison.complete ? "yes" : "no");
    for (const Criterion& criterion : comparison.criteria) text += "," + criterion.name;
    text += ",wall_s,notes\n";
    int rank = 0;
    for (const Candidate& c : comparison.candidates) {
        text += fmt::format("{},{}", ++rank, csv_field(c.fabric));
        for (const Criterion& criterion : comparison.criteria) {
            const auto found = c.numbers.find(criterion.name);
            text += found == c.numbers.end() ? "," : fmt::format(",{:.6g}", found->second);
        }
        std::string notes = c.failure;
        for (const std::string& note : c.notes) notes += (notes.empty() ? "" : " ") + note;
        text += fmt::format(",{:.4g},{}\n", c.wall, csv_field(notes));
    }
    return text;
}

} // namespace hygroloom
