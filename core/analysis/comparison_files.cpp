// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A comparison as text, JSON and CSV.
#include "core/analysis/card.h"
#include "core/analysis/comparison.h"
#include "core/analysis/metrics_json.h"
#include "core/analysis/why_json.h"
#include "core/base/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

std::string one_line(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

bool most_first(const OutcomeInfo& criterion) { return criterion.better != Better::less; }
const char* order_words(const OutcomeInfo& criterion) { return most_first(criterion) ? "largest first" : "smallest first"; }

using Row = std::vector<std::string>;

std::string numbers_table(const Comparison& comparison)
{
    Row titles{comparison.of_garments ? "    garment" : "    fabric"}, units{""};
    for (const OutcomeInfo& criterion : comparison.criteria) {
        titles.push_back(full_title(criterion));
        units.push_back(shown(criterion, 0).unit);
    }
    titles.push_back(comparison.replicates > 1 ? "time of all runs" : "run time");
    units.push_back("s");
    std::vector<Row> rows{titles, units};
    for (const Candidate& c : comparison.candidates) {
        const std::string rank = c.rank == 0 ? "- " : rank_text(c) + (c.tied ? "" : " ");
        const std::string name = fmt::format("{:>3} {}", rank, c.fabric);
        if (!c.failure.empty()) {
            rows.push_back({name, c.failure});
            continue;
        }
        Row row{name};
        for (const OutcomeInfo& criterion : comparison.criteria) {
            const auto found = c.intervals.find(criterion.key);
            row.push_back(found == c.intervals.end() ? "-" : with_interval(criterion, found->second));
        }
        row.push_back(fmt::format("{:.3g}", c.wall));
        rows.push_back(row);
        Row measured{"    measured"};
        bool any = false;
        for (const OutcomeInfo& criterion : comparison.criteria) {
            const LaboratoryValue* value = measured_of(comparison, c.fabric, criterion.key);
            any = any || value;
            const auto spread = value && value->spread ? fmt::format(" ± {:.3g}", *value->spread) : std::string();
            measured.push_back(value ? fmt::format("{:.4g}{}", value->value, spread) : "");
        }
        if (any) rows.push_back(measured);
    }
    return aligned_columns(rows);
}

std::string verdicts_table(const Comparison& comparison)
{
    if (comparison.verdicts.empty()) return {};
    Row titles{"    against " + comparison.baseline};
    for (const OutcomeInfo& criterion : comparison.criteria) titles.push_back(full_title(criterion));
    std::vector<Row> rows{titles};
    for (const Candidate& c : comparison.candidates) {
        if (c.fabric == comparison.baseline || !c.failure.empty()) continue;
        Row row{"    " + c.fabric};
        for (const OutcomeInfo& criterion : comparison.criteria) {
            const Compared* found = verdict_of(comparison, c.fabric, criterion.key);
            const LoneNumber* lone = lone_number_of(comparison, c.fabric, criterion.key);
            row.push_back(found ? name_of(found->verdict) : lone ? lone->words : "-");
        }
        rows.push_back(row);
    }
    return "\n" + aligned_columns(rows);
}

/// A line a number, a column a fabric.
std::string cards_table(const Comparison& comparison)
{
    if (comparison.cards.empty()) return {};
    std::vector<Row> rows{{"    technical card"}};
    for (const Candidate& c : comparison.candidates) rows[0].push_back(c.fabric);
    for (const LaboratoryNumber* number : card_numbers(comparison)) {
        rows.push_back({fmt::format("    {}{}", number->title, number->unit.empty() ? "" : ", " + number->unit)});
        for (const Candidate& c : comparison.candidates) {
            const LaboratoryNumber* own = card_number_of(comparison, c.fabric, number->key);
            const std::string range = own ? range_text(own->estimate) : std::string();
            rows.back().push_back(!own ? "-" : value_text(*own) + (range.empty() ? "" : " (" + range + ")"));
        }
    }
    return "\n" + aligned_columns(rows);
}

Json verdicts_value(const Comparison& comparison)
{
    Json json = Json::array();
    for (const Compared& found : comparison.verdicts)
        json.push_back({{"metric", found.metric},
                        {"fabric", found.fabric},
                        {"baseline", found.baseline},
                        {"verdict", name_of(found.verdict)},
                        {"share_of_pairs", found.share_of_pairs},
                        {"pairs", found.pairs},
                        {"difference", found.difference},
                        {"low", found.low},
                        {"high", found.high}});
    for (const LoneNumber& lone : comparison.lone)
        json.push_back({{"metric", lone.metric},
                        {"fabric", lone.fabric},
                        {"baseline", lone.baseline},
                        {"verdict", lone.fabric_has ? "only fabric has it" : "only baseline has it"},
                        {"sentence", lone.sentence}});
    return json;
}

} // namespace

