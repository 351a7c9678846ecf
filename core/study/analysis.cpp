// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Sensitivities and surfaces of a study.
#include "core/study/analysis.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "core/project/json_reader.h"
#include "core/project/project_json.h"
#include "core/study/analysis_module.h"
#include "core/study/observed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {
namespace {

using nlohmann::json;

constexpr std::size_t most_fitted = 600;        // points; the work goes with their cube
constexpr std::size_t predicted_samples = 4096; // of a surface, for indices, all blocks together at most 4 times as many
constexpr std::size_t largest_surface_bytes = std::size_t{1} << 30U;
constexpr double deviations_of_90_percent = 1.6448536269514722;

/// Calls for each metric of each fabric on each experiment.
template <typename Act> void each_result(const StudyFolder& study, const Act& act)
{
    for (const std::string& fabric : fabrics_of(study.study, study.design))
        for (const std::string& experiment : experiments_of(study.study, study.design))
            for (const std::string& metric : metrics_of(study.study, study.design)) act(metric, fabric, experiment);
}

/// As keys of JSON: the metric alone where there is one fabric and one experiment.
std::string key_of(const StudyFolder& study, const std::string& metric, const std::string& fabric, const std::string& experiment)
{
    std::string key = metric;
    if (fabrics_of(study.study, study.design).size() > 1) key += " of " + fabric;
    if (experiments_of(study.study, study.design).size() > 1) key += " in " + experiment;
    return key;
}

bool are_all_alike(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
}

/// From outputs in blocks of samples.
void take_indices(MetricSensitivity& to, const std::vector<double>& outputs, std::size_t samples, std::size_t factors)
{
    if (are_all_alike(outputs)) {
        to.missing = "All runs give the same number, so that no factor has an effect.";
        return;
    }
    const json found = ask_module({{"do", "indices"}, {"samples", samples}, {"factors", factors}, {"outputs", outputs}});
    for (std::size_t k = 0; k < factors; ++k) {
        const auto number = [&](const char* key) { return found.at(key).at(k).is_number() ? found.at(key).at(k).get<double>() : 0.0; };
        to.factors.push_back(
            {number("first"), number("first_low"), number("first_high"), number("total"), number("total_low"), number("total_high")});
    }
}

/// Of the study's own points, whose base samples count only where all of their runs have the number.
void take_saltelli(MetricSensitivity& to, const std::vector<double>& means, std::size_t base, std::size_t factors)
{
    to.method = "saltelli";
    std::vector<std::size_t> whole;
    for (std::size_t i = 0; i < base; ++i) {
        bool all = true;
        for (std::size_t block = 0; block < factors + 2; ++block) all = all && !std::isnan(means[block * base + i]);
        if (all) whole.push_back(i);
    }
    to.points = whole.size() * (factors + 2);
    if (whole.size() < 8) {
        to.missing = fmt::format("Only {} of {} base samples have the number at each of their {} points; it takes 8.", whole.size(), base,
                                 factors + 2);
        return;
    }
    std::vector<double> outputs;
    for (std::size_t block = 0; block < factors + 2; ++block)
        for (const std::size_t i : whole) outputs.push_back(means[block * base + i]);
    take_indices(to, outputs, whole.size(), factors);
}

Surface fit_surface(const StudyPoints& points, const std::vector<double>& means, const std::string& metric, const std::string& fabric,
                    const std::string& experiment)
{
    Surface surface;
    surface.metric = metric;
    surface.fabric = fabric;
    surface.experiment = experiment;
    std::vector<std::size_t> there;
    for (std::size_t i = 0; i < means.size(); ++i)
        if (!std::isnan(means[i])) there.push_back(i);
    const std::size_t least = std::max<std::size_t>(8, points.factors().size() + 3);
    if (points.factors().empty() || there.size() < least) {
        surface.missing =
            fmt::format("{} points have the number; a surface over {} factors takes {}.", there.size(), points.factors().size(), least);
        return surface;
    }
    const std::size_t fitted = std::min(there.size(), most_fitted);
    for (std::size_t i = 0; i < fitted; ++i) {
        surface.points.push_back(there[i * there.size() / fitted]);
        surface.values.push_back(means[surface.points.back()]);
    }
    if (are_all_alike(surface.values)) {
        surface.missing = fmt::format("All points give the same number, {}.", surface.values.front());
        return surface;
    }
    const FactorCube cube(points.factors());
    json inputs = json::array();
    for (const std::size_t point : surface.points) inputs.push_back(cube.place(points, point));
    const json state = ask_module({{"do", "fit"}, {"inputs", inputs}, {"outputs", surface.values}});
    surface.q2 = state.at("q2").get<double>();
    surface.state = state.dump();
    return surface;
}

/// Means and, where asked for, standard deviations at places in the cube.
json predicted(const StudyPoints& points, const Surface& surface, const json& at, bool with_sd)
{
    const FactorCube cube(points.factors());
    json inputs = json::array();
    for (const std::size_t point : surface.points) inputs.push_back(cube.place(points, point));
    return ask_module({{"do", "predict"},
                       {"inputs", inputs},
                       {"outputs", surface.values},
                       {"state", json::parse(surface.state)},
                       {"at", at},
                       {"with_sd", with_sd}});
}

/// The same indices of what the surface predicts at many points.
void take_surrogate(MetricSensitivity& to, const StudyFolder& study, const StudyPoints& points, const Surface& surface)
{
    to.method = "kriging surrogate";
    to.points = surface.points.size();
    to.missing = surface.missing;
    if (!to.missing.empty()) return;
    Study many = study.study;
    const std::size_t factors = many.factors.size();
    many.sampling = Sampling::sobol;
    many.sensitivity = Sensitivity::saltelli;
    many.points = std::min(predicted_samples, std::max<std::size_t>(64, 4 * predicted_samples / (factors + 2))) * (factors + 2);
    const StudyPoints there = study_points(many, study.design);
    const FactorCube cube(many.factors);
    json at = json::array();
    for (std::size_t i = 0; i < there.size(); ++i) at.push_back(cube.place(there, i));
    const json found = predicted(points, surface, at, false);
    take_indices(to, found.at("mean").get<std::vector<double>>(), saltelli_base(many), factors);
}

const Surface* surface_of(const std::vector<Surface>& surfaces, const std::string& metric, const std::string& fabric,
                          const std::string& experiment)
{
    const auto found = std::find_if(surfaces.begin(), surfaces.end(), [&](const Surface& s) {
        return s.metric == metric && s.fabric == fabric && s.experiment == experiment;
    });
    return found == surfaces.end() ? nullptr : &*found;
}

std::vector<MetricSensitivity> sensitivities_with(const StudyFolder& study, const StudyTable& table, const std::vector<Surface>& surfaces)
{
    const StudyPoints points = study_points(study.study, study.design);
    std::vector<MetricSensitivity> all;
    each_result(study, [&](const std::string& metric, const std::string& fabric, const std::string& experiment) {
        MetricSensitivity of;
        of.metric = metric;
        of.fabric = fabric;
        of.experiment = experiment;
        if (study.study.sensitivity == Sensitivity::saltelli) {
            const std::vector<double> means = means_by_point(table, points.size(), metric, fabric, experiment);
            take_saltelli(of, means, saltelli_base(study.study), points.factors().size());
        } else if (const Surface* surface = surface_of(surfaces, metric, fabric, experiment)) {
            take_surrogate(of, study, points, *surface);
        }
        all.push_back(std::move(of));
    });
    return all;
}

} // namespace

