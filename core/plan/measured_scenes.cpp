// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What tradeoff wrote of the measured scenes, as expectations read it.
#include "core/base/error.h"
#include "core/plan/expectation.h"
#include "core/plan/plan_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace hygroloom {

extern const char measured_scenes_json[];

namespace {

using Json = nlohmann::ordered_json;

std::map<std::string, double> metric_errors(const Json& errors)
{
    std::map<std::string, double> all;
    for (const auto& [metric, value] : errors.at("metrics").items())
        if (!value.at("value").is_null() && !value.at("reference").is_null()) all[metric] = value.at("error");
    return all;
}

/// The largest error of what is meant for use. When a stain comes to rest is not: the last segment that gets wet decides it, and its error
/// of up to 77 % would stand for that of all others.
double largest_used(const Json& errors)
{
    double largest = errors.at("wetted_overlap").is_null() ? 0 : 1 - errors.at("wetted_overlap").get<double>();
    for (const auto& [metric, value] : errors.at("metrics").items())
        if (metric != "time_of_arrest_s") largest = std::max(largest, value.at("error").get<double>());
    return largest;
}

MeasuredScene scene_from(const Json& json)
{
    MeasuredScene scene;
    scene.fabric = json.at("scene").at("fabric");
    scene.experiment = json.at("scene").at("experiment");
    scene.backend = json.at("provenance").at("backend");
    scene.device = json.at("provenance").at("device");
    scene.date = json.at("provenance").at("date").get<std::string>().substr(0, 10);
    const Json& load = json.at("provenance").at("load_at_start");
    if (!load.is_null()) scene.load = load;
    for (const Json& step : json.at("convergence"))
        for (const auto& [metric, error] : metric_errors(step.at("errors"))) scene.reference_errors[metric] += error;
    for (const Json& p : json.at("points")) {
        const bool timed = !p.at("wall_s").is_null() && !p.at("peak_bytes").is_null();
        if (!timed && p.at("errors").is_null()) continue;
        MeasuredRun run;
        run.plan = plan_from_value(p.at("plan"));
        for (const auto& [name, value] : p.at("set").items()) run.settings[name] = value;
        if (timed) run.seconds = p.at("wall_s");
        if (timed) run.bytes = p.at("peak_bytes");
        const SceneCounts& counts = run.plan.counts;
        if (run.plan.on("liquid") && !(counts.capillarity > 0 && counts.drop_base > 0))
            throw Error("It is older than the program: the liquid's capillarity or the drop's base is missing.");
        if (!p.at("errors").is_null()) {
            run.error = largest_used(p.at("errors"));
            run.errors = metric_errors(p.at("errors"));
        }
        scene.runs.push_back(std::move(run));
    }
    return scene;
}

/// Both backends compute the same: where a scene's reference was refined on one of them only, its own error holds on the other as well.
void share_errors_of_references(std::vector<MeasuredScene>& scenes)
{
    for (MeasuredScene& scene : scenes)
        for (const MeasuredScene& other : scenes)
            if (scene.reference_errors.empty() && scene.is_of(other)) scene.reference_errors = other.reference_errors;
}

} // namespace

MeasuredScene measured_scene(const std::string& json, const std::string& file)
try {
    return scene_from(Json::parse(json));
} catch (const std::exception& e) {
    throw Error(fmt::format("{}: The measured trade-off cannot be read: {}", file, e.what()));
}

const std::vector<MeasuredScene>& shipped_measurements()
{
    static const std::vector<MeasuredScene> scenes = [] {
        std::vector<MeasuredScene> list;
        for (const Json& scene : Json::parse(measured_scenes_json)) list.push_back(scene_from(scene));
        share_errors_of_references(list);
        return list;
    }();
    return scenes;
}

const std::vector<MeasuredScene>& shipped_measurements(const std::string& backend)
{
    static const std::map<std::string, std::vector<MeasuredScene>> scenes = [] {
        std::map<std::string, std::vector<MeasuredScene>> lists;
        for (const MeasuredScene& scene : shipped_measurements()) lists[scene.backend].push_back(scene);
        return lists;
    }();
    static const std::vector<MeasuredScene> none;
    const auto found = scenes.find(backend);
    return found == scenes.end() ? none : found->second;
}

} // namespace hygroloom
