// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/comparison.h"

#include "core/base/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

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

} // namespace

std::vector<Criterion> criteria_of(ExperimentType type)
{
    switch (type) {
    case ExperimentType::droplet:
        return {{"maximum_wetted_radius_top_mm", most}, {"maximum_wetted_radius_bottom_mm", most}, {"absorbency_time_s", least}};
    case ExperimentType::horizontal_wicking:
        return {{"wick_rate_mm2_s", most}, {"maximum_wetted_radius_top_mm", most}, {"absorbency_time_s", least}};
    case ExperimentType::moisture_management:
        return {{"ommc", most},
                {"one_way_transport_pct", most},
                {"spreading_speed_bottom_mm_s", most},
                {"absorption_rate_bottom_pct_s", most},
                {"wetting_time_top_s", least}};
    case ExperimentType::vertical_wicking: return {{"wick_height_mm", most}, {"wick_rate_mm_s05", most}};
    case ExperimentType::drying: return {{"time_to_dry_s", least}, {"drying_rate_g_m2_h", most}, {"surface_temperature_steady_c", least}};
    case ExperimentType::conditioning: return {{"regain_half_time_s", least}, {"regain_end", most}, {"temperature_peak_rise_c", least}};
    case ExperimentType::sweat: return {{"maximum_wetted_radius_bottom_mm", most}, {"maximum_wetted_radius_top_mm", most}};
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

std::string order_text(const Comparison& comparison)
{
    return comparison.ranked_by.name + (comparison.ranked_by.most_first ? ", the most first" : ", the least first");
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
    std::string text = fmt::format("# experiment={}\n# ranked_by={}\n# complete={}\nrank,fabric", one_line(comparison.experiment),
                                   order_text(comparison), comparison.complete ? "yes" : "no");
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