std::string why_no_analysis() { return why_no_module(); }

std::vector<Surface> fit_surfaces(const StudyFolder& study, const StudyTable& table)
{
    const StudyPoints points = study_points(study.study, study.design);
    std::vector<Surface> surfaces;
    each_result(study, [&](const std::string& metric, const std::string& fabric, const std::string& experiment) {
        surfaces.push_back(
            fit_surface(points, means_by_point(table, points.size(), metric, fabric, experiment), metric, fabric, experiment));
    });
    return surfaces;
}

std::vector<MetricSensitivity> sensitivities(const StudyFolder& study, const StudyTable& table)
{
    const bool needs_surfaces = study.study.sensitivity != Sensitivity::saltelli;
    return sensitivities_with(study, table, needs_surfaces ? fit_surfaces(study, table) : std::vector<Surface>());
}

std::string sensitivity_json(const StudyFolder& study, const std::vector<MetricSensitivity>& all)
{
    ProjectJson result = ProjectJson::object();
    for (const MetricSensitivity& of : all) {
        ProjectJson& metric = result[key_of(study, of.metric, of.fabric, of.experiment)] = ProjectJson::object();
        for (std::size_t k = 0; k < of.factors.size(); ++k) {
            const SobolIndex& index = of.factors[k];
            metric[study.study.factors[k].path] = {{"first", index.first}, {"first_low", index.first_low}, {"first_high", index.first_high},
                                                   {"total", index.total}, {"total_low", index.total_low}, {"total_high", index.total_high},
                                                   {"method", of.method},  {"points", of.points}};
        }
    }
    return text_from_json(result);
}

