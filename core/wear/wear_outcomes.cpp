// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A number of a garment is one row here, its computation in wear_metrics.cpp, and its test.
#include "core/wear/wear_outcomes.h"

#include "core/analysis/metrics_json.h"
#include "core/analysis/run_trace.h"
#include "core/base/text.h"
#include "core/base/units.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;
using At = const WearAt&;
using Value = std::optional<double>;

constexpr Better more = Better::more, less = Better::less, neither = Better::neither;
constexpr const char* share = "kg/kg"; // people read it in percent

/// Keys; the first ranks by default.
constexpr const char* compared[] = {"largest_wet_area_m2", "most_water_g", "on_skin_g", "evaporated_g", "time_to_dry_s"};

int rank_of(const std::string& key)
{
    const auto found = std::find(std::begin(compared), std::end(compared), key);
    return found == std::end(compared) ? 0 : static_cast<int>(found - std::begin(compared)) + 1;
}

/// g, beside all water that was given or there before.
bool is_rounding(double water, const WearMetrics& metrics)
{
    const Ledger& ledger = metrics.ledger();
    return std::abs(water) < 1e-9 * 1e3 * std::max(ledger.water_delivered, ledger.water_initial);
}

Outcome outcome_of(const WearNumber& number, At at)
{
    Outcome outcome;
    static_cast<OutcomeInfo&>(outcome) = number.info;
    outcome.value = number.value(at);
    if (!outcome.value) outcome.missing = number.missing;
    if (outcome.unit == "g" && outcome.value && is_rounding(*outcome.value, at.metrics)) outcome.value = 0;
    if (outcome.value && !std::isfinite(*outcome.value)) {
        outcome.value.reset();
        outcome.missing = "the computed value is not a finite number";
    }
    return outcome;
}

/// What a part's kind is called in keys and in titles.
struct Kind {
    const char *key, *title;
    const std::vector<WearPart>& (WearMetrics::*parts)() const;
};
constexpr Kind kinds[] = {{"panels", "panel ", &WearMetrics::panels}, {"zones", "zone ", &WearMetrics::zones}};

WearPartName name_of(const Kind& kind, const WearPart& part)
{
    return {fmt::format("{}/{}/", kind.key, part.name), kind.title + part.name};
}

OutcomeInfo of_part(OutcomeInfo info, const WearPartName& part)
{
    info.key = part.prefix + info.key;
    info.part = part.title;
    return info;
}

Json numbers_of(const WearMetrics& metrics, const WearPart& part)
{
    Json json;
    for (const Outcome& outcome : outcomes_of(metrics, part)) json[outcome.key] = outcome.value ? Json(*outcome.value) : Json(nullptr);
    return json;
}

Json series_of(const WearMetrics& metrics, const WearPart& part)
{
    Json series;
    for (const WearNow& now : part.course) series["time_s"].push_back(now.time);
    for (const WearNumber& number : wear_numbers())
        if (number.over_time) series[number.info.key] = course_of(metrics, part, number.info.key);
    return series;
}

} // namespace

