// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/sim/plan_json.h"

#include "core/base/error.h"

#include <nlohmann/json.hpp>

namespace hygroloom {

using Json = nlohmann::ordered_json;

std::string plan_json(const ModelPlan& plan)
{
    Json parts = Json::array();
    for (const PlannedPart& p : plan.parts) parts.push_back({{"name", p.name}, {"on", p.on}, {"forced", p.forced}, {"reason", p.reason}});
    const Json json{
        {"fidelity", name_of(plan.fidelity)},
        {"parts", parts},
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
          {"frame_interval_s", plan.frame_interval},
          {"network_step_limit_s", plan.network_step_limit},
          {"saturation_change", plan.saturation_change},
          {"step_error", plan.step_error},
          {"density_tolerance", plan.density_tolerance},
          {"settle_share", plan.settle_share},
          {"reason", plan.resolution_reason}}},
        {"expected", {{"time_s", plan.expected_seconds}, {"memory_bytes", plan.expected_bytes}, {"source", plan.expectation_source}}},
    };
    return json.dump(2);
}

ModelPlan plan_from_json(const std::string& text)
try {
    const Json json = Json::parse(text);
    ModelPlan plan;
    plan.fidelity = fidelity_from_name(json.at("fidelity"));
    for (const Json& p : json.at("parts")) plan.parts.push_back({p.at("name"), p.at("on"), p.at("forced"), p.at("reason")});
    const Json& region = json.at("region");
    plan.region = {region.at("first_end"), region.at("first_pick"), region.at("ends"), region.at("picks")};
    plan.region_reason = region.at("reason");
    const Json& resolution = json.at("resolution");
    plan.particles_per_droplet = resolution.at("particles_per_droplet");
    plan.segments = resolution.at("segments");
    plan.fibre_shells = resolution.at("fibre_shells");
    plan.frame_interval = resolution.at("frame_interval_s");
    plan.network_step_limit = resolution.at("network_step_limit_s");
    plan.saturation_change = resolution.at("saturation_change");
    plan.step_error = resolution.value("step_error", 0.0);
    plan.density_tolerance = resolution.at("density_tolerance");
    plan.settle_share = resolution.value("settle_share", 0.0);
    plan.resolution_reason = resolution.at("reason");
    const Json& expected = json.at("expected");
    plan.expected_seconds = expected.at("time_s");
    plan.expected_bytes = expected.at("memory_bytes");
    plan.expectation_source = expected.at("source");
    return plan;
} catch (const Json::exception& e) {
    throw Error(std::string("The model plan cannot be read: ") + e.what());
}

} // namespace hygroloom
