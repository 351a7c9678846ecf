// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the results of a study say: sweep --analyse, --predict and --suggest.
#include "app/cli_sweep.h"

#include "core/base/words.h"
#include "core/project/atomic_file.h"
#include "core/study/analysis.h"
#include "core/study/csv_rows.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace hygroloom {
namespace {

using Json = nlohmann::ordered_json;

void require_module()
{
    if (const std::string reason = why_no_analysis(); !reason.empty()) throw Stop(exit_failed, reason);
}

/// Whether a file is there and no row came since it was written.
bool is_fresh(const std::filesystem::path& file)
{
    std::error_code failure;
    const auto written = std::filesystem::last_write_time(file, failure);
    if (failure) return false;
    for (const auto& part : std::filesystem::directory_iterator(file.parent_path() / "parts", failure))
        if (std::filesystem::last_write_time(part.path(), failure) > written) return false;
    return true;
}

/// Of the folder; made first where they are not there or older than the rows.
std::vector<Surface> surfaces_in(const SweepOptions& options, const StudyFolder& study)
{
    const std::filesystem::path file = std::filesystem::path(options.folder) / "surface.json";
    if (!is_fresh(file)) analyse_study(options.folder);
    return read_surfaces(study, file);
}

/// "metric" of which fabric and experiment, where there are several.
std::string title_of(const StudyFolder& study, const std::string& metric, const std::string& fabric, const std::string& experiment)
{
    std::string title = metric;
    if (fabrics_of(study.study, study.design).size() > 1) title += " of " + fabric;
    if (experiments_of(study.study, study.design).size() > 1) title += " in " + experiment;
    return title;
}

/// The point that "path=value" describes, the middle of the study where nothing is said. Throws Stop.
std::vector<FactorValue> described_point(const Study& study, const std::vector<std::string>& given)
{
    std::vector<FactorValue> values;
    std::vector<std::string> paths;
    for (const Factor& factor : study.factors) {
        values.push_back(quantile(factor, 0.5));
        paths.push_back(factor.path);
    }
    for (const std::string& set : given) {
        const std::size_t sign = set.rfind('=');
        if (sign == std::string::npos) throw Stop(exit_usage, "--predict " + set + ": Write it as path=value.");
        const std::string path = set.substr(0, sign), text = set.substr(sign + 1);
        const auto found = std::find(paths.begin(), paths.end(), path);
        if (found == paths.end())
            throw Stop(exit_usage, fmt::format("--predict: The study has no factor \"{}\"{}", path, did_you_mean(path, paths)));
        const auto number = number_of(text);
        values[static_cast<std::size_t>(found - paths.begin())] = number ? factor_value(*number) : factor_value(text);
    }
    return values;
}

Json json_of(const FactorValue& value) { return value.is_number ? Json(value.number) : Json(value.text); }

Json values_json(const Study& study, const std::vector<FactorValue>& values)
{
    Json json = Json::object();
    for (std::size_t k = 0; k < values.size(); ++k) json[study.factors[k].path] = json_of(values[k]);
    return json;
}

void print_sensitivities(const SweepOptions& options, const StudyFolder& study)
{
    const std::string text = read_file(std::filesystem::path(options.folder) / "sensitivity.json", std::size_t{1} << 30U);
    if (options.json) {
        print_result("{}", text);
        return;
    }
    const Json all = Json::parse(text);
    for (const auto& [metric, factors] : all.items()) {
        if (factors.empty()) {
            print_result("{}: not known; too few runs have it, or all the same number\n", metric);
            continue;
        }
        const Json& one = factors.front();
        print_result("{}, by {}, {} points\n  {:<44} {:>22} {:>22}\n", metric, one.at("method").get<std::string>(),
                     one.at("points").get<std::size_t>(), "", "alone", "with others");
        for (const auto& [path, index] : factors.items()) {
            const auto range = [&](const char* key) {
                const std::string name = key;
                return fmt::format("{:.2f} ({:.2f} to {:.2f})", index.at(name).get<double>(), index.at(name + "_low").get<double>(),
                                   index.at(name + "_high").get<double>());
            };
            print_result("  {:<44} {:>22} {:>22}\n", path, range("first"), range("total"));
        }
    }
    for (const Surface& surface : read_surfaces(study, std::filesystem::path(options.folder) / "surface.json"))
        print_result("surface of {}: {}\n", title_of(study, surface.metric, surface.fabric, surface.experiment),
                     surface.missing.empty() ? fmt::format("{} points, predicts {:.0f} % of the variance of points left out",
                                                           surface.points.size(), 100 * std::max(0.0, surface.q2))
                                             : surface.missing);
}

} // namespace

