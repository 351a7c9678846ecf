// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/plan_json.h"

#include "core/base/error.h"
#include "core/plan/frame_times.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace hygroloom {

using Json = nlohmann::ordered_json;

namespace {

Json knobs_json(const Knobs& knobs)
{
    Json json = Json::object();
    for (const KnobInfo& knob : knob_table()) {
        const double value = knobs.*knob.value;
        json[knob.name] = !knob.words.empty() ? Json(text_of(knob, value)) : knob.whole ? Json(static_cast<long>(value)) : Json(value);
    }
    return json;
}

/// Throws Error where it is none that fits: the plan may be a stranger's.
int whole_number(const Json& json)
{
    const double value = json.get<double>();
    if (!(std::abs(value) <= std::numeric_limits<int>::max()) || value != std::floor(value))
        throw Error(fmt::format("The model plan cannot be read: {:g} is no whole number that fits.", value));
    return static_cast<int>(value);
}

/// Recordings of older versions hold some of the knobs, among the resolution; the others are those of the fidelity.
Knobs knobs_from_json(const Json& plan, Fidelity fidelity)
{
    Knobs knobs = knobs_of(fidelity);
    const Json& values = plan.contains("knobs") ? plan.at("knobs") : plan.at("resolution");
    for (const KnobInfo& knob : knob_table()) {
        double& value = knobs.*knob.value;
        if (!knob.words.empty()) {
            if (values.contains(knob.name)) value = value_of(knob, values.at(knob.name).get<std::string>());
            continue;
        }
        value = values.value(knob.name, values.value(knob.old_name, value));
        if (knob.whole && !(std::abs(value) <= std::numeric_limits<int>::max()))
            throw Error(fmt::format("The model plan cannot be read: {} is {:g}.", knob.name, value));
    }
    // Before absorption had a knob of its own, yarns absorbed liquid that never rested at each of its steps.
    if (!values.contains("steps_between_absorption") && !values.contains("steps_between_drinks") && knobs.settle_share <= 0)
        knobs.steps_between_absorption = 1;
    if (!values.contains("crossings_per_cell")) knobs.crossings_per_cell = 1; // each was a cell
    if (!values.contains("crossings_per_even_cell")) knobs.crossings_per_even_cell = 1;
    return knobs;
}

/// Recordings of older versions lack the last ones.
SceneCounts counts_from_json(const Json& json)
{
    return {.type = json.at("type"),
            .closure = json.at("closure"),
            .drops = json.at("drops"),
            .landings = json.value("landings", 0.0),
            .drop_volume = json.at("drop_volume_m3"),
            .largest_drop = json.value("largest_drop_m3", json.at("drop_volume_m3").get<double>()),
            .landing_speed = json.value("landing_speed_m_s", 0.0),
            .sample_area = json.value("sample_area_m2", 0.0),
            .sample_edge = json.value("sample_edge_m", 0.0),
            .duration = json.at("duration_s"),
            .frames = json.value("frames", 0.0),
            .wet_share = json.at("wet_share"),
            .suction = json.at("suction"),
            .uptake = json.value("uptake_m3_s", 0.0),
            .pores = json.value("pores_m", 0.0),
            .drop_base = json.value("drop_base", 0.0),
            .capillarity = json.value("capillarity_m3_s2", 0.0),
            .viscosity = json.value("viscosity_m2_s", 0.0),
            .drawn_cubes = json.value("drawn_cubes", 0.0),
            .drawn_periods = json.value("drawn_periods", 1.0),
            .drawn_longest = json.value("drawn_longest", 0.0)};
}

Json json_of(const SceneCounts& counts)
{
    return {{"type", counts.type},
            {"drops", counts.drops},
            {"landings", counts.landings},
            {"drop_volume_m3", counts.drop_volume},
            {"largest_drop_m3", counts.largest_drop},
            {"landing_speed_m_s", counts.landing_speed},
            {"sample_area_m2", counts.sample_area},
            {"sample_edge_m", counts.sample_edge},
            {"duration_s", counts.duration},
            {"frames", counts.frames},
            {"wet_share", counts.wet_share},
            {"closure", counts.closure},
            {"suction", counts.suction},
            {"uptake_m3_s", counts.uptake},
            {"pores_m", counts.pores},
            {"drop_base", counts.drop_base},
            {"capillarity_m3_s2", counts.capillarity},
            {"viscosity_m2_s", counts.viscosity},
            {"drawn_cubes", counts.drawn_cubes},
            {"drawn_periods", counts.drawn_periods},
            {"drawn_longest", counts.drawn_longest}};
}

PlannedPart part_from_json(const Json& json)
{
    PlannedPart part{.name = json.at("name"),
                     .on = json.at("on"),
                     .forced = json.at("forced"),
                     .reason = json.at("reason"),
                     .watched = json.value("watched", false)};
    if (json.contains("share") && !json.at("share").is_null()) part.share = json.at("share").get<double>();
    return part;
}

/// By the names that knobs have now.
std::map<std::string, std::string> idle_knobs_from_json(const Json& json)
{
    auto knobs = json.get<std::map<std::string, std::string>>();
    for (const KnobInfo& knob : knob_table())
        if (auto before = knobs.extract(knob.old_name); !before.empty()) {
            before.key() = knob.name;
            knobs.insert(std::move(before));
        }
    return knobs;
}

} // namespace