const Compared* verdict_of(const Comparison& comparison, const std::string& fabric, const std::string& metric)
{
    for (const Compared& found : comparison.verdicts)
        if (found.fabric == fabric && found.metric == metric) return &found;
    return nullptr;
}

const LoneNumber* lone_number_of(const Comparison& comparison, const std::string& fabric, const std::string& metric)
{
    for (const LoneNumber& lone : comparison.lone)
        if (lone.fabric == fabric && lone.metric == metric) return &lone;
    return nullptr;
}

const LaboratoryValue* measured_of(const Comparison& comparison, const std::string& fabric, const std::string& metric)
{
    for (const LaboratoryValue& value : comparison.measured)
        if (value.fabric == fabric && value.metric == metric) return &value;
    return nullptr;
}

const LaboratoryNumber* card_number_of(const Comparison& comparison, const std::string& fabric, const std::string& key)
{
    const auto card = comparison.cards.find(fabric);
    if (card == comparison.cards.end()) return nullptr;
    const std::vector<LaboratoryNumber>& all = card->second.found;
    const auto number = std::find_if(all.begin(), all.end(), [&](const LaboratoryNumber& own) { return own.key == key; });
    return number == all.end() ? nullptr : &*number;
}

std::vector<const LaboratoryNumber*> card_numbers(const Comparison& comparison)
{
    std::vector<const LaboratoryNumber*> all;
    for (const auto& [fabric, card] : comparison.cards) {
        auto next = all.begin();
        for (const LaboratoryNumber& number : card.found) {
            const auto same = std::find_if(all.begin(), all.end(), [&](const LaboratoryNumber* own) { return own->key == number.key; });
            next = (same == all.end() ? all.insert(next, &number) : same) + 1;
        }
    }
    return all;
}

std::string with_interval(const OutcomeInfo& criterion, const Interval& interval, const ReaderUnits& units)
{
    const ShownInterval own = shown(criterion, interval), seen = units ? in_unit(own, units(own.unit)) : own;
    if (seen.cut)
        return fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", seen.value, seen.decimals, seen.low, seen.decimals, seen.high, seen.decimals);
    return seen.half > 0 ? fmt::format("{:.{}f} ± {:.{}f}", seen.value, seen.decimals, seen.half, seen.decimals)
                         : fmt::format("{:.4g}", seen.value);
}

std::string basis_text(const Comparison& comparison)
{
    const std::string few = few_replicates_text(comparison.replicates);
    if (comparison.of_garments)
        return comparison.replicates > 1
                   ? (few.empty() ? few : few + " ") +
                         fmt::format(
                             "Intervals hold {:.0f} % of such garments: {} replicates draw the inputs of their fabrics that are not "
                             "known, alike for all. 2 % stand for the size of the panels' cells; other numerical errors and the model's "
                             "own are not in them.",
                             100 * of_intervals.held, comparison.replicates)
                   : "Sizes get no verdict: the numerical error of garments is not known, and one run of each shows no scatter.";
    return comparison.replicates > 1
               ? (few.empty() ? few : few + " ") +
                     fmt::format("Intervals hold {:.0f} % of such cloths: {} replicates draw the inputs that are not known, the yarns' "
                                 "unevenness and the place of the drops, alike for all fabrics; the numerical error is added. The model's "
                                 "own error is not in them.",
                                 100 * of_intervals.held, comparison.replicates)
               : "Intervals and verdicts rest on the numerical error alone; 8 replicates of each fabric add what is not known of the "
                 "cloths "
                 "and their scatter.";
}

std::string comparison_table(const Comparison& comparison)
{
    std::string text =
        fmt::format("{}: ranked by {} ({})\n", comparison.experiment, full_title(comparison.ranked_by), order_words(comparison.ranked_by));
    text += numbers_table(comparison) + verdicts_table(comparison) + cards_table(comparison);
    text += "\n  " + basis_text(comparison) + (comparison.replicates > 1 ? "\n" : " Ask for them with --replicates 8.\n");
    for (const LoneNumber& lone : comparison.lone) text += "  " + lone.sentence + "\n";
    for (const Candidate& c : comparison.candidates)
        for (const std::string& note : all_notes(comparison, c)) text += fmt::format("  {}: {}\n", c.fabric, note);
    if (comparison.why) text += why_text(*comparison.why);
    return text;
}

