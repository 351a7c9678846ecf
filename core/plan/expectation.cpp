// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/expectation.h"

#include "core/base/student.h"
#include "core/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace hygroloom {
namespace {

/// Whether liquid moves by another law.
bool moves_otherwise(const ModelPlan& a, const ModelPlan& b) { return a.on("wicking") && a.counts.closure != b.counts.closure; }

/// How unlike two scenes are: of different types of experiment, then with and without falling drops, by another closure, then by suction
/// and number of drops.
double distance(const ModelPlan& a, const ModelPlan& b)
{
    double far = std::abs(a.counts.suction - b.counts.suction);
    if (a.counts.type != b.counts.type) far += 100;
    if (a.on("liquid") != b.on("liquid")) far += 10;
    if (a.on("cap") != b.on("cap")) far += 10;
    if (moves_otherwise(a, b)) far += 2;
    if (a.on("wicking") != b.on("wicking")) far += 1;
    return far + 0.1 * std::abs(std::log(std::max(1.0, a.counts.drops) / std::max(1.0, b.counts.drops)));
}

struct Nearest {
    const MeasuredScene* scene = nullptr;
    const MeasuredRun* run = nullptr;
};

/// Whether the measured run is set as the plan, but for knobs that change nothing in the plan's scene; where neither goes in bundles, how
/// large they might have been does not count.
bool set_alike(const ModelPlan& measured, const ModelPlan& plan)
{
    if (measured.on("cap") != plan.on("cap")) return false;
    Knobs knobs = measured.knobs;
    if (measured.crossings_per_cell == 1 && plan.crossings_per_cell == 1) {
        knobs.crossings_per_cell = plan.knobs.crossings_per_cell;
        knobs.crossings_per_even_cell = plan.knobs.crossings_per_even_cell;
    }
    for (const KnobInfo& knob : knob_table())
        if (plan.idle_knobs.contains(knob.name)) knobs.*knob.value = plan.knobs.*knob.value;
    return knobs == plan.knobs;
}

/// That of its fidelity, in the scene that is least unlike.
Nearest nearest_run(const ModelPlan& plan, const std::vector<MeasuredScene>& measured)
{
    Nearest nearest;
    double least = 100; // scenes of other types are not compared
    for (const MeasuredScene& scene : measured)
        for (const MeasuredRun& run : scene.runs) {
            if (run.plan.fidelity != plan.fidelity || run.seconds == 0) continue;
            const double far = distance(plan, run.plan);
            if (far >= least) continue;
            least = far;
            nearest = {&scene, &run};
        }
    return nearest;
}

bool is_cut(const ModelPlan& plan)
{
    return std::any_of(plan.parts.begin(), plan.parts.end(), [](const PlannedPart& p) { return p.forced && !p.on; });
}

/// Of each metric the error that 90 % of the runs so set keep, by Student's law from the mean square of those of all measured scenes of the
/// kind, with the mean square of those of the references that are known; wider, the less alike the nearest of them is. Scenes that were not
/// measured on the plan's backend at its fidelity count as they were on another, for both compute the same.
std::map<std::string, double> errors_of_kind(const ModelPlan& plan, const std::vector<MeasuredScene>& measured,
                                             const std::vector<MeasuredScene>& elsewhere)
{
    struct Squares {
        double sum = 0, of_references = 0;
        int count = 0, references = 0;
    };
    std::map<std::string, Squares> squares;
    double nearest = 1;
    const auto take = [&](const MeasuredScene& scene) {
        for (const MeasuredRun& run : scene.runs) {
            const double far = distance(plan, run.plan);
            if (far >= 1 || run.plan.fidelity != plan.fidelity || !set_alike(run.plan, plan)) continue;
            nearest = std::min(nearest, far);
            for (const auto& [metric, error] : run.errors) {
                Squares& of = squares[metric];
                of.sum += error * error;
                ++of.count;
                const auto own = scene.reference_errors.find(metric);
                if (own == scene.reference_errors.end()) continue;
                of.of_references += own->second * own->second;
                ++of.references;
            }
        }
    };
    for (const MeasuredScene& scene : measured) take(scene);
    const auto has_this = [&](const MeasuredScene& own) {
        return std::any_of(own.runs.begin(), own.runs.end(), [&](const MeasuredRun& run) { return run.plan.fidelity == plan.fidelity; });
    };
    for (const MeasuredScene& scene : elsewhere)
        if (std::none_of(measured.begin(), measured.end(),
                         [&](const MeasuredScene& own) { return own.name == scene.name && has_this(own); }))
            take(scene);
    std::map<std::string, double> errors;
    for (const auto& [metric, of] : squares)
        errors[metric] = (1 + nearest) * student_factor(of_intervals, of.count) *
                         std::sqrt(of.sum / of.count + of.of_references / std::max(1, of.references));
    return errors;
}

/// Where nothing of the kind was measured on the plan's backend at its fidelity: the errors that were found on another.
void take_errors_from(ModelPlan& plan, const std::vector<MeasuredScene>& measured, const std::vector<MeasuredScene>& elsewhere)
{
    const Nearest nearest = nearest_run(plan, elsewhere);
    if (!nearest.run || distance(plan, nearest.run->plan) >= 1 || !set_alike(nearest.run->plan, plan) || is_cut(plan) ||
        moves_otherwise(plan, nearest.run->plan))
        return;
    plan.expected_error = nearest.run->error;
    plan.expected_errors = errors_of_kind(plan, measured, elsewhere);
    plan.expectation_source +=
        fmt::format(" The numerical error was measured on a run of {} on {}.", nearest.scene->name, nearest.scene->device);
}

} // namespace

