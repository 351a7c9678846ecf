// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/metrics.h"

#include "core/base/units.h"
#include "core/plan/plan_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

std::vector<double> scaled(std::vector<double> values, double factor, double offset = 0)
{
    for (double& v : values) v = v * factor + offset;
    return values;
}

/// The tester's rings lie 5 mm apart and are wet or not.
double ring_mm(double radius) { return 5.0 * std::floor(mm_from_metre(radius) / 5.0 + 1e-9); }

/// The value, or null with a reason.
Json or_null(const std::optional<double>& value, double factor, const char* name, const char* why, Json& notes)
{
    if (value) return *value * factor;
    notes.push_back(std::string(name) + ": " + why);
    return nullptr;
}

void add_stain(Json& metrics, const Metrics& m)
{
    metrics["maximum_wetted_radius_top_mm"] = mm_from_metre(m.maximum_wetted_radius_top);
    metrics["maximum_wetted_radius_bottom_mm"] = mm_from_metre(m.maximum_wetted_radius_bottom);
    metrics["maximum_wetted_radius_top_ring_mm"] = ring_mm(m.maximum_wetted_radius_top);
    metrics["maximum_wetted_radius_bottom_ring_mm"] = ring_mm(m.maximum_wetted_radius_bottom);
    metrics["wetted_area_ellipse_warp_mm"] = mm_from_metre(m.wetted_area_ellipse_warp);
    metrics["wetted_area_ellipse_weft_mm"] = mm_from_metre(m.wetted_area_ellipse_weft);
}

void add_absorbency(Json& metrics, const Metrics& m, Json& notes)
{
    if (m.ledger.water_delivered <= 0) return;
    metrics["absorbency_time_s"] = or_null(m.absorbency_time, 1, "absorbency_time_s", "free liquid was left when the run ended.", notes);
    if (m.ledger.water_dripped > 0) notes.push_back("absorbency_time_s: some of the liquid was not drunk but dripped off.");
}

void add_management(Json& metrics, const ManagementIndices& m, Json& notes)
{
    const ManagementGrades grades = management_grades(m);
    const char* dry = "this face did not get wet during the test.";
    metrics["wetting_time_top_s"] = or_null(m.top.wetting_time, 1, "wetting_time_top_s", dry, notes);
    metrics["wetting_time_bottom_s"] = or_null(m.bottom.wetting_time, 1, "wetting_time_bottom_s", dry, notes);
    metrics["absorption_rate_top_pct_s"] = m.top.absorption_rate;
    metrics["absorption_rate_bottom_pct_s"] = m.bottom.absorption_rate;
    metrics["spreading_speed_top_mm_s"] = m.top.spreading_speed;
    metrics["spreading_speed_bottom_mm_s"] = m.bottom.spreading_speed;
    metrics["one_way_transport_pct"] = m.one_way_transport;
    metrics["ommc"] = m.ommc;
    metrics["grades"] = {{"wetting_time_top", grades.wetting_time_top},
                         {"wetting_time_bottom", grades.wetting_time_bottom},
                         {"absorption_rate_top", grades.absorption_rate_top},
                         {"absorption_rate_bottom", grades.absorption_rate_bottom},
                         {"maximum_wetted_radius_top", grades.maximum_wetted_radius_top},
                         {"maximum_wetted_radius_bottom", grades.maximum_wetted_radius_bottom},
                         {"spreading_speed_top", grades.spreading_speed_top},
                         {"spreading_speed_bottom", grades.spreading_speed_bottom},
                         {"one_way_transport", grades.one_way_transport},
                         {"ommc", grades.ommc}};
    metrics["fabric_class"] = fabric_class(m);
    notes.push_back("Simulated, not measured: a tester reads conductances; here the water content is the mass of water over the dry mass "
                    "within 5 mm of the middle.");
}

void add_drying(Json& metrics, const DryingResult& m, Json& notes)
{
    const char* short_of = "the run ended before 70 % of the water had dried.";
    metrics["drying_rate_g_m2_h"] = or_null(m.rate, 3.6e6, "drying_rate_g_m2_h", short_of, notes);
    metrics["time_to_dry_s"] =
        or_null(m.time_to_dry, 1, "time_to_dry_s", "more than 4 % of the water were left when the run ended.", notes);
    metrics["surface_temperature_steady_c"] = m.steady_temperature
                                                  ? Json(celsius_from_kelvin(*m.steady_temperature))
                                                  : or_null(std::nullopt, 1, "surface_temperature_steady_c", short_of, notes);
}