std::string comparison_json(const Comparison& comparison)
{
    Json candidates = Json::array();
    for (const Candidate& c : comparison.candidates) {
        Json candidate{{"rank", c.rank > 0 ? Json(c.rank) : Json(nullptr)}, {"tied", c.tied}, {"fabric", c.fabric}};
        if (c.run && c.metrics)
            candidate["run"] = metrics_value(*c.run, *c.metrics, c.intervals);
        else if (c.worn)
            candidate["run"] = Json::parse(c.worn->json);
        else
            candidate["failure"] = c.failure;
        if (c.worn && !c.intervals.empty()) candidate["run"]["intervals"] = intervals_value(c.intervals);
        if (comparison.replicates > 1) candidate["drawn"] = c.unknowns;
        if (comparison.replicates > 1) candidate["notes"] = all_notes(comparison, c);
        for (const LaboratoryValue& value : comparison.measured)
            if (value.fabric == c.fabric)
                candidate["measured"][value.metric] = {{"value", value.value},
                                                       {"spread", value.spread ? Json(*value.spread) : Json(nullptr)}};
        if (const auto card = comparison.cards.find(c.fabric); card != comparison.cards.end()) {
            candidate["laboratory"] = laboratory_json(card->second.found);
            if (!card->second.missing.empty()) candidate["laboratory_missing"] = card->second.missing;
        }
        candidates.push_back(std::move(candidate));
    }
    Json json{{"format", "hygroloom-comparison"},
              {"version", 1},
              {"experiment", comparison.experiment},
              {"ranked_by", comparison.ranked_by.key},
              {"first", most_first(comparison.ranked_by) ? "most" : "least"},
              {"baseline", comparison.baseline},
              {"replicates", comparison.replicates},
              {"basis", basis_text(comparison)},
              {"complete", comparison.complete},
              {"candidates", candidates},
              {"verdicts", verdicts_value(comparison)}};
    if (comparison.why) json["why"] = why_value(*comparison.why);
    return json.dump(2) + "\n";
}

std::string comparison_csv(const Comparison& comparison)
{
    std::string text = fmt::format("# experiment={}\n# ranked_by={}\n# baseline={}\n# replicates={}\n# complete={}\n",
                                   one_line(comparison.experiment), comparison.ranked_by.key + ", " + order_words(comparison.ranked_by),
                                   one_line(comparison.baseline), comparison.replicates, comparison.complete ? "yes" : "no");
    const auto& all = comparison.candidates;
    if (std::any_of(all.begin(), all.end(), [](const Candidate& c) { return c.timed > 0 && c.timed < runs_of(c); }))
        text += "# wall_s=of the run of the cloth as given; no times of the replicates are kept\n";
    text += "rank,fabric";
    const bool measured = !comparison.measured.empty();
    for (const OutcomeInfo& criterion : comparison.criteria) {
        text += fmt::format(",{0},{0}_low,{0}_high,{0}_verdict", criterion.key);
        if (measured) text += fmt::format(",{}_measured", criterion.key);
    }
    const std::vector<const LaboratoryNumber*> numbers = card_numbers(comparison);
    for (const LaboratoryNumber* number : numbers) text += fmt::format(",{0},{0}_low,{0}_high", number->key);
    text += ",wall_s,notes\n";
    for (const Candidate& c : comparison.candidates) {
        text += (c.rank > 0 ? std::to_string(c.rank) : std::string()) + "," + quoted_csv_field(c.fabric);
        for (const OutcomeInfo& criterion : comparison.criteria) {
            const auto found = c.intervals.find(criterion.key);
            const bool there = found != c.intervals.end();
            text += there ? fmt::format(",{:.6g},{:.6g},{:.6g}", found->second.centre, found->second.low, found->second.high) : ",,,";
            const Compared* verdict = verdict_of(comparison, c.fabric, criterion.key);
            const LoneNumber* lone = lone_number_of(comparison, c.fabric, criterion.key);
            text += std::string(",") + (verdict ? name_of(verdict->verdict) : lone ? quoted_csv_field(lone->words) : "");
            const LaboratoryValue* value = measured_of(comparison, c.fabric, criterion.key);
            if (measured) text += value ? fmt::format(",{:.6g}", value->value) : ",";
        }
        for (const LaboratoryNumber* number : numbers) {
            const LaboratoryNumber* own = card_number_of(comparison, c.fabric, number->key);
            text += own ? fmt::format(",{:.6g},{:.6g},{:.6g}", own->estimate.value, own->estimate.low, own->estimate.high) : ",,,";
        }
        std::string notes = c.failure;
        for (const std::string& note : all_notes(comparison, c)) notes += (notes.empty() ? "" : " ") + note;
        text += fmt::format(",{:.4g},{}\n", c.wall, quoted_csv_field(notes));
    }
    return text;
}

} // namespace hygroloom
