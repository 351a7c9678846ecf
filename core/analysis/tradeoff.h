// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Speed against accuracy of one scene: variants of a run, how far each lies from the reference, and which are worth their time.
#pragma once

#include "core/analysis/metrics.h"
#include "core/solver/stage_clock.h"

#include <array>
#include <map>
#include <optional>

namespace hygroloom {

/// One way to run the scene.
struct TradeoffVariant {
    std::string name; ///< "draft", "fibre_shells=5", "reference x 2"
    Fidelity fidelity = Fidelity::standard;
    KnobSettings settings;
    bool timed = true; ///< convergence runs are made once and not timed
};

/// live, draft, standard, reference; then standard with one knob a step cheaper and a step finer, of the named knobs or, without names, of
/// all. Throws Error when a name is not one of a knob.
std::vector<TradeoffVariant> tradeoff_variants(const std::vector<std::string>& knobs);
/// The ladder alone.
std::vector<TradeoffVariant> tradeoff_ladder();
/// The reference, with the settings on top, twice and four times as fine: resolutions are multiplied by 2 and 4, steps and tolerances
/// divided, within the ranges of the knobs.
std::vector<TradeoffVariant> convergence_variants(const KnobSettings& settings);

/// Whether the plans describe the same run of one scene.
bool run_alike(const ModelPlan& a, const ModelPlan& b);

/// What is kept of a run at one time.
struct TradeoffMoment {
    double time = 0;                        ///< s
    std::map<std::string, double> contents; ///< kg: free, in pores, bound over the start, evaporated, dripped
    std::vector<double> map;                ///< kg/m2, cells of 2 x 2 crossings of both faces together
    std::vector<char> wet;                  ///< one per segment, 0 or 1
};

/// What is kept of one run, with moments at a quarter, a half, three quarters and the end of it.
struct TradeoffOutcome {
    std::map<std::string, std::optional<double>> metrics; ///< by key, see outcomes_of(); none: could not be determined
    std::map<std::string, double> closed_forms;           ///< of metrics: see closed_forms(); none of a sample that still changed
    std::vector<TradeoffMoment> moments;
    double air_temperature_c = 0; ///< at the end
    double wall = 0;              ///< s
    double peak_bytes = 0;        ///< 0: not known
    long liquid_steps = 0;
    std::string backend, device;
    std::vector<StageTime> stages;
    ModelPlan plan;
    std::vector<SwitchedPart> switched_on; ///< that the plan had left out
};

/// Keeps what a TradeoffOutcome needs, frame by frame.
class OutcomeCollector {
public:
    void start(const RunRecord& run);
    void add(const Frame& frame);
    /// run: as run_experiment() returned it.
    TradeoffOutcome outcome(const RunRecord& run) const;

private:
    MetricsCollector metrics_;
    RunRecord run_;
    std::optional<Frame> start_; ///< of the maps
    double duration_ = 0;
    double air_temperature_c_ = 0;
    double bound_at_start_ = 0;
    std::vector<TradeoffMoment> moments_;
};

/// One number beside that of the reference.
struct MetricError {
    std::string name;
    std::optional<double> value, reference;
    double error = 0; ///< relative; 1 when only one of both could be determined
};

/// What an error of a metric is a share of: its value, a temperature's distance from the air's, of one-way transport 100 % at least; what
/// arms a stain has is a share already.
double error_scale(const std::string& metric, double value, double air_temperature_c);

/// How far a run lies from the reference.
struct TradeoffErrors {
    std::vector<MetricError> metrics; ///< then the contents: the largest difference at the kept times over the water at stake
    std::optional<double> map;        ///< relative L2 over cells and times; none: the reference moved no water
    std::optional<double> overlap;    ///< of the wetted areas, intersection over union, over the times; none: nothing got wet in either
    double largest = 0;               ///< of the metrics, the contents and, of experiments that wet a part of the cloth, 1 - overlap
};

/// Metrics are compared relatively to the reference's; a temperature to its distance from the air, or to 1 K where that is less.
TradeoffErrors tradeoff_errors(const TradeoffOutcome& run, const TradeoffOutcome& reference);
/// How far its metrics lie from closed forms, scaled alike.
std::vector<MetricError> closed_form_errors(const TradeoffOutcome& run);

/// A measured variant.
struct TradeoffPoint {
    TradeoffVariant variant;
    ModelPlan plan;
    std::vector<SwitchedPart> switched_on; ///< that the plan had left out, in the last repeat
    std::vector<double> walls;             ///< s, of each repeat
    std::vector<double> peaks;             ///< bytes, of each repeat
    long liquid_steps = 0;
    std::optional<TradeoffErrors> errors;  ///< none: there is no reference yet
    std::vector<MetricError> closed_forms; ///< see closed_form_errors()
    std::map<std::string, double> stages;  ///< percent of the wall time
    bool pareto = false;                   ///< nothing timed is both faster and more accurate
    std::vector<std::string> stands_for;   ///< variants that were left out because their runs would be the same
    double wall() const;                   ///< median, s
    double peak() const;                   ///< median, bytes
};

/// Difference of one coarser reference to the next finer one.
struct ConvergenceStep {
    std::string coarse, fine;
    TradeoffErrors errors;
};

/// All that was measured of a scene, and where.
struct Tradeoff {
    std::string program, commit, machine, backend, device, date; ///< date: ISO 8601, UTC
    int threads = 0;                                             ///< 0: all of the machine
    int repeats = 0;
    double load = -1; ///< processes that ran or waited at the start, mean of a minute, of all the machine; less than 0: not known
    std::string fabric, experiment, type;
    double duration = 0;   ///< s
    bool complete = false; ///< every variant has all of its repeats
    std::vector<TradeoffPoint> points;
    std::vector<ConvergenceStep> convergence;
};

/// Without measurements: the program, the machine and the scene.
Tradeoff tradeoff_here(const Fabric& fabric, const Experiment& experiment);

double median(std::vector<double> values);
/// Marks the points that nothing beats. Points without errors are on no front.
void mark_pareto(std::vector<TradeoffPoint>& points);

/// Format "hygroloom-tradeoff", version 1.
std::string tradeoff_json(const Tradeoff& tradeoff);
/// What tradeoff_json() wrote. Throws Error with the name of the file.
Tradeoff tradeoff_from_json(const std::string& text, const std::string& file);
/// One row per point.
std::string tradeoff_csv(const Tradeoff& tradeoff);
/// Error against time, both logarithmic, with the Pareto front. Points with an error below 1e-5 stand on the lower edge.
std::string tradeoff_svg(const Tradeoff& tradeoff);

/// An outcome on its way from the process of a run to the one that compares.
std::string outcome_json(const TradeoffOutcome& outcome);
TradeoffOutcome outcome_from_json(const std::string& text);

} // namespace hygroloom
