// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which points are worth computing next.
#include "core/base/error.h"
#include "core/base/words.h"
#include "core/study/analysis.h"
#include "core/study/csv_rows.h"
#include "core/study/observed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hygroloom {
namespace {

constexpr std::size_t candidate_points = 1500;
constexpr double deviations_of_90_percent = 1.6448536269514722;

double normal_share(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

double deviation_of(const Prediction& p) { return (p.high - p.low) / (2 * deviations_of_90_percent); }

/// By how much a run is expected to be below the best so far (Jones, Schonlau and Welch 1998).
double expected_improvement(double mean, double sd, double best)
{
    if (!(sd > 0)) return std::max(0.0, best - mean);
    const double z = (best - mean) / sd;
    return (best - mean) * normal_share(z) + sd * std::exp(-z * z / 2) / std::sqrt(2 * 3.14159265358979323846);
}

double share_within(const StudyGoal::Limit& limit, const Prediction& p)
{
    const double distance = limit.at_most ? limit.bound - p.value : p.value - limit.bound, sd = deviation_of(p);
    return sd > 0 ? normal_share(distance / sd) : distance >= 0;
}

const Surface& surface_of(const std::vector<Surface>& surfaces, const std::string& metric, const std::string& fabric,
                          const std::string& experiment)
{
    for (const Surface& surface : surfaces)
        if (surface.metric == metric && surface.fabric == fabric && surface.experiment == experiment) {
            if (!surface.missing.empty()) throw Error(metric + ": " + surface.missing);
            return surface;
        }
    throw Error(fmt::format("The study has no surface of {} of {} in {}; make it with --analyse.", metric, fabric, experiment));
}

/// The lowest of the runs that keep the limits; sign is -1 where more is better. None: no run keeps them.
std::optional<double> best_so_far(const StudyTable& table, std::size_t points, const StudyGoal& goal, const std::string& fabric,
                                  const std::string& experiment)
{
    const std::vector<double> means = means_by_point(table, points, goal.metric, fabric, experiment);
    std::vector<bool> kept(points, true);
    for (const StudyGoal::Limit& limit : goal.limits) {
        const std::vector<double> of = means_by_point(table, points, limit.metric, fabric, experiment);
        for (std::size_t i = 0; i < points; ++i) kept[i] = kept[i] && (limit.at_most ? of[i] <= limit.bound : of[i] >= limit.bound);
    }
    std::optional<double> best;
    const double sign = goal.minimise ? 1 : -1;
    for (std::size_t i = 0; i < points; ++i)
        if (kept[i] && !std::isnan(means[i])) best = std::min(best.value_or(INFINITY), sign * means[i]);
    return best;
}

[[noreturn]] void refuse_goal(const std::string& what)
{
    throw Error(what + " Write a goal as: minimise absorbency_time_s subject to maximum_wetted_radius_top_mm <= 12, wick_height_mm >= 40.");
}

} // namespace

StudyGoal parse_goal(const std::string& text, const std::vector<std::string>& metrics)
{
    std::string spaced;
    for (const char c : text)
        spaced += c == ',' ? std::string(" ") : (c == '<' || c == '>') ? std::string(" ") + c : c == '=' ? "= " : std::string(1, c);
    std::istringstream words(spaced);
    const auto metric_in = [&](const std::string& name) {
        if (std::find(metrics.begin(), metrics.end(), name) == metrics.end())
            refuse_goal(fmt::format("The study has no metric \"{}\"{}", name, did_you_mean(name, metrics)));
        return name;
    };
    StudyGoal goal;
    std::string word;
    words >> word;
    goal.minimise = word == "minimise" || word == "minimize";
    if (!goal.minimise && word != "maximise" && word != "maximize")
        refuse_goal(fmt::format("The goal must begin with minimise or maximise; given is \"{}\".", word));
    words >> word;
    goal.metric = metric_in(word);
    if (!(words >> word)) return goal;
    std::string to;
    if (word != "subject" || !(words >> to) || to != "to")
        refuse_goal(fmt::format("After the metric comes \"subject to\"; given is \"{}\".", word));
    std::string sign, bound;
    while (words >> word) {
        StudyGoal::Limit limit;
        limit.metric = metric_in(word);
        if (!(words >> sign >> bound) || (sign != "<=" && sign != ">=" && sign != "<" && sign != ">"))
            refuse_goal(fmt::format("A limit of {} needs <= or >= and a number; given is \"{} {}\".", word, sign, bound));
        limit.at_most = sign.front() == '<';
        const auto number = number_of(bound);
        if (!number || !std::isfinite(*number)) refuse_goal(fmt::format("The limit of {} must be a number; given is \"{}\".", word, bound));
        limit.bound = *number;
        goal.limits.push_back(limit);
    }
    return goal;
}

std::vector<SuggestedPoint> suggest(const StudyFolder& study, const StudyTable& table, const std::vector<Surface>& surfaces,
                                    const StudyGoal& goal, const std::string& fabric, const std::string& experiment, int count)
{
    Surface aim = surface_of(surfaces, goal.metric, fabric, experiment);
    Study spread = study.study;
    spread.sampling = Sampling::sobol;
    spread.sensitivity = Sensitivity::none;
    spread.points = candidate_points;
    spread.seed += 1; // others than the study's own
    const StudyPoints there = study_points(spread, study.design);
    std::vector<std::vector<FactorValue>> candidates(there.size());
    for (std::size_t i = 0; i < there.size(); ++i)
        for (std::size_t k = 0; k < spread.factors.size(); ++k) candidates[i].push_back(there.value(i, k));
    const std::size_t points = study_points(study.study, study.design).size();
    const std::optional<double> best = best_so_far(table, points, goal, fabric, experiment);
    std::vector<double> feasible(candidates.size(), 1.0);
    for (const StudyGoal::Limit& limit : goal.limits) {
        const std::vector<Prediction> of = predict(study, surface_of(surfaces, limit.metric, fabric, experiment), candidates);
        for (std::size_t i = 0; i < of.size(); ++i) feasible[i] *= share_within(limit, of[i]);
    }
    const std::vector<Prediction> aims = predict(study, aim, candidates);
    const double sign = goal.minimise ? 1 : -1;
    std::vector<SuggestedPoint> all;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const double gain = best ? expected_improvement(sign * aims[i].value, deviation_of(aims[i]), *best) : 1.0;
        all.push_back({candidates[i], aims[i], feasible[i], gain * feasible[i]});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const SuggestedPoint& a, const SuggestedPoint& b) { return a.improvement > b.improvement; });

    // Those that lie near one that is taken would tell the same.
    const FactorCube cube(study.study.factors);
    std::vector<SuggestedPoint> taken;
    std::vector<std::vector<double>> places;
    const double apart = 0.15 * std::sqrt(static_cast<double>(std::max<std::size_t>(1, spread.factors.size())));
    for (const SuggestedPoint& one : all) {
        if (static_cast<int>(taken.size()) == count) break;
        const std::vector<double> place = cube.place(one.values);
        const bool near = std::any_of(places.begin(), places.end(), [&](const std::vector<double>& other) {
            double square = 0;
            for (std::size_t k = 0; k < place.size(); ++k) square += (place[k] - other[k]) * (place[k] - other[k]);
            return square < apart * apart;
        });
        if (near) continue;
        places.push_back(place);
        taken.push_back(one);
        if (!best) taken.back().improvement = 0;
    }
    return taken;
}

} // namespace hygroloom
