// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Experiments on garments in the project's JSON.
#include "core/project/json_reader.h"
#include "core/project/project_json.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

Climate read_still_climate(ObjectReader& object, Climate climate)
{
    const ProjectJson* value = object.find("climate");
    if (!value) return climate;
    if (value->is_array()) object.refuse("climate", "The climate about a garment does not change; give one, not a list.");
    ObjectReader air(*value, object.file(), object.path_of("climate"));
    air.read("temperature_c", climate.temperature_c);
    air.read("relative_humidity", climate.relative_humidity);
    air.read("air_speed_m_s", climate.air_speed_m_s);
    air.finish();
    return climate;
}

std::vector<Activity> read_activity(ObjectReader& object, std::vector<Activity> standard)
{
    const ProjectJson* value = object.find("activity");
    if (!value) return standard;
    const std::string path = object.path_of("activity");
    const ProjectJson& list = array_in(*value, object.file(), path);
    std::vector<Activity> activity;
    for (std::size_t i = 0; i < list.size(); ++i) {
        ObjectReader moment(list[i], object.file(), fmt::format("{}[{}]", path, i));
        activity.emplace_back();
        moment.read("time_s", activity.back().time_s);
        moment.read("factor", activity.back().factor);
        moment.finish({"time_s", "factor"});
    }
    return activity;
}

} // namespace

bool is_wear(const ProjectJson& experiment)
{
    return experiment.is_object() && experiment.contains("type") && experiment["type"] == "wear";
}

WearExperiment wear_from_json(const ProjectJson& value, const std::string& file, const std::string& path)
{
    ObjectReader object(value, file, path);
    object.require("type");
    WearExperiment wear;
    object.read("name", wear.name);
    object.read("garment", wear.garment);
    wear.climate = read_still_climate(object, wear.climate);
    object.read("liquid", wear.liquid);
    object.read("duration_s", wear.duration_s);
    wear.activity = read_activity(object, wear.activity);
    object.read("initial_water_g_m2", wear.initial_water_g_m2);
    object.finish({"name", "garment"});
    return wear;
}

ProjectJson json_from_wear(const WearExperiment& wear)
{
    ProjectJson json{{"name", wear.name},
                     {"type", "wear"},
                     {"garment", wear.garment},
                     {"climate",
                      {{"temperature_c", wear.climate.temperature_c},
                       {"relative_humidity", wear.climate.relative_humidity},
                       {"air_speed_m_s", wear.climate.air_speed_m_s}}},
                     {"liquid", wear.liquid},
                     {"duration_s", wear.duration_s}};
    json["activity"] = ProjectJson::array();
    for (const Activity& moment : wear.activity) json["activity"].push_back({{"time_s", moment.time_s}, {"factor", moment.factor}});
    json["initial_water_g_m2"] = wear.initial_water_g_m2;
    return json;
}

} // namespace hygroloom
