// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Experiments on garments in the project's JSON.
#include "core/project/field_json.h"
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
    read_fields(air, climate);
    air.finish();
    return climate;
}

/// A list of factors, or the name of a file.
void read_activity(ObjectReader& object, WearExperiment& wear)
{
    const ProjectJson* value = object.find("activity");
    if (!value) return;
    if (value->is_string()) {
        object.read("activity", wear.activity_file);
        if (wear.activity_file.empty()) object.refuse("activity", "Name a CSV beside the project, or give a list of factors.");
        return;
    }
    const std::string path = object.path_of("activity");
    if (!value->is_array())
        object.refuse("activity", "This must be a list of factors or the name of a CSV; given is " + in_words(*value) + ".");
    const ProjectJson& list = array_in(*value, object.file(), path);
    std::vector<Activity> activity;
    for (std::size_t i = 0; i < list.size(); ++i) {
        ObjectReader moment(list[i], object.file(), fmt::format("{}[{}]", path, i));
        activity.emplace_back();
        read_fields(moment, activity.back());
        moment.finish({"time_s", "factor"});
    }
    wear.activity = std::move(activity);
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
    read_activity(object, wear);
    read_fields(object, wear);
    object.finish({"name", "garment"});
    return wear;
}

ProjectJson json_from_wear(const WearExperiment& wear)
{
    ProjectJson json{{"name", wear.name},
                     {"type", "wear"},
                     {"garment", wear.garment},
                     {"climate", json_of_fields(wear.climate)},
                     {"liquid", wear.liquid}};
    if (!wear.activity_file.empty()) {
        json["activity"] = wear.activity_file;
    } else {
        json["activity"] = ProjectJson::array();
        for (const Activity& moment : wear.activity) json["activity"].push_back(json_of_fields(moment));
    }
    write_fields(json, wear);
    return json;
}

} // namespace hygroloom
