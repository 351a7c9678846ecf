// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The files of tradeoff, and the text in which the process of a run reports its outcome.
#include "core/analysis/tradeoff.h"

#include "core/base/error.h"
#include "core/plan/plan_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hygroloom {

using Json = nlohmann::ordered_json;

namespace {

constexpr int tradeoff_version = 1;
constexpr const char* how_time =
    "Wall time of the run, planning and scene included; the median of the repeats. One process a run, one run at a "
    "time, the repeats interleaved: every variant once, then every variant again.";
constexpr const char* how_memory =
    "Largest resident set of the run's own process as the kernel counted it (wait4), with the program and its "
    "libraries; memory of a GPU is not in it.";
constexpr const char* how_error =
    "The largest of: each metric's difference over the reference's value (a temperature's over its distance from "
    "the air, one-way transport's over 100 % at least, a stain's arms as they are), each content's over all water that moved, "
    "1 - overlap where a part of the cloth is wetted. Map: relative L2 over cells "
    "of 2 x 2 crossings. Overlap of the wetted segments: intersection over union. Contents, map and overlap are compared "
    "at a quarter, a half, three quarters and the end.";
constexpr const char* how_closed_forms =
    "Where a closed form gives a metric it is the reference here: the regain in equilibrium with the air; the wet bulb of a sheet "
    "and the rate at which it dries off both faces.";

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }
std::optional<double> optional_in(const Json& json) { return json.is_null() ? std::nullopt : std::optional(json.get<double>()); }

Json settings_json(const KnobSettings& settings)
{
    Json json = Json::object();
    for (const auto& [name, value] : settings) json[name] = value;
    return json;
}

Json metric_errors_json(const std::vector<MetricError>& errors)
{
    Json json = Json::object();
    for (const MetricError& m : errors)
        json[m.name] = {{"value", or_null(m.value)}, {"reference", or_null(m.reference)}, {"error", m.error}};
    return json;
}

std::vector<MetricError> metric_errors_from_json(const Json& json)
{
    std::vector<MetricError> errors;
    for (const auto& [name, m] : json.items())
        errors.push_back({name, optional_in(m.at("value")), optional_in(m.at("reference")), m.at("error")});
    return errors;
}

Json errors_json(const TradeoffErrors& errors)
{
    return {{"largest", errors.largest},
            {"map_relative_l2", or_null(errors.map)},
            {"wetted_overlap", or_null(errors.overlap)},
            {"metrics", metric_errors_json(errors.metrics)}};
}

TradeoffErrors errors_from_json(const Json& json)
{
    TradeoffErrors errors;
    errors.largest = json.at("largest");
    errors.map = optional_in(json.at("map_relative_l2"));
    errors.overlap = optional_in(json.at("wetted_overlap"));
    errors.metrics = metric_errors_from_json(json.at("metrics"));
    return errors;
}

Json point_json(const TradeoffPoint& p)
{
    Json json{{"name", p.variant.name},
              {"fidelity", name_of(p.variant.fidelity)},
              {"set", settings_json(p.variant.settings)},
              {"wall_s", p.walls.empty() ? Json(nullptr) : Json(p.wall())},
              {"walls_s", p.walls},
              {"peak_bytes", p.peaks.empty() ? Json(nullptr) : Json(p.peak())},
              {"liquid_steps", p.liquid_steps},
              {"pareto", p.pareto},
              {"stands_for", p.stands_for},
              {"errors", p.errors ? errors_json(*p.errors) : Json(nullptr)},
              {"closed_forms", metric_errors_json(p.closed_forms)},
              {"stages_percent", Json::object()},
              {"plan", plan_value(p.plan)},
              {"switched_on", switched_value(p.switched_on)}};
    for (const auto& [name, percent] : p.stages) json["stages_percent"][name] = percent;
    return json;
}

