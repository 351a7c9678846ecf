// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the results of a study say: which factors matter, a surface through them that predicts, and which points are worth computing next.
// The mathematics is in a module of its own, which is loaded when one of these is asked for.
#pragma once

#include "core/study/study_folder.h"

namespace hygroloom {

/// Why there is no analysis here, in a sentence; empty: there is. Loads the module.
std::string why_no_analysis();

/// Sobol indices of one factor, with where they lie with 95 % probability.
struct SobolIndex {
    double first = 0, first_low = 0, first_high = 0;
    double total = 0, total_low = 0, total_high = 0;
};
/// Of one metric of one fabric on one experiment.
struct MetricSensitivity {
    std::string metric, fabric, experiment;
    std::string method;              ///< "saltelli", or "kriging surrogate"
    std::size_t points = 0;          ///< that it rests on
    std::vector<SobolIndex> factors; ///< in the study's order; empty: see missing
    std::string missing;             ///< why there are none, in a sentence
};
/// Throws Error where the module is missing.
std::vector<MetricSensitivity> sensitivities(const StudyFolder& study, const StudyTable& table);
/// {"metric": {"factor": {"first": …, "first_low": …, …}}}; where there are several fabrics or experiments the key is
/// "metric of fabric in experiment".
std::string sensitivity_json(const StudyFolder& study, const std::vector<MetricSensitivity>& all);

/// A number that a surface predicts, and where a run there would lie with 90 % probability.
struct Prediction {
    double value = 0, low = 0, high = 0;
};
/// A kriging surface of one metric over the factors, fitted to the means of the replicates.
struct Surface {
    std::string metric, fabric, experiment;
    std::vector<std::size_t> points; ///< that it was fitted to
    std::vector<double> values;      ///< there
    double q2 = 0;                   ///< share of the variance that it predicts of points left out; 1 is perfect, 0 no better than the mean
    std::string state;               ///< of the module, JSON
    std::string missing;             ///< why there is none, in a sentence
};
std::vector<Surface> fit_surfaces(const StudyFolder& study, const StudyTable& table);
std::string surfaces_json(const StudyFolder& study, const std::vector<Surface>& surfaces);
/// From DIR/surface.json of that study. Throws FileError.
std::vector<Surface> read_surfaces(const StudyFolder& study, const std::filesystem::path& file);

/// Each point has a value for every factor, in the study's order. Throws Error where one lies outside of the study.
std::vector<Prediction> predict(const StudyFolder& study, const Surface& surface, const std::vector<std::vector<FactorValue>>& points);

/// "minimise absorbency_time_s subject to maximum_wetted_radius_top_mm <= 12, wick_height_mm >= 40".
struct StudyGoal {
    struct Limit {
        std::string metric;
        bool at_most = true;
        double bound = 0;
    };
    std::string metric;
    bool minimise = true;
    std::vector<Limit> limits;
};
/// Throws Error: what is not understood, and an example.
StudyGoal parse_goal(const std::string& text, const std::vector<std::string>& metrics);

struct SuggestedPoint {
    std::vector<FactorValue> values;
    Prediction goal;
    double feasible = 1;    ///< probability that all limits hold
    double improvement = 0; ///< expected beyond the best that there is, in the metric's unit, times feasible
};
/// The points that are most worth computing next, the best first. fabric and experiment: of several. Throws Error.
std::vector<SuggestedPoint> suggest(const StudyFolder& study, const StudyTable& table, const std::vector<Surface>& surfaces,
                                    const StudyGoal& goal, const std::string& fabric, const std::string& experiment, int count);

/// Writes sensitivity.json and surface.json. Throws Error.
void analyse_study(const std::filesystem::path& folder);

} // namespace hygroloom
