// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What tradeoff wrote of the measured scenes, as expectations read it.
#include "core/base/error.h"
#include "core/plan/expectation.h"
#include "core/plan/plan_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>

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
/// of up to 77 % would stand for that of all others. Nor are what fell through holes and what lies between yarns in the end, of which there
/// may be next to nothing: contents in kg are shares of all water.
double largest_used(const Json& errors, bool has_edge)
{
    const std::set<std::string> unused{"time_of_arrest_s", "water_shed_below_g", "water_between_yarns_g"};
    double largest = !has_edge || errors.at("wetted_overlap").is_null() ? 0 : 1 - errors.at("wetted_overlap").get<double>();
    for (const auto& [metric, value] : errors.at("metrics").items())
        if (!unused.contains(metric)) largest = std::max(largest, value.at("error").get<double>());
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
    const bool has_edge = wets_a_part(json.at("scene").at("type"));
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
            run.error = largest_used(p.at("errors"), has_edge);
            run.errors = metric_errors(p.at("errors"));
        }
        scene.runs.push_back(std::move(run));
    }
    return scene;
}

/// Both backends compute the same: where a scene's reference ran, or was refined, on one of them only, errors hold on the other as well.
void share_errors(std::vector<MeasuredScene>& scenes)
{
    for (MeasuredScene& scene : scenes)
        for (const MeasuredScene& other : scenes) {
            if (!scene.is_of(other)) continue;
            if (scene.reference_errors.empty()) scene.reference_errors = other.reference_errors;
            for (MeasuredRun& run : scene.runs)
                for (const MeasuredRun& same : other.runs)
                    if (!run.error && run.plan.fidelity == same.plan.fidelity && run.plan.knobs == same.plan.knobs) {
                        run.error = same.error;
                        run.errors = same.errors;
                        run.errors_from = other.device;
                    }
        }
}

} // namespace

bool wets_a_part(const std::string& type)
{
    constexpr ExperimentType all_wet[] = {ExperimentType::drying, ExperimentType::conditioning, ExperimentType::sweat};
    return std::none_of(std::begin(all_wet), std::end(all_wet), [&](ExperimentType each) { return type == name_of(each); });
}

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
        share_errors(list);
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
