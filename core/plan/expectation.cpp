// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/expectation.h"

#include "core/base/student.h"
#include "core/base/text.h"
#include "core/physics/liquid.h"
#include "core/physics/particle_steps.h"
#include "core/plan/bundles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace hygroloom {
namespace {

/// Segments that are simulated: bundles', where yarns go in bundles.
double cells_of(const ModelPlan& plan)
{
    const int wanted = plan.crossings_per_cell;
    return wanted > 1 ? 2.0 * bundles_of(plan.region.ends, wanted).count * bundles_of(plan.region.picks, wanted).count : plan.segments;
}

double frames_of(const ModelPlan& plan) { return plan.counts.duration / std::max(1e-9, plan.frame_interval); }

bool flows_by_suction(const ModelPlan& plan) { return plan.counts.closure == name_of(Closure::pores); }

/// In which a drop's liquid swings once, s.
double swing_of(const SceneCounts& scene, double volume) { return capillary_time(volume, 1.0, scene.capillarity); } // tension over density

/// Until cloth with the closure pores has absorbed a drop, s: some swings, and longer where the cloth under it must hand liquid on that it
/// cannot hold. Set on the absorbency times of the 54 drops of tests/data/liquid_counts/drops-pores.csv that were absorbed, of which half
/// come out within a factor of 1.5. Steps depend less on it.
double absorbed_by_suction_in(const SceneCounts& scene)
{
    constexpr double swings = 9.8, uptakes = 0.155, power = 1.5;
    const double drop = std::max(1e-18, scene.drop_volume);
    const double times_its_room = std::cbrt(drop) / std::max(1e-12, scene.pores * scene.drop_base);
    return swings * swing_of(scene, drop) + uptakes * drop / scene.uptake * std::pow(times_its_room, power);
}

struct NetworkCount {
    double steps = 0;
    double segments = 0; ///< that are visited
};

/// Of the yarns, while drops are about. By suction they are not for long, and front places ask for shorter steps.
double steps_with_drops(const ModelPlan& plan)
{
    const SceneCounts& scene = plan.counts;
    const bool soon_gone = flows_by_suction(plan) && plan.on("wicking") && scene.uptake > 0;
    if (!soon_gone) return scene.duration / plan.knobs.network_step_limit;
    constexpr double of_the_limit = 0.7;
    return std::min(scene.duration, std::max(1.0, scene.drops) * absorbed_by_suction_in(scene)) /
           (of_the_limit * plan.knobs.network_step_limit);
}

NetworkCount count_network(const ModelPlan& plan)
{
    NetworkCount count;
    if (!plan.on("wicking") && !plan.on("sorption") && !plan.on("vapour")) return count;
    count.segments = cells_of(plan) * (plan.on("growth") ? plan.counts.wet_share : 1.0);
    constexpr double standard_error = 5e-4;
    const double finer = std::sqrt(standard_error / std::max(1e-9, plan.knobs.step_error)); // the step's error falls with its square
    count.steps = frames_of(plan) * std::max(1.0, finer);
    if (plan.on("liquid")) count.steps += steps_with_drops(plan);
    // From a pool steps go with the way of the front, which goes with the root of time.
    constexpr double usual = 120; // s
    if (!plan.on("liquid") && plan.counts.type == name_of(ExperimentType::moisture_management))
        count.steps *= std::sqrt(plan.counts.duration / usual);
    return count;
}

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

/// The run that was set as this one, or that of its fidelity, in the scene that is least unlike.
Nearest nearest_run(const ModelPlan& plan, const std::vector<MeasuredScene>& measured)
{
    Nearest nearest;
    double least = 100; // scenes of other types are not compared
    for (const MeasuredScene& scene : measured)
        for (const MeasuredRun& run : scene.runs) {
            if (run.plan.fidelity != plan.fidelity || run.seconds == 0) continue;
            const bool as_set = set_alike(run.plan, plan);
            if (!as_set && !run.settings.empty()) continue;
            const double far = distance(plan, run.plan) + (as_set ? 0.0 : 1e-3);
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
        if (std::none_of(measured.begin(), measured.end(), [&](const MeasuredScene& own) { return own.is_of(scene) && has_this(own); }))
            take(scene);
    std::map<std::string, double> errors;
    for (const auto& [metric, of] : squares)
        errors[metric] = (1 + nearest) * student_factor(of_intervals, of.count) *
                         std::sqrt(of.sum / of.count + of.of_references / std::max(1, of.references));
    return errors;
}

} // namespace

namespace {

/// To set up a scene, however small, s.
double start_on(const std::string& backend) { return backend == "cuda" ? 0.02 : 0.01; }

/// Of a drop's steps.
double step_of(const ModelPlan& plan, double spacing)
{
    constexpr double usual_step = 0.85; // of the longest
    const SceneCounts& scene = plan.counts;
    const LiquidSteps longest =
        longest_steps(scene.capillarity, viscosity_of_particles(scene.viscosity, scene.capillarity, spacing), spacing);
    return plan.knobs.liquid_step_factor * usual_step * std::min(longest.capillary, longest.viscous);
}

/// A drop that falls, is absorbed as it lies, and sleeps for most of that time. Set on drops-pores.csv.
LiquidCount count_by_suction(const ModelPlan& plan, double volume, double particles)
{
    constexpr double moving_swings = 13, flowing_share = 0.17, left = 0.55; // of the particles, on average
    constexpr double resting_swings = 10;                                   // of one that is not absorbed
    const SceneCounts& scene = plan.counts;
    const bool is_absorbed = plan.on("wicking") && scene.uptake > 0, sleeps = plan.knobs.settle_share > 0;
    const double until_empty = is_absorbed ? absorbed_by_suction_in(scene) : scene.duration;
    const double moves = (is_absorbed ? moving_swings : resting_swings) * swing_of(scene, volume);
    const double flows = !sleeps ? until_empty : is_absorbed ? flowing_share * until_empty : 0.0;
    const double share = is_absorbed && until_empty < scene.duration ? left : 1.0;
    return {std::min(scene.duration, moves + flows) / step_of(plan, std::cbrt(volume / particles)), share * particles * scene.drops};
}

} // namespace

LiquidCount count_liquid(const ModelPlan& plan)
{
    if (!plan.on("liquid")) return {};
    const SceneCounts& scene = plan.counts;
    const double volume = std::max(1e-18, scene.drop_volume), settle_share = plan.knobs.settle_share;
    const double particles = std::max(1, plan.particles_per_droplet);
    if (flows_by_suction(plan)) return count_by_suction(plan, volume, particles);
    constexpr double usual_particles = 8000, usual_spacing = 85e-6; // m
    constexpr double moving_times = 7, waking_times = 6;            // swings
    constexpr double absorption_time = 0.68;                        // times its volume over the cloth's uptake
    constexpr double scarce_pores = 0.13e-3;              // m, of pores times the drop's base: so few leave the usual particles all there
    constexpr double least_left = 0.15, most_left = 0.97; // of the particles, on average while the drop is absorbed
    const double spacing = std::cbrt(volume / particles), step = step_of(plan, spacing);
    const double moves = std::min(moving_times * swing_of(scene, volume), scene.duration), rest = scene.duration - moves;
    const bool is_absorbed = plan.on("wicking") && scene.uptake > 0;
    const double until_empty = is_absorbed ? absorption_time * volume / scene.uptake : 0,
                 absorbing = is_absorbed ? std::min(rest, until_empty) : 0;
    const double gone = is_absorbed ? std::sqrt(absorbing / until_empty) : 0; // share of the drop, in the end
    double flows = is_absorbed ? absorbing : rest;
    if (settle_share > 0) {
        const double awake_share = 0.12 * std::pow(spacing / usual_spacing, 0.3);
        flows = std::min(awake_share * absorbing, gone / settle_share * waking_times * swing_of(scene, settle_share * volume));
    }
    const double under_drop = std::max(1e-12, scene.drop_base * scene.pores);
    const double left = std::clamp(scarce_pores / under_drop * std::cbrt(usual_particles / particles), least_left, most_left);
    const double flowing = 1.0 - (1.0 - left) * gone; // share of the particles
    return {(moves + flows) / step, particles * scene.drops * (moves + flows * flowing) / (moves + flows)};
}

double rough_work(const ModelPlan& plan, const std::string& backend)
{
    const LiquidCount liquid = count_liquid(plan);
    const NetworkCount network = count_network(plan);
    constexpr double shown = 3e-8; // s, for a segment in a frame and its metrics
    const double frames = shown * plan.segments * frames_of(plan);
    if (backend == "cuda") {
        // Seconds on an H100: a step takes a while however little there is to do. Start and network step are the best of eight pairs on
        // the GPU's runs of tests/data/tradeoff, which test them no more.
        constexpr double liquid_step = 1.2e-4, particle = 3e-9, network_step = 4e-4, segment = 1e-9;
        return start_on(backend) + frames + liquid.steps * (liquid_step + particle * liquid.particles) +
               network.steps * (network_step + segment * network.segments);
    }
    // Seconds on two cores of an AMD EPYC: per particle and liquid step, and per segment and step of the yarns, and to set up.
    constexpr double particle = 1.5e-6, segment = 0.7e-6;
    constexpr double at_cloth = 0.1; // of the work, with particles at the cloth, of which there are as many as long as the drop lasts
    const double busy = (1.0 - at_cloth) * liquid.particles + at_cloth * plan.particles_per_droplet * plan.counts.drops;
    const double wider = plan.knobs.double_precision != 0 ? 2.6 : 1.0; // measured with 2 000 particles
    return start_on(backend) + frames + liquid.steps * busy * particle * wider + network.steps * network.segments * segment;
}

double rough_bytes(const ModelPlan& plan)
{
    const double particles = plan.particles_per_droplet * plan.counts.drops;
    const double shells = plan.watches("sorption") ? plan.knobs.fibre_shells : plan.fibre_shells; // it may come on
    const double wider = plan.knobs.double_precision != 0 ? 1.5 : 1.0;
    const double shape = plan.on("liquid") ? 24.0 : 0.0; // of a cell, as particles meet it
    // What is shown of a segment, and what is simulated of a cell.
    return 180.0 * plan.segments + cells_of(plan) * (220.0 + shape + 8.0 * shells) +
           wider * particles * (8.0 * most_near + 4.0 * most_distant + 250.0);
}

namespace {

/// Where nothing of the kind was measured on the plan's backend at its fidelity: the errors that were found on another.
void take_errors_from(ModelPlan& plan, const std::vector<MeasuredScene>& measured, const std::vector<MeasuredScene>& elsewhere)
{
    const Nearest nearest = nearest_run(plan, elsewhere);
    if (!nearest.run || distance(plan, nearest.run->plan) >= 1 || !set_alike(nearest.run->plan, plan) || is_cut(plan) ||
        moves_otherwise(plan, nearest.run->plan))
        return;
    plan.expected_error = nearest.run->error;
    plan.expected_errors = errors_of_kind(plan, measured, elsewhere);
    plan.expectation_source += fmt::format(" The numerical error was measured on a run of {}, {} on {}.", nearest.scene->fabric,
                                           nearest.scene->experiment, nearest.scene->device);
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
                                              backend == "cuda" ? "an NVIDIA H100" : "2 cores of an AMD EPYC");
        take_errors_from(plan, measured, elsewhere);
        return;
    }
    const MeasuredRun& run = *nearest.run;
    const MeasuredScene& scene = *nearest.scene;
    plan.expected_seconds =
        std::max(start_on(scene.backend), run.seconds * rough_work(plan, scene.backend) / rough_work(run.plan, scene.backend));
    plan.expected_bytes = std::max(0.5 * run.bytes, run.bytes + rough_bytes(plan) - rough_bytes(run.plan));
    const bool is_reference = run.plan.fidelity == Fidelity::reference;
    const bool otherwise = moves_otherwise(plan, run.plan) && !is_reference,
               as_set = set_alike(run.plan, plan) && !is_cut(plan) && !otherwise;
    if (as_set) plan.expected_error = run.error;
    if (as_set) plan.expected_errors = errors_of_kind(plan, measured, elsewhere);
    plan.expectation_source =
        fmt::format("Estimated from a measured run of {}, {} ({} s on {}, {}): its time is multiplied by {:.3g}.{}", scene.fabric,
                    scene.experiment, rounded_text(run.seconds, 3), scene.device, scene.date, plan.expected_seconds / run.seconds,
                    run.error && as_set ? (*run.error > 0 ? " The numerical error was measured on that run."
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

void correct_time(ModelPlan& plan, const std::vector<LearnedRun>& learned)
{
    constexpr double as_good_as_alike = 0.03;
    double weights = 0, sum = 0;
    int same = 0, other = 0; // fidelity
    for (const LearnedRun& run : learned) {
        const double unlike = distance(plan, run.plan);
        if (unlike >= 1) continue;
        const double work = std::abs(std::log(rough_work(plan, "cpu") / rough_work(run.plan, "cpu")));
        const bool alike = run.plan.fidelity == plan.fidelity;
        const double far = unlike + work + (alike ? 0.0 : 0.5) + as_good_as_alike;
        weights += 1 / (far * far);
        sum += std::log(run.ratio) / (far * far);
        ++(alike ? same : other);
    }
    if (same + other == 0) return;
    const double ratio = std::exp(sum / weights);
    if (!std::isfinite(ratio)) return;
    plan.expected_seconds *= ratio;
    plan.expectation_source += fmt::format(" {} on this machine took {} times {} estimate, so this time is corrected.",
                                           learned_runs_text(same, other), rounded_text(ratio, 2), same + other == 1 ? "its" : "their");
}

std::string error_text(const ModelPlan& plan)
{
    if (!plan.expected_error) return "numerical error not measured";
    if (plan.fidelity == Fidelity::reference) return "numerical error not known (this is the reference)";
    return fmt::format("numerical error {} %", rounded_text(100 * *plan.expected_error, 2));
}

ModelPlan expected_of_all(const std::vector<ModelPlan>& plans)
{
    ModelPlan all = plans.front();
    if (plans.size() == 1) return all;
    for (std::size_t i = 1; i < plans.size(); ++i) {
        all.expected_seconds += plans[i].expected_seconds;
        all.expected_bytes = std::max(all.expected_bytes, plans[i].expected_bytes);
        if (!plans[i].expected_error || !all.expected_error)
            all.expected_error.reset();
        else
            all.expected_error = std::max(*all.expected_error, *plans[i].expected_error);
    }
    all.expectation_source =
        fmt::format("That is the largest numerical error of {} runs, and the time of all, one after the other.", plans.size());
    return all;
}

} // namespace hygroloom