TradeoffPoint point_from_json(const Json& json)
{
    TradeoffPoint p;
    p.variant.name = json.at("name");
    p.variant.fidelity = fidelity_from_name(json.at("fidelity"));
    for (const auto& [name, value] : json.at("set").items()) p.variant.settings[name] = value;
    p.walls = json.at("walls_s").get<std::vector<double>>();
    if (!json.at("peak_bytes").is_null()) p.peaks = {json.at("peak_bytes").get<double>()};
    p.liquid_steps = json.at("liquid_steps");
    p.pareto = json.at("pareto");
    p.stands_for = json.at("stands_for").get<std::vector<std::string>>();
    if (!json.at("errors").is_null()) p.errors = errors_from_json(json.at("errors"));
    if (json.contains("closed_forms")) p.closed_forms = metric_errors_from_json(json.at("closed_forms"));
    for (const auto& [name, percent] : json.at("stages_percent").items()) p.stages[name] = percent;
    p.plan = plan_from_value(json.at("plan"));
    if (json.contains("switched_on")) p.switched_on = switched_from_value(json.at("switched_on"));
    return p;
}

const MetricError* error_named(const TradeoffPoint& p, const std::string& name)
{
    if (!p.errors) return nullptr;
    for (const MetricError& m : p.errors->metrics)
        if (m.name == name) return &m;
    return nullptr;
}

std::string cell(const std::optional<double>& value) { return value ? fmt::format("{:.6g}", *value) : std::string(); }

} // namespace