void expect(ModelPlan& plan, const std::vector<MeasuredScene>& measured, const std::vector<MeasuredScene>& elsewhere)
{
    const Nearest nearest = nearest_run(plan, measured);
    plan.expected_error.reset();
    plan.expected_errors.clear();
    if (!nearest.run) {
        const std::string backend = measured.empty() ? "cpu" : measured.front().backend;
        plan.expected_seconds = rough_work(plan, backend);
        plan.expected_bytes = 40e6 + rough_bytes(plan);
        plan.expectation_source = fmt::format("A rough guess from unit costs of {}: no scene of this kind was measured at this fidelity.",
                                              backend == "cuda" ? "an NVIDIA H100" : "a core of an AMD EPYC");
        take_errors_from(plan, measured, elsewhere);
        return;
    }
    const MeasuredRun& run = *nearest.run;
    const MeasuredScene& scene = *nearest.scene;
    // Steps make no set-up longer. A machine may have set up faster than is counted; the rest of a run is what steps took.
    constexpr double most_set_up = 0.7;
    const double set_up = set_up_seconds(plan, scene.backend), set_up_there = set_up_seconds(run.plan, scene.backend);
    const double started = std::min(set_up_there, most_set_up * run.seconds);
    plan.expected_seconds = set_up * started / set_up_there + (run.seconds - started) * (rough_work(plan, scene.backend) - set_up) /
                                                                  (rough_work(run.plan, scene.backend) - set_up_there);
    plan.expected_bytes = std::max(0.5 * run.bytes, run.bytes + rough_bytes(plan) - rough_bytes(run.plan));
    const bool is_reference = run.plan.fidelity == Fidelity::reference;
    const bool otherwise = moves_otherwise(plan, run.plan) && !is_reference,
               as_set = set_alike(run.plan, plan) && !is_cut(plan) && !otherwise;
    if (as_set) plan.expected_error = run.error;
    if (as_set) plan.expected_errors = errors_of_kind(plan, measured, elsewhere);
    plan.expectation_source =
        fmt::format("Estimated from a measured run of {} ({} s on {}, {}): its time is multiplied by {:.3g}.{}", scene.name,
                    rounded_text(run.seconds, 3), scene.device, scene.date, plan.expected_seconds / run.seconds,
                    run.error && as_set ? (*run.error > 0 ? fmt::format(" The numerical error was measured on {}.",
                                                                        run.errors_from.empty() ? "that run" : "one on " + run.errors_from)
                                           : is_reference ? ""
                                                          : " On that run no result differed from the reference's.")
                    : as_set            ? " Its numerical error was not measured."
                    : otherwise         ? fmt::format(" It was measured with the closure {}; with {} neither times nor errors are.",
                                                      run.plan.counts.closure, plan.counts.closure)
                                        : " The numerical error with these knobs and parts was not measured.");
}

namespace {

/// "8 runs of this kind and 2 at other fidelities"
std::string learned_runs_text(int same, int other)
{
    const auto runs = [](int count) { return count == 1 ? std::string("One run") : fmt::format("{} runs", count); };
    if (same == 0) return fmt::format("{} of this kind at {}", runs(other), other == 1 ? "another fidelity" : "other fidelities");
    const std::string more = other == 0 ? "" : fmt::format(" and {} at {}", other, other == 1 ? "another fidelity" : "other fidelities");
    return fmt::format("{} of this kind{}", runs(same), more);
}

} // namespace

std::optional<double> learned_ratio(const std::vector<UnlikeRun>& runs)
{
    constexpr double as_good_as_alike = 0.03;
    double weights = 0, sum = 0;
    for (const UnlikeRun& run : runs) {
        const double far = run.unlike + as_good_as_alike;
        weights += 1 / (far * far);
        sum += std::log(run.ratio) / (far * far);
    }
    const double ratio = std::exp(sum / weights);
    return !runs.empty() && std::isfinite(ratio) ? std::optional(ratio) : std::nullopt;
}

std::string learned_text(int same, int other, double ratio)
{
    return fmt::format(" {} on this machine took {} times {} estimate, so this time is corrected.", learned_runs_text(same, other),
                       rounded_text(ratio, 2), same + other == 1 ? "its" : "their");
}

void correct_time(ModelPlan& plan, const std::vector<LearnedRun>& learned)
{
    std::vector<UnlikeRun> runs;
    int same = 0, other = 0; // fidelity
    for (const LearnedRun& run : learned) {
        const double unlike = distance(plan, run.plan);
        if (unlike >= 1) continue;
        const double work = std::abs(std::log(rough_work(plan, "cpu") / rough_work(run.plan, "cpu")));
        const bool alike = run.plan.fidelity == plan.fidelity;
        runs.push_back({unlike + work + (alike ? 0.0 : unlike_at_other_fidelity), run.ratio});
        ++(alike ? same : other);
    }
    const std::optional<double> ratio = learned_ratio(runs);
    if (!ratio) return;
    plan.expected_seconds *= *ratio;
    plan.expectation_source += learned_text(same, other, *ratio);
}

} // namespace hygroloom