void add_conditioning(Json& metrics, const ConditioningResult& m, Json& notes)
{
    metrics["regain_start"] = m.regain_start;
    metrics["regain_end"] = m.regain_end;
    metrics["regain_half_time_s"] = or_null(m.half_time, 1, "regain_half_time_s", "the regain did not change.", notes);
    metrics["temperature_peak_rise_c"] = m.peak_rise;
    if (!m.settled) notes.push_back("regain_end: the sample was still changing when the run ended.");
}

/// What its type of experiment reports.
Json metrics_of(const RunRecord& run, const Metrics& m, Json& notes)
{
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    Json metrics = Json::object();
    switch (experiment ? experiment->type : ExperimentType::droplet) {
    case ExperimentType::droplet:
        add_stain(metrics, m);
        add_absorbency(metrics, m, notes);
        break;
    case ExperimentType::horizontal_wicking:
        add_stain(metrics, m);
        add_absorbency(metrics, m, notes);
        metrics["wick_rate_mm2_s"] = or_null(m.horizontal_rate, 1e6, "wick_rate_mm2_s", "nothing got wet.", notes);
        break;
    case ExperimentType::moisture_management:
        add_stain(metrics, m);
        if (m.management) add_management(metrics, *m.management, notes);
        break;
    case ExperimentType::vertical_wicking:
        if (!m.wicking) break;
        metrics["wick_height_mm"] = mm_from_metre(m.wicking->height);
        metrics["wick_rate_mm_s05"] = or_null(m.wicking->rate, 1e3, "wick_rate_mm_s05", "the liquid did not rise.", notes);
        break;
    case ExperimentType::drying:
        if (m.drying) add_drying(metrics, *m.drying, notes);
        break;
    case ExperimentType::conditioning:
        if (m.conditioning) add_conditioning(metrics, *m.conditioning, notes);
        break;
    case ExperimentType::sweat: add_stain(metrics, m); break;
    }
    return metrics;
}

/// Series of every run, and those of its type.
Json series_of(const Series& s)
{
    Json json{{"time_s", s.time},
              {"wetted_radius_top_mm", scaled(s.radius_top, 1e3)},
              {"wetted_radius_bottom_mm", scaled(s.radius_bottom, 1e3)},
              {"water_top_g", scaled(s.water_top, 1e3)},
              {"water_bottom_g", scaled(s.water_bottom, 1e3)},
              {"free_water_g", scaled(s.free_water, 1e3)},
              {"yarn_water_g", scaled(s.yarn_water, 1e3)},
              {"bound_water_g", scaled(s.bound_water, 1e3)},
              {"evaporated_g", scaled(s.evaporated, 1e3)},
              {"dripped_g", scaled(s.dripped, 1e3)},
              {"temperature_mean_c", scaled(s.temperature_mean, 1, -zero_celsius)},
              {"temperature_min_c", scaled(s.temperature_min, 1, -zero_celsius)},
              {"temperature_max_c", scaled(s.temperature_max, 1, -zero_celsius)},
              {"regain_mean", s.regain_mean},
              {"air_temperature_c", scaled(s.air_temperature, 1, -zero_celsius)}};
    if (!s.wick_height.empty()) json["wick_height_mm"] = scaled(s.wick_height, 1e3);
    if (!s.content_top.empty()) {
        json["water_content_top_pct"] = s.content_top;
        json["water_content_bottom_pct"] = s.content_bottom;
    }
    return json;
}

} // namespace

std::string metrics_json(const RunRecord& run, const Metrics& m)
{
    const Ledger& l = m.ledger;
    Json notes = m.notes;
    Json metrics = metrics_of(run, m, notes);
    if (!notes.empty()) metrics["notes"] = notes;

    const Json json{
        {"format", "hygroloom-metrics"},
        {"version", 1},
        {"provenance",
         {{"program", std::string("Hygroloom ") + HYGROLOOM_VERSION},
          {"commit", HYGROLOOM_COMMIT},
          {"simulated", true},
          {"fabric", run.fabric},
          {"experiment", run.experiment},
          {"backend", run.backend},
          {"device", run.device},
          {"fidelity", name_of(run.plan.fidelity)},
          {"seed", run.seed},
          {"wall_s", run.wall},
          {"simulated_s", l.time},
          {"plan", Json::parse(plan_json(run.plan))},
          {"switched_on", Json::parse(switched_json(run.switched_on))}}},
        {"metrics", metrics},
        {"series", series_of(m.series)},
        {"ledger",
         {{"water_in_kg", l.water_delivered},
          {"water_out_kg", l.water_evaporated + l.water_dripped},
          {"water_stored_kg", l.water_free + l.water_liquid + l.water_bound + l.water_vapour - l.water_initial},
          {"water_imbalance_kg", l.water_imbalance()},
          {"energy_released_j", l.energy_released},
          {"energy_imbalance_j", l.energy_imbalance()}}},
    };
    return json.dump(2);
}

} // namespace hygroloom