Json plan_value(const ModelPlan& plan)
{
    Json parts = Json::array();
    for (const PlannedPart& p : plan.parts)
        parts.push_back({{"name", p.name},
                         {"on", p.on},
                         {"forced", p.forced},
                         {"share", p.share ? Json(*p.share) : Json(nullptr)},
                         {"watched", p.watched},
                         {"reason", p.reason}});
    return {
        {"fidelity", name_of(plan.fidelity)},
        {"fidelity_reason", plan.fidelity_reason},
        {"knobs", knobs_json(plan.knobs)},
        {"idle_knobs", plan.idle_knobs},
        {"parts", parts},
        {"water_at_stake_kg", plan.water_at_stake},
        {"region",
         {{"first_end", plan.region.first_end},
          {"first_pick", plan.region.first_pick},
          {"ends", plan.region.ends},
          {"picks", plan.region.picks},
          {"reason", plan.region_reason}}},
        {"resolution",
         {{"particles_per_droplet", plan.particles_per_droplet},
          {"segments", plan.segments},
          {"fibre_shells", plan.fibre_shells},
          {"crossings_per_cell", plan.crossings_per_cell},
          {"whole_bundles", plan.whole_bundles},
          {"shown_ends", plan.shown_ends},
          {"shown_picks", plan.shown_picks},
          {"not_in_cells", plan.not_in_cells},
          {"frame_interval_s", plan.frame_interval},
          {"network_step_limit_s", plan.knobs.network_step_limit},
          {"saturation_change", plan.knobs.saturation_change},
          {"step_error", plan.knobs.step_error},
          {"density_tolerance", plan.knobs.density_tolerance},
          {"settle_share", plan.knobs.settle_share},
          {"rest_tolerance", plan.rest_tolerance},
          {"reason", plan.resolution_reason}}},
        {"counts", json_of(plan.counts)},
        {"expected",
         {{"time_s", plan.expected_seconds},
          {"recording_s", recording_seconds(plan)},
          {"memory_bytes", plan.expected_bytes},
          {"error", plan.expected_error ? Json(*plan.expected_error) : Json(nullptr)},
          {"errors", plan.expected_errors},
          {"source", plan.expectation_source}}},
    };
}

std::string plan_json(const ModelPlan& plan) { return plan_value(plan).dump(2); }