int analyse_rows(const SweepOptions& options)
{
    const StudyFolder study = study_folder(options);
    require_module();
    analyse_study(options.folder);
    print_sensitivities(options, study);
    const std::size_t ended = collect_rows(study, options.folder).rows(), rows = StudyFrame(study.study, study.design).rows();
    if (ended < rows) print_note("{} of {} runs have ended: shares will change. Run the others with --resume.\n", ended, rows);
    return exit_ok;
}

void analyse_after_run(const SweepOptions& options)
{
    try {
        analyse_study(options.folder);
        if (!options.quiet)
            print_note("Sensitivities: {}/sensitivity.json; hygroloom-cli sweep -o {} --analyse shows them.\n", options.folder,
                       options.folder);
    } catch (const Error& error) {
        print_note("{}\n", error.what());
    }
}

int predict_rows(const SweepOptions& options)
{
    const StudyFolder study = study_folder(options);
    require_module();
    const std::vector<FactorValue> point = described_point(study.study, options.predict);
    Json json{{"point", values_json(study.study, point)}, {"predictions", Json::object()}};
    for (const Surface& surface : surfaces_in(options, study)) {
        const std::string title = title_of(study, surface.metric, surface.fabric, surface.experiment);
        if (!surface.missing.empty()) {
            json["predictions"][title] = {{"missing", surface.missing}};
            continue;
        }
        const Prediction at = as_usage([&] { return predict(study, surface, {point}).front(); });
        json["predictions"][title] = {{"value", at.value}, {"low", at.low}, {"high", at.high}, {"level", 0.9}, {"q2", surface.q2}};
    }
    if (options.json) {
        print_json(json);
        return exit_ok;
    }
    for (const auto& [title, of] : json["predictions"].items())
        print_result("{}: {}\n", title,
                     of.contains("missing") ? of["missing"].get<std::string>()
                                            : fmt::format("{:.4g}, in 90 % of cases {:.4g} to {:.4g}", of["value"].get<double>(),
                                                          of["low"].get<double>(), of["high"].get<double>()));
    return exit_ok;
}

int suggest_points(const SweepOptions& options)
{
    const StudyFolder study = study_folder(options);
    const StudyGoal goal = as_usage([&] { return parse_goal(options.suggest, metrics_of(study.study, study.design)); });
    require_module();
    const std::vector<Surface> surfaces = surfaces_in(options, study);
    const StudyTable table = collect_rows(study, options.folder);
    Json all = Json::array();
    for (const std::string& fabric : fabrics_of(study.study, study.design))
        for (const std::string& experiment : experiments_of(study.study, study.design))
            for (const SuggestedPoint& one : suggest(study, table, surfaces, goal, fabric, experiment, options.count))
                all.push_back({{"fabric", fabric},
                               {"experiment", experiment},
                               {"point", values_json(study.study, one.values)},
                               {"value", one.goal.value},
                               {"low", one.goal.low},
                               {"high", one.goal.high},
                               {"feasible", one.feasible},
                               {"improvement", one.improvement}});
    if (options.json) {
        print_json({{"goal", options.suggest}, {"suggestions", all}});
        return exit_ok;
    }
    for (const Json& one : all) {
        std::string values;
        for (const auto& [path, value] : one["point"].items())
            values += fmt::format("{}{}={}", values.empty() ? "" : ", ", path, value.is_string() ? value.get<std::string>() : value.dump());
        print_result("{}: {} {:.4g} (90 %: {:.4g} to {:.4g}), keeps the limits with {:.0f} %, expected gain {:.3g}\n  {}\n",
                     one["fabric"].get<std::string>(), goal.metric, one["value"].get<double>(), one["low"].get<double>(),
                     one["high"].get<double>(), 100 * one["feasible"].get<double>(), one["improvement"].get<double>(), values);
    }
    return exit_ok;
}

} // namespace hygroloom