std::string surfaces_json(const StudyFolder& study, const std::vector<Surface>& surfaces)
{
    ProjectJson result;
    result["format"] = "hygroloom-surface";
    result["version"] = 1;
    result["surfaces"] = ProjectJson::array();
    for (const Surface& surface : surfaces) {
        ProjectJson one{{"metric", surface.metric}, {"fabric", surface.fabric}, {"experiment", surface.experiment}};
        if (!surface.missing.empty()) {
            one["missing"] = surface.missing;
        } else {
            one["q2"] = surface.q2;
            one["points"] = surface.points;
            one["values"] = surface.values;
            one["state"] = ProjectJson::parse(surface.state);
        }
        result["surfaces"].push_back(std::move(one));
    }
    result["factors"] = ProjectJson::array();
    for (const Factor& factor : study.study.factors) result["factors"].push_back(factor.path);
    return text_from_json(result);
}

std::vector<Surface> read_surfaces(const StudyFolder& study, const std::filesystem::path& file)
{
    const ProjectJson text = parse_json(read_file(file, largest_surface_bytes), file.string());
    const std::size_t points = count_points(study.study);
    std::vector<Surface> surfaces;
    try {
        if (text.at("format") != "hygroloom-surface" || text.at("version") != 1 || text.at("factors").size() != study.study.factors.size())
            throw FileError(file.string() + ": This is no surface of the study; make it anew with --analyse.");
        for (const ProjectJson& one : text.at("surfaces")) {
            Surface surface{one.at("metric"), one.at("fabric"), one.at("experiment"), {}, {}, 0, "", one.value("missing", "")};
            if (surface.missing.empty()) {
                surface.points = one.at("points").get<std::vector<std::size_t>>();
                surface.values = one.at("values").get<std::vector<double>>();
                surface.q2 = one.at("q2").get<double>();
                surface.state = one.at("state").dump();
                const bool fits = std::all_of(surface.points.begin(), surface.points.end(), [&](std::size_t p) { return p < points; });
                if (!fits || surface.points.size() != surface.values.size())
                    throw FileError(file.string() + ": The surface has points that the study lacks; make it anew with --analyse.");
            }
            surfaces.push_back(std::move(surface));
        }
    } catch (const ProjectJson::exception&) {
        throw FileError(file.string() + ": This is no surface of a study; make it anew with --analyse.");
    }
    return surfaces;
}

std::vector<Prediction> predict(const StudyFolder& study, const Surface& surface, const std::vector<std::vector<FactorValue>>& points)
{
    if (!surface.missing.empty()) throw Error(surface.metric + ": " + surface.missing);
    const FactorCube cube(study.study.factors);
    json at = json::array();
    for (const std::vector<FactorValue>& values : points) at.push_back(cube.place(values));
    const json found = predicted(study_points(study.study, study.design), surface, at, true);
    std::vector<Prediction> predictions;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double mean = found.at("mean").at(i).get<double>(), sd = found.at("sd").at(i).get<double>();
        predictions.push_back({mean, mean - deviations_of_90_percent * sd, mean + deviations_of_90_percent * sd});
    }
    return predictions;
}

void analyse_study(const std::filesystem::path& folder)
{
    const StudyFolder study = read_study_folder(folder);
    const StudyTable table = collect_rows(study, folder);
    if (const std::string reason = why_no_analysis(); !reason.empty()) throw Error(reason);
    if (table.rows() == 0) throw Error(folder.string() + ": No run has ended yet; there is nothing to analyse.");
    const std::vector<Surface> surfaces = fit_surfaces(study, table);
    write_file(folder / "surface.json", surfaces_json(study, surfaces));
    write_file(folder / "sensitivity.json", sensitivity_json(study, sensitivities_with(study, table, surfaces)));
}

} // namespace hygroloom
