// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a run will cost and how far it will lie from the reference, from measured runs of scenes of its kind and from its own counts.
#pragma once

#include "core/plan/model_plan.h"

#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

/// A run of a scene at a fidelity; tradeoff made it.
struct MeasuredRun {
    ModelPlan plan;                            ///< as far as expectations need it; its knobs are the fidelity's
    double seconds = 0;                        ///< of wall time; 0: it was not timed
    double bytes = 0;                          ///< largest resident set
    std::optional<double> error = {};          ///< against the reference, relative; none: not measured
    std::map<std::string, double> errors = {}; ///< the same of each metric
    std::string errors_from = {};              ///< device on which errors were found; empty: this run's
};

struct MeasuredScene {
    std::string name; ///< "one drop on Drill"
    std::string backend, device, date;
    std::vector<MeasuredRun> runs = {}; ///< those with a time or errors
    /// Of each metric: of the reference against one twice as fine, and of that against one four times as fine, summed.
    std::map<std::string, double> reference_errors = {};
};

/// The table of some scenes as CSV: of each a row of what its runs share, a row for each run, one of what the reference itself lacks.
std::string measured_csv(const std::vector<MeasuredScene>& scenes);
/// What measured_csv() wrote; where a scene lacks errors on one backend, those of the other. Throws Error with the name of the file.
std::vector<MeasuredScene> measured_scenes(const std::string& csv, const std::string& file);

/// Those that ship with the program, of a backend ("cpu", "cuda"): resources/tradeoff/measured.csv.
const std::vector<MeasuredScene>& shipped_measurements(const std::string& backend);
/// Of all backends.
const std::vector<MeasuredScene>& shipped_measurements();

/// Estimated work of the free liquid of a run: a guess, of which only ratios between scenes are right.
struct LiquidCount {
    double steps = 0;
    double particles = 0; ///< on average over the steps
};

/// From the plan's counts and knobs; nothing where no liquid is on. A drop moves until it rests, a few capillary times long. Then, as long
/// as yarns absorb it, it is awake for a share of the time, and where they absorb slowly for some capillary times of each share of it that
/// has gone; what has gone goes with the root of time. What does not stay on a small sample falls past it. Where the cloth under it holds
/// little its particles shrink together, and most of them last until it is gone; else they vanish one after the other. Calibrated on ratios
/// of what 43 drops of 2 to 15 ul took at draft and at standard: tests/data/liquid_counts, core/plan/DECISIONS.md.
LiquidCount count_liquid(const ModelPlan& plan);

/// What comes before the first step, s: the start of the scene, and the rooms between yarns, which are drawn.
double set_up_seconds(const ModelPlan& plan, const std::string& backend);
/// Work of a run in seconds of one measured machine, a rough guess that only its ratio to that of a run of the same kind makes useful.
double rough_work(const ModelPlan& plan, const std::string& backend);
/// Memory that grows with the scene, bytes: its arrays, its geometry and its frames, without the program.
double rough_bytes(const ModelPlan& plan);

/// Fills in the plan's expectation: from the measured run of its fidelity in the scene of its kind that is nearest, scaled by the ratio of
/// their rough works; without any, from the rough work alone on the machine that the others were measured on, and without an error.
/// elsewhere: scenes of other backends, whose errors count where measured lacks the scene.
void expect(ModelPlan& plan, const std::vector<MeasuredScene>& measured, const std::vector<MeasuredScene>& elsewhere = {});

/// What a run of this machine took against what was expected of it.
struct LearnedRun {
    ModelPlan plan;
    double ratio = 1; ///< its time over the expected one
};

/// What one run took against its estimate, and how unlike it is, 0: the same.
struct UnlikeRun {
    double unlike = 0;
    double ratio = 1;
};
/// The geometric mean of the ratios, the more alike the more they count; none: there is no run, or no finite mean.
std::optional<double> learned_ratio(const std::vector<UnlikeRun>& runs);
/// What adds to unlike where the fidelities differ.
constexpr double unlike_at_other_fidelity = 0.5;
/// " 8 runs of this kind and 2 at other fidelities on this machine took 1.3 times their estimate, so this time is corrected."
std::string learned_text(int same, int other, double ratio);

/// Multiplies the plan's expected time by the ratios of the runs of its kind, the more alike the more they count (geometric mean), and adds
/// that to the source. Precondition: expect().
void correct_time(ModelPlan& plan, const std::vector<LearnedRun>& learned);

/// "error 4.8 %", or that it was not measured, or that there is none by definition.
std::string error_text(const ModelPlan& plan);

/// What is expected of several runs at one fidelity, one after the other: their times together, the largest of their errors (none where one
/// is not known). Precondition: there is one.
ModelPlan expected_of_all(const std::vector<ModelPlan>& plans);

/// What the user wants of --fidelity auto: one of both.
struct FidelityTarget {
    std::optional<double> error;   ///< at most, relative
    std::optional<double> seconds; ///< at most
};

/// "5%", "0.05" -> 0.05. Throws Error naming the option, the range and the text.
double parse_error_target(const std::string& text);
/// "10s", "10", "2min", "1h" -> s. Throws Error likewise.
double parse_time_target(const std::string& text);

/// A fidelity, and why.
struct FidelityChoice {
    Fidelity fidelity = Fidelity::standard;
    std::string reason;
};

/// The cheapest plan that is expected to keep the error, or the finest that is expected to keep the time. plans: of all fidelities, the
/// coarsest first. Where none is known to keep it: the reference for an error, the draft for a time, and the reason says so.
FidelityChoice choose_fidelity(const std::vector<ModelPlan>& plans, const FidelityTarget& target);

} // namespace hygroloom