const std::vector<WearNumber>& wear_numbers()
{
    constexpr bool negative = true, over_time = true, whole = true;
    static const std::vector<WearNumber> table{
        {{"area_m2", "area", "", "m²", neither}, [](At at) -> Value { return at.part.area; }, 3},
        {{"capacity_g_m2", "capacity", "", "g/m²", neither}, [](At at) -> Value { return 1e3 * at.part.capacity / at.part.in_cells; }},
        {{"water_g", "water", "", "g", less, false, negative}, [](At at) -> Value { return 1e3 * at.now.water; }, 2, over_time},
        {{"water_g_m2", "water per area", "", "g/m²", less, false, negative},
         [](At at) -> Value { return 1e3 * at.now.water / at.part.in_cells; },
         1},
        {{"most_water_g", "most water", "", "g", less}, [](At at) -> Value { return 1e3 * at.part.most_water(); }},
        {{"share_of_capacity", "share of capacity", "", share, less, false, negative},
         [](At at) -> Value { return at.now.water / at.part.capacity; },
         1},
        {{"share_inside", "share of it at the skin", "", share, less, false, negative},
         [](At at) { return at.now.water > 0 ? Value(at.now.inside / at.now.water) : Value(); },
         {},
         false,
         false,
         "there is no water"},
        {{"water_inside_g", "water at the skin's face", "", "g", less, false, negative},
         [](At at) -> Value { return 1e3 * at.now.inside; },
         {},
         over_time},
        {{"wet_area_m2", "wet area", "", "m²", less}, [](At at) -> Value { return at.now.wet_area; }, 3, over_time},
        {{"largest_wet_area_m2", "largest wet area", "", "m²", less}, [](At at) -> Value { return at.part.largest_wet_area(); }},
        {{"evaporated_g", "evaporated", "", "g", more, false, negative},
         [](At at) -> Value { return 1e3 * at.now.evaporated; },
         2,
         over_time},
        {{"on_skin_g", "on the skin", "", "g", less}, [](At at) -> Value { return 1e3 * at.now.on_skin; }, 2, over_time},
        {{"temperature_c", "temperature", "", "°C", neither, false, negative},
         [](At at) -> Value { return celsius_from_kelvin(at.now.temperature); },
         1,
         over_time},
        {{"time_to_full_s", "time until full", "", "s", more},
         [](At at) { return at.part.time_to_full(); },
         0,
         false,
         false,
         "it never holds 90 % of what it can"},
        {{"time_to_dry_s", "time to dry", "", "s", less},
         [](At at) { return at.metrics.stops() ? at.part.time_to_dry(*at.metrics.stops()) : Value(); },
         0,
         false,
         false,
         "it took up no water, is not left to dry, or more than 5 % of the most water is left"},
        {{"sweat_g", "sweat", "", "g", neither}, [](At at) -> Value { return 1e3 * at.metrics.sweat(); }, {}, false, whole},
        {{"initial_water_g", "water at the start", "", "g", neither},
         [](At at) -> Value { return 1e3 * at.metrics.at_start(); },
         {},
         false,
         whole},
        {{"dripped_g", "dripped", "", "g", less}, [](At at) -> Value { return 1e3 * at.metrics.ledger().water_dripped; }, {}, false, whole},
        {{"heat_from_skin_kj", "heat from the skin", "", "kJ", neither, false, negative},
         [](At at) -> Value { return 1e-3 * at.metrics.heat_from_skin(); },
         {},
         false,
         whole},
        {{"heat_of_evaporation_kj", "heat that evaporating took", "", "kJ", more, false, negative},
         [](At at) -> Value { return 1e-3 * at.metrics.heat_of_evaporation(); },
         {},
         false,
         whole}};
    return table;
}

const WearNumber& wear_number(const std::string& key)
{
    return *std::find_if(wear_numbers().begin(), wear_numbers().end(), [&](const WearNumber& number) { return number.info.key == key; });
}

std::vector<double> course_of(const WearMetrics& metrics, const WearPart& part, const std::string& key)
{
    const WearNumber& number = wear_number(key);
    std::vector<double> values;
    for (const WearNow& now : part.course) values.push_back(number.value({metrics, part, now}).value_or(std::nan("")));
    return values;
}

std::vector<Outcome> outcomes_of(const WearMetrics& metrics, const WearPart& part)
{
    std::vector<Outcome> outcomes;
    for (const WearNumber& number : wear_numbers()) {
        if (number.of_whole_only && &part != &metrics.all()) continue;
        outcomes.push_back(outcome_of(number, {metrics, part, part.course.back()}));
    }
    return outcomes;
}

std::vector<Outcome> outcomes_of(const WearMetrics& metrics)
{
    std::vector<Outcome> outcomes = outcomes_of(metrics, metrics.all());
    for (Outcome& outcome : outcomes) outcome.rank = rank_of(outcome.key);
    for (const Kind& kind : kinds)
        for (const WearPart& part : (metrics.*kind.parts)())
            for (Outcome& outcome : outcomes_of(metrics, part)) {
                static_cast<OutcomeInfo&>(outcome) = of_part(outcome, name_of(kind, part));
                outcomes.push_back(std::move(outcome));
            }
    return outcomes;
}

