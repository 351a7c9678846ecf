// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Speed against accuracy of one scene: its runs at several fidelities, and how far each lies from the reference.
#pragma once

#include "core/analysis/metrics.h"
#include "core/plan/expectation.h"

#include <map>
#include <optional>

namespace hygroloom {

/// What is kept of a run at one time.
struct TradeoffMoment {
    std::map<std::string, double> contents; ///< kg: free, in pores, bound over the start, evaporated, dripped
    std::vector<char> wet;                  ///< one per segment, 0 or 1
};

/// What is kept of one run, with moments at a quarter, a half, three quarters and the end of it.
struct TradeoffOutcome {
    std::map<std::string, std::optional<double>> metrics; ///< by key, see outcomes_of(); none: could not be determined
    std::vector<TradeoffMoment> moments;
    std::string type;             ///< of the experiment
    double air_temperature_c = 0; ///< at the end
    double wall = 0;              ///< s
    double peak_bytes = 0;        ///< 0: not known
    std::string backend, device;
};

/// Keeps what a TradeoffOutcome needs, frame by frame.
class OutcomeCollector {
public:
    void start(const RunRecord& run);
    void add(const Frame& frame);
    TradeoffOutcome outcome(const RunRecord& run, const Metrics& metrics) const;

private:
    TradeoffOutcome outcome_;
    double duration_ = 0;
    std::optional<double> bound_at_start_; ///< kg
};

/// What an error of a metric is a share of: its value, a temperature's distance from the air's, of one-way transport 100 % at least; what
/// arms a stain has is a share already.
double error_scale(const std::string& metric, double value, double air_temperature_c);

/// How far a run lies from the reference, relative; 1 where only one of both could determine a metric.
struct TradeoffErrors {
    std::map<std::string, double> metrics; ///< that both have; of contents the largest difference over the water at stake
    double largest = 0; ///< of what is meant for use and, of experiments that wet a part of the cloth, 1 - the overlap of wetted segments
};
TradeoffErrors tradeoff_errors(const TradeoffOutcome& run, const TradeoffOutcome& reference);

/// One way to run the scene, and what was measured of it.
struct TradeoffRun {
    std::string name; ///< "draft", "reference x 2"
    ModelPlan plan;
    KnobSettings settings;                       ///< on top of the fidelity's knobs
    std::string coarser = {};                    ///< the run that this one refines; empty: it is a fidelity
    std::vector<double> walls = {}, peaks = {};  ///< s, bytes, of each repeat
    std::optional<TradeoffOutcome> outcome = {}; ///< the last
    std::optional<TradeoffErrors> errors = {};   ///< against the reference; of the coarser run against this one, where it refines one
};
/// The reference's knobs, with the settings on top, so many times as fine: resolutions are multiplied, steps and tolerances divided, within
/// the ranges of the knobs.
KnobSettings refined(const KnobSettings& settings, double factor);

/// All that was measured of a scene, and where.
struct Tradeoff {
    std::string program, commit, machine, date; ///< date: ISO 8601, UTC
    double load = -1; ///< processes that ran or waited at the start, mean of a minute, of all the machine; less than 0: not known
    int threads = 0;  ///< 0: all of the machine
    int repeats = 0;
    std::string fabric, experiment;
    bool complete = false; ///< every run has all of its repeats
    std::vector<TradeoffRun> runs;
};
/// Without measurements: the program, the machine and the scene.
Tradeoff tradeoff_here(const std::string& fabric, const std::string& experiment);
/// Finds the errors of all runs that have ended.
void compare_runs(std::vector<TradeoffRun>& runs);

double median(std::vector<double> values);

/// Format "hygroloom-tradeoff", version 2.
std::string tradeoff_json(const Tradeoff& tradeoff);
/// Its runs at fidelities as they are, from what tradeoff_json() wrote. Throws Error with the name of the file.
MeasuredScene measured_scene(const std::string& json, const std::string& file);

/// An outcome on its way from the process of a run to the one that compares.
std::string outcome_json(const TradeoffOutcome& outcome);
TradeoffOutcome outcome_from_json(const std::string& text);

} // namespace hygroloom
