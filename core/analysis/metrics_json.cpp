// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/metrics.h"

#include "core/base/units.h"
#include "core/sim/plan_json.h"

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

} // namespace

std::string metrics_json(const RunRecord& run, const Metrics& m)
{
    const Ledger& l = m.ledger;
    Json metrics{
        {"maximum_wetted_radius_top_mm", mm_from_metre(m.maximum_wetted_radius_top)},
        {"maximum_wetted_radius_bottom_mm", mm_from_metre(m.maximum_wetted_radius_bottom)},
        {"maximum_wetted_radius_top_ring_mm", ring_mm(m.maximum_wetted_radius_top)},
        {"maximum_wetted_radius_bottom_ring_mm", ring_mm(m.maximum_wetted_radius_bottom)},
        {"wetted_area_ellipse_warp_mm", mm_from_metre(m.wetted_area_ellipse_warp)},
        {"wetted_area_ellipse_weft_mm", mm_from_metre(m.wetted_area_ellipse_weft)},
    };
    Json notes = m.notes;
    if (l.water_delivered > 0) {
        metrics["absorbency_time_s"] = m.absorbency_time ? Json(*m.absorbency_time) : Json(nullptr);
        if (!m.absorbency_time) notes.push_back("absorbency_time_s: free liquid was left when the run ended.");
        if (l.water_dripped > 0) notes.push_back("absorbency_time_s: some of the liquid was not drunk but dripped off.");
    }
    if (!notes.empty()) metrics["notes"] = notes;

    const Series& s = m.series;
    const Json json{
        {"format", "hygroloom-metrics"},
        {"version", 1},
        {"provenance",
         {{"program", std::string("Hygroloom ") + HYGROLOOM_VERSION}, {"commit", HYGROLOOM_COMMIT}, {"simulated", true}, {"fabric", run.fabric},
          {"experiment", run.experiment}, {"backend", run.backend}, {"device", run.device}, {"fidelity", name_of(run.plan.fidelity)},
          {"seed", run.seed}, {"wall_s", run.wall}, {"simulated_s", l.time}, {"plan", Json::parse(plan_json(run.plan))}}},
        {"metrics", metrics},
        {"series",
         {{"time_s", s.time}, {"wetted_radius_top_mm", scaled(s.radius_top, 1e3)}, {"wetted_radius_bottom_mm", scaled(s.radius_bottom, 1e3)},
          {"water_top_g", scaled(s.water_top, 1e3)}, {"water_bottom_g", scaled(s.water_bottom, 1e3)}, {"free_water_g", scaled(s.free_water, 1e3)},
          {"yarn_water_g", scaled(s.yarn_water, 1e3)}, {"bound_water_g", scaled(s.bound_water, 1e3)}, {"evaporated_g", scaled(s.evaporated, 1e3)},
          {"dripped_g", scaled(s.dripped, 1e3)}, {"temperature_mean_c", scaled(s.temperature_mean, 1, -zero_celsius)},
          {"temperature_min_c", scaled(s.temperature_min, 1, -zero_celsius)}, {"temperature_max_c", scaled(s.temperature_max, 1, -zero_celsius)},
          {"regain_mean", s.regain_mean}}},
        {"ledger",
         {{"water_in_kg", l.water_delivered}, {"water_out_kg", l.water_evaporated + l.water_dripped},
          {"water_stored_kg", l.water_free + l.water_liquid + l.water_bound + l.water_vapour - l.water_initial},
          {"water_imbalance_kg", l.water_imbalance()}, {"energy_released_j", l.energy_released}, {"energy_imbalance_j", l.energy_imbalance()}}},
    };
    return json.dump(2);
}

} // namespace hygroloom