std::vector<WearPartName> parts_in(const std::vector<Outcome>& outcomes)
{
    std::vector<WearPartName> parts{{}};
    for (const Outcome& outcome : outcomes) {
        const WearPartName part{outcome.key.substr(0, outcome.key.rfind('/') + 1), outcome.part};
        if (part != parts.back() && !part.prefix.empty()) parts.push_back(part);
    }
    return parts;
}

std::vector<OutcomeInfo> compared_by_wear(const WearPartName& part)
{
    std::vector<OutcomeInfo> infos;
    for (const char* key : compared) infos.push_back(of_part(wear_number(key).info, part));
    return infos;
}

std::vector<OutcomeInfo> worn_curves(const WearPartName& part)
{
    std::vector<OutcomeInfo> infos;
    for (const WearNumber& number : wear_numbers())
        if (number.over_time) infos.push_back(of_part(number.info, part));
    return infos;
}

std::map<std::string, std::vector<double>> courses_of(const WearMetrics& metrics, const std::vector<double>& times)
{
    std::map<std::string, std::vector<double>> courses;
    const auto add = [&](const WearPart& part, const WearPartName& name) {
        std::vector<double> time;
        for (const WearNow& now : part.course) time.push_back(now.time);
        for (const WearNumber& number : wear_numbers())
            if (number.over_time)
                courses[name.prefix + number.info.key] = values_at(times, time, course_of(metrics, part, number.info.key));
    };
    add(metrics.all(), {});
    for (const Kind& kind : kinds)
        for (const WearPart& part : (metrics.*kind.parts)()) add(part, name_of(kind, part));
    return courses;
}

std::string wear_json(const WearMetrics& metrics, const std::map<std::string, Interval>& intervals)
{
    Json json;
    json["garment"] = metrics.all().name;
    json["time_s"] = metrics.all().course.back().time;
    json["metrics"] = numbers_of(metrics, metrics.all());
    if (!intervals.empty()) json["intervals"] = intervals_value(intervals);
    json["water_imbalance"] = metrics.imbalance();
    for (const Kind& kind : kinds)
        for (const WearPart& part : (metrics.*kind.parts)()) json[kind.key][part.name] = numbers_of(metrics, part);
    json["series"] = series_of(metrics, metrics.all());
    for (const Kind& kind : kinds)
        for (const WearPart& part : (metrics.*kind.parts)()) json["series"][kind.key][part.name] = series_of(metrics, part);
    return json.dump(2);
}

std::string text_in_table(const WearNumber& number, double value, const ReaderUnits& units)
{
    const ShownValue seen = shown(number.info, value);
    const ReaderUnit own = reader_unit(units, seen.unit);
    const int decimals = std::max(0, *number.decimals - static_cast<int>(std::lround(std::log10(own.per_one))));
    const double there = own.of(seen.value), least = 0.5 * std::pow(10.0, -decimals);
    return fmt::format("{:.{}f}", std::abs(there) < least ? 0.0 : there, decimals);
}

std::string table_of_parts(const WearMetrics& metrics)
{
    const auto value_of = [&](const WearNumber& number, const WearPart& part) { return number.value({metrics, part, part.course.back()}); };
    std::vector<const WearNumber*> columns; // those that some part has
    for (const WearNumber& number : wear_numbers())
        if (number.decimals && std::any_of(metrics.panels().begin(), metrics.panels().end(),
                                           [&](const WearPart& panel) { return value_of(number, panel).has_value(); }))
            columns.push_back(&number);
    std::vector<std::vector<std::string>> rows(2, {""});
    for (const WearNumber* number : columns) {
        rows[0].push_back(number->info.title);
        rows[1].push_back(shown(number->info, 0).unit);
    }
    const auto add = [&](const WearPart& part) {
        rows.push_back({part.name});
        for (const WearNumber* number : columns) {
            const Value value = value_of(*number, part);
            rows.back().push_back(value ? text_in_table(*number, *value) : "-");
        }
    };
    for (const WearPart& panel : metrics.panels()) add(panel);
    rows.push_back({"by zone of the body"});
    for (const WearPart& zone : metrics.zones()) add(zone);
    return aligned_columns(rows);
}

} // namespace hygroloom