std::string tradeoff_json(const Tradeoff& t)
{
    Json points = Json::array(), convergence = Json::array();
    for (const TradeoffPoint& p : t.points) points.push_back(point_json(p));
    for (const ConvergenceStep& step : t.convergence)
        convergence.push_back({{"from", step.coarse}, {"to", step.fine}, {"errors", errors_json(step.errors)}});
    const Json json{{"format", "hygroloom-tradeoff"},
                    {"version", tradeoff_version},
                    {"provenance",
                     {{"program", t.program},
                      {"commit", t.commit},
                      {"date", t.date},
                      {"machine", t.machine},
                      {"load_at_start", t.load < 0 ? Json(nullptr) : Json(t.load)},
                      {"backend", t.backend},
                      {"device", t.device},
                      {"threads", t.threads},
                      {"repeats", t.repeats},
                      {"complete", t.complete}}},
                    {"scene", {{"fabric", t.fabric}, {"experiment", t.experiment}, {"type", t.type}, {"duration_s", t.duration}}},
                    {"how", {{"wall_s", how_time}, {"peak_bytes", how_memory}, {"errors", how_error}, {"closed_forms", how_closed_forms}}},
                    {"points", points},
                    {"convergence", convergence}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Tradeoff tradeoff_from_json(const std::string& text, const std::string& file)
try {
    const Json json = Json::parse(text);
    if (json.at("format") != "hygroloom-tradeoff") throw Error("this is not a measured trade-off.");
    if (json.at("version") != tradeoff_version)
        throw Error(fmt::format("this program reads version {} of measured trade-offs; the file has {}.", tradeoff_version,
                                json.at("version").dump()));
    Tradeoff t;
    const Json &from = json.at("provenance"), &scene = json.at("scene");
    t.program = from.at("program");
    t.commit = from.at("commit");
    t.date = from.at("date");
    t.machine = from.at("machine");
    t.load = from.at("load_at_start").is_null() ? -1.0 : from.at("load_at_start").get<double>();
    t.backend = from.at("backend");
    t.device = from.at("device");
    t.threads = from.at("threads");
    t.repeats = from.at("repeats");
    t.complete = from.at("complete");
    t.fabric = scene.at("fabric");
    t.experiment = scene.at("experiment");
    t.type = scene.at("type");
    t.duration = scene.at("duration_s");
    for (const Json& p : json.at("points")) t.points.push_back(point_from_json(p));
    for (const Json& c : json.at("convergence")) t.convergence.push_back({c.at("from"), c.at("to"), errors_from_json(c.at("errors"))});
    return t;
} catch (const Json::exception& e) {
    throw Error(fmt::format("{}: The measured trade-off cannot be read: {}", file, e.what()));
} catch (const Error& e) {
    throw Error(fmt::format("{}: {}", file, e.what()));
}

std::string tradeoff_csv(const Tradeoff& t)
{
    std::string text =
        fmt::format("# program={}\n# commit={}\n# date={}\n# machine={}\n# device={}\n# backend={}\n# fabric={}\n"
                    "# experiment={}\n# threads={}\n# repeats={}\n# complete={}\n",
                    t.program, t.commit, t.date, t.machine, t.device, t.backend, t.fabric, t.experiment, t.threads, t.repeats, t.complete);
    text += "variant,wall_s,peak_bytes,largest_error,map_relative_l2,wetted_overlap,pareto";
    std::vector<std::string> names;
    for (const TradeoffPoint& p : t.points)
        if (p.errors && names.empty())
            for (const MetricError& m : p.errors->metrics) names.push_back(m.name);
    for (const std::string& name : names) text += fmt::format(",{0},error_of_{0}", name);
    text += "\n";
    for (const TradeoffPoint& p : t.points) {
        text += fmt::format("{},{},{},", p.variant.name, p.walls.empty() ? "" : fmt::format("{:.6g}", p.wall()),
                            p.peaks.empty() ? "" : fmt::format("{:.0f}", p.peak()));
        if (p.errors)
            text += fmt::format("{:.6g},{},{},{}", p.errors->largest, cell(p.errors->map), cell(p.errors->overlap), p.pareto);
        else
            text += ",,,false";
        for (const std::string& name : names) {
            const MetricError* m = error_named(p, name);
            text += m ? fmt::format(",{},{:.6g}", cell(m->value), m->error) : ",,";
        }
        text += "\n";
    }
    return text;
}

std::string outcome_json(const TradeoffOutcome& o)
{
    Json metrics = Json::object(), moments = Json::array(), stages = Json::array();
    for (const auto& [name, value] : o.metrics) metrics[name] = or_null(value);
    for (const TradeoffMoment& m : o.moments) {
        std::string wet;
        for (char is_wet : m.wet) wet += is_wet ? '1' : '0';
        moments.push_back({{"time", m.time}, {"contents", Json(m.contents)}, {"map", m.map}, {"wet", wet}});
    }
    for (const StageTime& s : o.stages) stages.push_back({s.name, s.seconds, s.calls});
    return Json{{"metrics", metrics},
                {"closed_forms", Json(o.closed_forms)},
                {"moments", moments},
                {"air_temperature_c", o.air_temperature_c},
                {"wall", o.wall},
                {"liquid_steps", o.liquid_steps},
                {"backend", o.backend},
                {"device", o.device},
                {"stages", stages},
                {"plan", plan_value(o.plan)},
                {"switched_on", switched_value(o.switched_on)}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

TradeoffOutcome outcome_from_json(const std::string& text)
try {
    const Json json = Json::parse(text);
    TradeoffOutcome o;
    for (const auto& [name, value] : json.at("metrics").items()) o.metrics[name] = optional_in(value);
    o.closed_forms = json.at("closed_forms").get<std::map<std::string, double>>();
    for (const Json& m : json.at("moments")) {
        TradeoffMoment moment;
        moment.time = m.at("time");
        moment.contents = m.at("contents").get<std::map<std::string, double>>();
        moment.map = m.at("map").get<std::vector<double>>();
        for (char c : m.at("wet").get<std::string>()) moment.wet.push_back(c == '1');
        o.moments.push_back(std::move(moment));
    }
    o.air_temperature_c = json.at("air_temperature_c");
    o.wall = json.at("wall");
    o.liquid_steps = json.at("liquid_steps");
    o.backend = json.at("backend");
    o.device = json.at("device");
    for (const Json& s : json.at("stages")) o.stages.push_back({s[0], s[1], s[2]});
    o.plan = plan_from_value(json.at("plan"));
    o.switched_on = switched_from_value(json.at("switched_on"));
    return o;
} catch (const Json::exception& e) {
    throw Error(std::string("The outcome of a run cannot be read: ") + e.what());
}

} // namespace hygroloom
