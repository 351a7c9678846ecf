// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/metrics_json.h"

#include "core/analysis/outcomes.h"
#include "core/analysis/series_keys.h"
#include "core/base/units.h"
#include "core/base/version.h"
#include "core/plan/plan_json.h"

#include <nlohmann/json.hpp>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

Json series_value(const Series& series)
{
    Json json = Json::object();
    for (const SeriesKey& of : series_keys())
        if (of.of_all || !(series.*of.values).empty()) json[of.key] = values_of(of, series);
    return json;
}

/// The numbers, then grades and classes, then the notes.
Json outcomes_value(const RunRecord& run, const Metrics& m)
{
    Json json = Json::object(), notes = notes_of(m);
    const std::vector<Outcome> outcomes = outcomes_of(run, m);
    for (const Outcome& outcome : outcomes) {
        if (!outcome.text.empty()) continue;
        json[outcome.key] = outcome.value ? Json(*outcome.value) : Json(nullptr);
        for (const std::string& why : {outcome.missing, outcome.remark})
            if (!why.empty()) notes.push_back(outcome.key + ": " + why + ".");
    }
    if (m.management && !is_part_of_test(run, m)) {
        const ManagementGrades grades = management_grades(*m.management);
        for (const GradeName& name : grade_names) json["grades"][name.key] = grades.*name.grade;
    }
    for (const Outcome& outcome : outcomes)
        if (!outcome.text.empty()) json[outcome.key] = outcome.text;
    if (!notes.empty()) json["notes"] = notes;
    if (!m.assumed.empty()) json["assumed"] = m.assumed;
    return json;
}

Json part(const std::optional<double>& half_width) { return half_width ? Json(*half_width) : Json(nullptr); }

} // namespace

Json intervals_value(const std::map<std::string, Interval>& intervals)
{
    Json json = Json::object();
    for (const auto& [metric, i] : intervals) {
        Json parts{{"numerical", i.numerical_known ? Json(i.numerical) : Json(nullptr)}};
        if (i.spread)
            parts["scatter_and_input"] = *i.spread;
        else
            parts.update({{"scatter", part(i.scatter)}, {"input", part(i.input)}});
        json[metric] = {{"value", i.centre},          {"low", i.low},   {"high", i.high},
                        {"level", of_intervals.held}, {"runs", i.runs}, {"parts", parts},
                        {"model", {{"known", false}}}};
    }
    return json;
}

Json metrics_value(const RunRecord& run, const Metrics& m, const std::map<std::string, Interval>& intervals)
{
    const Ledger& l = m.ledger;
    return {
        {"format", "hygroloom-metrics"},
        {"version", 1},
        {"provenance",
         {{"program", std::string("Hygroloom ") + program_version()},
          {"commit", program_commit()},
          {"simulated", true},
          {"fabric", run.fabric},
          {"experiment", run.experiment},
          {"backend", run.backend},
          {"device", run.device},
          {"fidelity", name_of(run.plan.fidelity)},
          {"seed", run.seed},
          {"wall_s", run.wall},
          {"simulated_s", l.time},
          {"plan", plan_value(run.plan)},
          {"switched_on", switched_value(run.switched_on)}}},
        {"metrics", outcomes_value(run, m)},
        {"intervals", intervals_value(intervals.empty() ? numerical_intervals(run, m) : intervals)},
        {"series", series_value(m.series)},
        {"ledger",
         {{"water_in_kg", l.water_delivered},
          {"water_out_kg", l.water_evaporated + l.water_dripped},
          {"water_stored_kg", l.water_free + l.water_liquid + l.water_bound + l.water_vapour - l.water_initial},
          {"water_imbalance_kg", l.water_imbalance()},
          {"energy_released_j", l.energy_released},
          {"energy_imbalance_j", l.energy_imbalance()}}},
    };
}

std::string metrics_json(const RunRecord& run, const Metrics& metrics, const std::map<std::string, Interval>& intervals)
{
    return metrics_value(run, metrics, intervals).dump(2);
}

} // namespace hygroloom
