// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A measured trade-off as JSON, and an outcome on its way between processes.
#include "core/analysis/tradeoff.h"
#include "core/base/error.h"
#include "core/plan/plan_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 2;

Json run_json(const TradeoffRun& run)
{
    Json json{{"name", run.name},
              {"refines", run.coarser},
              {"wall_s", run.walls.empty() ? Json(nullptr) : Json(median(run.walls))},
              {"walls_s", run.walls},
              {"peak_bytes", run.peaks.empty() ? Json(nullptr) : Json(median(run.peaks))},
              {"set", run.settings},
              {"errors", nullptr},
              {"plan", plan_value(run.plan)}};
    if (run.errors) json["errors"] = {{"largest", run.errors->largest}, {"metrics", run.errors->metrics}};
    return json;
}

MeasuredRun measured_run(const Json& json)
{
    if (!json.at("set").empty()) throw Error("It was measured with --set fidelity.…, and so is no run at a fidelity as it is.");
    MeasuredRun run{.plan = plan_from_value(json.at("plan"))};
    if (!json.at("wall_s").is_null()) run.seconds = json.at("wall_s");
    if (!json.at("peak_bytes").is_null()) run.bytes = json.at("peak_bytes");
    const Json& errors = json.at("errors");
    if (!errors.is_null()) run.error = errors.at("largest").get<double>();
    if (!errors.is_null()) run.errors = errors.at("metrics").get<std::map<std::string, double>>();
    return run;
}

MeasuredScene scene_from(const Json& json)
{
    if (json.at("format") != "hygroloom-tradeoff") throw Error("This is not a measured trade-off.");
    if (json.at("version") != version)
        throw Error(fmt::format("This program reads version {}; given is {}.", version, json.at("version").dump()));
    const Json& from = json.at("provenance");
    MeasuredScene scene{.name = json.at("experiment").get<std::string>(),
                        .backend = from.at("backend"),
                        .device = from.at("device"),
                        .date = from.at("date").get<std::string>().substr(0, 10)};
    for (const Json& run : json.at("runs")) {
        if (run.at("refines") == "") {
            if (!run.at("wall_s").is_null() || !run.at("errors").is_null()) scene.runs.push_back(measured_run(run));
        } else if (!run.at("errors").is_null()) {
            for (const auto& [metric, error] : run.at("errors").at("metrics").items())
                scene.reference_errors[metric] += error.get<double>();
        }
    }
    return scene;
}

} // namespace

std::string tradeoff_json(const Tradeoff& t)
{
    Json runs = Json::array();
    std::string backend, device;
    for (const TradeoffRun& run : t.runs) {
        runs.push_back(run_json(run));
        if (!backend.empty() || !run.outcome) continue;
        backend = run.outcome->backend;
        device = run.outcome->device;
    }
    const Json json{{"format", "hygroloom-tradeoff"},
                    {"version", version},
                    {"provenance",
                     {{"program", t.program},
                      {"commit", t.commit},
                      {"date", t.date},
                      {"machine", t.machine},
                      {"load_at_start", t.load < 0 ? Json(nullptr) : Json(t.load)},
                      {"backend", backend},
                      {"device", device},
                      {"threads", t.threads},
                      {"repeats", t.repeats},
                      {"complete", t.complete}}},
                    {"fabric", t.fabric},
                    {"experiment", t.experiment},
                    {"runs", runs}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

MeasuredScene measured_scene(const std::string& json, const std::string& file)
try {
    return scene_from(Json::parse(json));
} catch (const std::exception& error) {
    throw Error(fmt::format("{}: The measured trade-off cannot be read: {}", file, error.what()));
}

std::string outcome_json(const TradeoffOutcome& o)
{
    Json metrics = Json::object(), moments = Json::array();
    for (const auto& [name, value] : o.metrics) metrics[name] = value ? Json(*value) : Json(nullptr);
    for (const TradeoffMoment& m : o.moments) {
        std::string wet;
        for (char is_wet : m.wet) wet += is_wet ? '1' : '0';
        moments.push_back({{"contents", m.contents}, {"wet", wet}});
    }
    return Json{{"metrics", metrics}, {"moments", moments},   {"type", o.type},    {"air_temperature_c", o.air_temperature_c},
                {"wall", o.wall},     {"backend", o.backend}, {"device", o.device}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

TradeoffOutcome outcome_from_json(const std::string& text)
try {
    const Json json = Json::parse(text);
    TradeoffOutcome o;
    for (const auto& [name, value] : json.at("metrics").items())
        o.metrics[name] = value.is_null() ? std::nullopt : std::optional(value.get<double>());
    for (const Json& m : json.at("moments")) {
        TradeoffMoment& moment = o.moments.emplace_back();
        moment.contents = m.at("contents").get<std::map<std::string, double>>();
        for (char c : m.at("wet").get<std::string>()) moment.wet.push_back(c == '1');
    }
    o.type = json.at("type");
    o.air_temperature_c = json.at("air_temperature_c");
    o.wall = json.at("wall");
    o.backend = json.at("backend");
    o.device = json.at("device");
    return o;
} catch (const Json::exception& e) {
    throw Error(std::string("The outcome of a run cannot be read: ") + e.what());
}

} // namespace hygroloom