ModelPlan plan_from_value(const Json& json)
try {
    ModelPlan plan;
    plan.fidelity = fidelity_from_name(json.at("fidelity"));
    plan.fidelity_reason = json.value("fidelity_reason", "");
    for (const Json& p : json.at("parts")) plan.parts.push_back(part_from_json(p));
    plan.water_at_stake = json.value("water_at_stake_kg", 0.0);
    if (json.contains("idle_knobs")) plan.idle_knobs = idle_knobs_from_json(json.at("idle_knobs"));
    const Json& region = json.at("region");
    plan.region = {whole_number(region.at("first_end")), whole_number(region.at("first_pick")), whole_number(region.at("ends")),
                   whole_number(region.at("picks"))};
    plan.region_reason = region.at("reason");
    const Json& resolution = json.at("resolution");
    plan.particles_per_droplet = whole_number(resolution.at("particles_per_droplet"));
    plan.segments = whole_number(resolution.at("segments"));
    plan.fibre_shells = whole_number(resolution.at("fibre_shells"));
    plan.crossings_per_cell = whole_number(resolution.value("crossings_per_cell", Json(1)));
    plan.whole_bundles = resolution.value("whole_bundles", false);
    plan.shown_ends = whole_number(resolution.value("shown_ends", Json(0)));
    plan.shown_picks = whole_number(resolution.value("shown_picks", Json(0)));
    plan.not_in_cells = resolution.value("not_in_cells", "");
    plan.frame_interval = resolution.at("frame_interval_s");
    plan.knobs = knobs_from_json(json, plan.fidelity);
    plan.rest_tolerance = resolution.value("rest_tolerance", 0.0);
    plan.resolution_reason = resolution.at("reason");
    if (json.contains("counts")) plan.counts = counts_from_json(json.at("counts"));
    const Json& expected = json.at("expected");
    if (expected.contains("error") && !expected.at("error").is_null()) plan.expected_error = expected.at("error").get<double>();
    if (expected.contains("errors"))
        for (const auto& [metric, error] : expected.at("errors").items()) plan.expected_errors[metric] = error.get<double>();
    plan.expected_seconds = expected.at("time_s");
    plan.expected_bytes = expected.at("memory_bytes");
    plan.expectation_source = expected.at("source");
    return plan;
} catch (const Json::exception&) {
    throw Error("The model plan cannot be read: its text is damaged, or of another version.");
}

ModelPlan plan_from_json(const std::string& text)
try {
    return plan_from_value(Json::parse(text));
} catch (const Json::exception&) {
    throw Error("The model plan cannot be read: its text is damaged, or of another version.");
}

Json switched_value(const std::vector<SwitchedPart>& parts)
{
    Json json = Json::array();
    for (const SwitchedPart& part : parts)
        json.push_back({{"name", part.name},
                        {"time_s", part.time},
                        {"share", part.share},
                        {"limit", part.limit},
                        {"estimate", part.estimate ? Json(*part.estimate) : Json(nullptr)},
                        {"kept_off", part.kept_off.empty() ? Json(nullptr) : Json(part.kept_off)}});
    return json;
}

std::string switched_json(const std::vector<SwitchedPart>& parts) { return switched_value(parts).dump(); }

std::vector<SwitchedPart> switched_from_value(const Json& list)
try {
    std::vector<SwitchedPart> parts;
    for (const Json& json : list) {
        SwitchedPart& part = parts.emplace_back();
        part.name = json.at("name");
        part.time = json.at("time_s");
        part.share = json.at("share");
        part.limit = json.at("limit");
        if (!json.at("estimate").is_null()) part.estimate = json.at("estimate").get<double>();
        if (!json.at("kept_off").is_null()) part.kept_off = json.at("kept_off");
    }
    return parts;
} catch (const Json::exception&) {
    throw Error("The parts that were switched on cannot be read: their text is damaged, or of another version.");
}

std::vector<SwitchedPart> switched_from_json(const std::string& text)
try {
    return switched_from_value(Json::parse(text));
} catch (const Json::exception&) {
    throw Error("The parts that were switched on cannot be read: their text is damaged, or of another version.");
}

} // namespace hygroloom
