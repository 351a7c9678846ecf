// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whole runs: what must stay, stays; and every machine computes the same.
#include "core/analysis/measured_run.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/run/plan_run.h"
#include "core/verify/set_ups.h"
#include "core/verify/verify.h"

#include <algorithm>

namespace hygroloom {
namespace {

ExperimentType experiment_type(const std::string& word)
{
    std::string names;
    for (int i = 0; i < experiment_types; ++i) {
        const auto type = static_cast<ExperimentType>(i);
        if (word == name_of(type)) return type;
        names += (names.empty() ? "" : ", ") + std::string(name_of(type));
    }
    throw Error("experiment: Must be one of " + names + "; \"" + word + "\" was given.");
}

Closure closure_of(const std::string& word)
{
    std::string names;
    for (int i = 0; i < closures; ++i) {
        const auto closure = static_cast<Closure>(i);
        if (word == name_of(closure)) return closure;
        names += (names.empty() ? "" : ", ") + std::string(name_of(closure));
    }
    throw Error("closure: Must be one of " + names + "; \"" + word + "\" was given.");
}

/// A laboratory's experiment on a sample of a few millimetres, long enough for a part of it.
Experiment small_experiment(const VerifyValues& v)
{
    const ExperimentType type = experiment_type(v.at("experiment").word);
    const double volume = v.at("volume_ul").value, duration = v.at("duration_s").value;
    Experiment experiment = standard_experiment(type);
    experiment.climate.temperature_c = v.at("temperature_c").value;
    experiment.sample_mm = {12, 12};
    if (type == ExperimentType::vertical_wicking) experiment.sample_mm = {4, 30};
    experiment.immersion_mm = 5;
    experiment.volume_ul = volume;
    experiment.drop_ul = volume / 4; // of the tester: a usual drop may be all of it
    experiment.feed_s = std::min(experiment.feed_s, duration);
    for (Droplet& droplet : experiment.droplets) droplet.volume_ul = volume;
    experiment.duration_s = duration;
    experiment.closure = closure_of(v.at("closure").word);
    experiment.swelling = v.at("swelling").value != 0;
    return experiment;
}

/// Largest drifts over a run, over the water there was and the heat that was exchanged.
struct Drift {
    double mass = 0, energy = 0;
    void watch(const Ledger& l)
    {
        const double water = std::max(l.water_delivered, l.water_bound);
        if (water > 0) mass = std::max(mass, std::abs(l.water_imbalance()) / water);
        const double heat = std::abs(l.energy_released) + std::abs(l.energy_lost) + std::abs(l.energy_delivered);
        if (heat > 0) energy = std::max(energy, std::abs(l.energy_imbalance()) / heat);
    }
};

/// A small sample's experiment with all physics, and what came of it.
struct SmallRun {
    double pitch = 0; ///< m, from crossing to crossing
    Drift drift;
    Metrics metrics;
    Frame last;
};

SmallRun run_small(const VerifyValues& v, Backend& backend)
{
    Fabric fabric = library_fabric(v.at("fabric").word);
    if (v.at("contact_angle_deg").value >= 0) fabric.contact_angle_deg = v.at("contact_angle_deg").value;
    const Design design = design_of(fabric, small_experiment(v));
    RunOptions options;
    options.fidelity = fidelity_from_name(v.at("fidelity").word);
    options.forced = {{"vapour", true}, {"heat", true}, {"sorption", true}};
    RunControl control;
    SmallRun run;
    RunCallbacks callbacks;
    callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) {
        run.drift.watch(frame->ledger);
        run.last = *frame;
    };
    const FinishedRun finished = run_and_measure(design, fabric.name, design.experiments[0].name, options, backend, control, callbacks);
    run.pitch = std::max(finished.run.textile.warp.pitch, finished.run.textile.weft.pitch);
    run.metrics = finished.metrics;
    return run;
}

std::vector<VerifyResult> conservation(const VerifyValues& v, Backend& backend)
{
    const Drift drift = run_small(v, backend).drift;
    return {{"mass_drift", drift.mass, 0, 1e-9}, {"energy_drift", drift.energy, 0, 1e-9}};
}

/// Greatest difference of a field over its greatest value.
double difference(const std::vector<float>& a, const std::vector<float>& b)
{
    double largest = 1e-30, apart = 0;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<double>(b[i])));
        apart = std::max(apart, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    }
    return a.size() == b.size() ? apart / largest : 1.0;
}

/// The wet spot on yarns that pass nothing to each other, in steps of the same length whatever they are.
Scene wet_spot_on_lone_yarns()
{
    Scene scene = wet_spot();
    scene.cloth.crossing.assign(1, {});
    scene.rules.saturation_change = 1e3;
    return scene;
}

/// The same on coarser, slower yarns that take up more.
Scene wet_spot_on_coarse_yarns()
{
    Scene scene = wet_spot_on_lone_yarns();
    for (YarnParameters& yarn : scene.cloth.yarns) {
        yarn.pore_area *= 1.5;
        yarn.fibre_radius *= 2;
        yarn.fibre_specific_heat *= 0.8;
        yarn.liquid_diffusivity *= 0.3;
        yarn.vapour_diffusivity *= 0.6;
        yarn.isotherm.saturation_regain *= 1.2;
    }
    return scene;
}

/// Stripes of two yarns, three ends or two picks wide: every yarn must do what it does among its own kind.
std::vector<VerifyResult> mixed_yarns(const VerifyValues&, Backend& backend)
{
    const Scene fine = wet_spot_on_lone_yarns(), coarse = wet_spot_on_coarse_yarns();
    Scene mixed = fine;
    mixed.cloth.warp_types = 2;
    mixed.cloth.yarns = {fine.cloth.yarns[0], coarse.cloth.yarns[0], fine.cloth.yarns[1], coarse.cloth.yarns[1]};
    mixed.cloth.shapes = {fine.cloth.shapes[0], fine.cloth.shapes[0], fine.cloth.shapes[1], fine.cloth.shapes[1]};
    mixed.cloth.crossing.assign(4, {});
    for (int end = 0; end < mixed.cloth.ends; ++end) mixed.cloth.type[end] = end / 3 % 2 == 1;
    for (int pick = 0; pick < mixed.cloth.picks; ++pick) mixed.cloth.type[mixed.cloth.ends + pick] = pick / 2 % 2 == 1 ? 3 : 2;

    const std::vector<double> times{0.2};
    const Frame of_fine = frames_at(backend, fine, times).back(), of_coarse = frames_at(backend, coarse, times).back();
    const Frame here = frames_at(backend, mixed, times).back();
    std::vector<VerifyResult> results;
    for (const auto& [name, field] : {std::pair{"saturation", &Frame::saturation}, std::pair{"regain", &Frame::regain},
                                      std::pair{"vapour", &Frame::vapour}, std::pair{"temperature", &Frame::temperature}}) {
        std::vector<float> expected = of_fine.*field;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const int segment = static_cast<int>(i), weft = segment - mixed.cloth.crossings();
            const int line = weft < 0 ? segment / mixed.cloth.picks : mixed.cloth.ends + weft / mixed.cloth.ends;
            if (mixed.cloth.type[line] % 2 == 1) expected[i] = (of_coarse.*field)[i];
        }
        results.push_back({name, difference(here.*field, expected), 0, 0});
    }
    return results;
}

/// The liquid alone: a drop in the air falls and settles into its shape for a few steps.
Scene falling_drop(int particles)
{
    Scene scene = bare_scene(20, 20, 3e-4, 293.15);
    scene.rules.particles_per_droplet = particles;
    scene.supply.droplets.push_back({0, 5e-9, {1e-4, -2e-4, 3e-3}, 0.2});
    scene.rules.network_step = 1.0;
    return scene;
}

std::vector<VerifyResult> backends_agree(const VerifyValues&, Backend& backend)
{
    const auto reference = make_cpu_backend();
    reference->set_threads(1);
    const std::vector<double> times{0.05, 0.2};
    const Frame here = frames_at(backend, wet_spot(), times).back(), there = frames_at(*reference, wet_spot(), times).back();
    std::vector<VerifyResult> results{
        {"network_saturation", difference(here.saturation, there.saturation), 0, 1e-6},
        {"network_regain", difference(here.regain, there.regain), 0, 1e-6},
        {"network_vapour", difference(here.vapour, there.vapour), 0, 1e-6},
        {"network_temperature", difference(here.temperature, there.temperature), 0, 1e-6},
    };
    // Single precision: the sines and roots of two machines differ in the last bit, and a step carries that on.
    const Scene drop = falling_drop(1003);
    const std::vector<double> moments{1e-4};
    const Frame a = frames_at(backend, drop, moments).back(), b = frames_at(*reference, drop, moments).back();
    double apart = a.positions.size() == b.positions.size() ? 0.0 : 1.0;
    for (std::size_t i = 0; i < a.positions.size() && i < b.positions.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) apart = std::max(apart, static_cast<double>(std::abs(a.positions[i][k] - b.positions[i][k])));
    results.push_back({"drop_position_mm", 1e3 * apart, 0, 1e-5});
    return results;
}

bool same(const Frame& a, const Frame& b)
{
    return a.saturation == b.saturation && a.regain == b.regain && a.vapour == b.vapour && a.temperature == b.temperature &&
           a.positions == b.positions && a.velocities == b.velocities;
}

std::vector<VerifyResult> experiments_agree(const VerifyValues& v, Backend& backend)
{
    const auto reference = make_cpu_backend();
    const SmallRun here = run_small(v, backend), again = run_small(v, backend), there = run_small(v, *reference);
    const Ledger &a = here.metrics.ledger, &b = there.metrics.ledger;
    const double water = std::max(b.water_delivered, b.water_bound), mg = 1e6; // of all there is, an error of a part counts
    const auto alike = [&](const char* name, double computed, double expected) {
        return VerifyResult{name, mg * computed, mg * expected, 0.01 * mg * water};
    };
    const double radius = 1e3 * there.metrics.maximum_wetted_radius_top;
    const auto stain = [](const SmallRun& run) { // of the stain as an ellipse, the mean of its semi-axes
        return 1e3 * 0.5 * (run.metrics.wetted_area_ellipse_warp + run.metrics.wetted_area_ellipse_weft);
    };
    return {{"stain_mm", stain(here), stain(there), 0.01 * stain(there)},
            // The place of one crossing, so known to a crossing only.
            {"radius_mm", 1e3 * here.metrics.maximum_wetted_radius_top, radius, std::max(0.01 * radius, 1e3 * there.pitch)},
            alike("free_mg", a.water_free, b.water_free),
            alike("in_pores_mg", a.water_liquid, b.water_liquid),
            alike("in_fibres_mg", a.water_bound, b.water_bound),
            alike("evaporated_mg", a.water_evaporated, b.water_evaporated),
            {"mass_drift", here.drift.mass, 0, 1e-9},
            {"energy_drift", here.drift.energy, 0, 1e-9},
            {"differs_when_repeated", same(here.last, again.last) ? 0.0 : 1.0, 0, 0}};
}

/// Half of an experiment here, the other half here and on the CPU.
std::vector<VerifyResult> goes_on_on_cpu(const VerifyValues& v, Backend& backend)
{
    const double duration = v.at("duration_s").value;
    const Design design = design_of(library_fabric(v.at("fabric").word), small_experiment(v));
    const Experiment& experiment = design.experiments[0];
    const ModelPlan plan = plan_run(design, design.fabrics[0], experiment, Fidelity::draft, {{"vapour", true}, {"heat", true}});
    const Textile textile = textile_of_run(design, design.fabrics[0], experiment, plan.region);
    const Scene scene = build_scene(design, textile, experiment, plan, 1);
    const auto advance = [](Backend& machine, double until) {
        for (double reached = 0; reached < until;) reached = machine.advance(until);
    };
    backend.load(scene);
    advance(backend, 0.5 * duration);
    const auto other = make_cpu_backend();
    other->load(scene);
    backend.stay();
    other->go_on_from(backend.state());
    const Frame taken = backend.frame(), given = other->frame();
    advance(backend, duration);
    advance(*other, duration);
    const Ledger a = other->frame().ledger, b = backend.frame().ledger;
    const double water = std::max(b.water_delivered, b.water_bound);
    return {{"differs_at_once", same(taken, given) ? 0.0 : 1.0, 0, 0},
            {"free", a.water_free / water, b.water_free / water, 0.01},
            {"in_pores", a.water_liquid / water, b.water_liquid / water, 0.01},
            {"in_fibres", a.water_bound / water, b.water_bound / water, 0.01},
            {"imbalance", a.water_imbalance() / water, 0, 1e-12}};
}

} // namespace

std::vector<VerifyCase> whole_run_cases()
{
    const std::vector<VerifyParameter> small_run{
        {"experiment", 0, 0, 0, "droplet"}, {"fabric", 0, 0, 0, "Textile F"},       {"duration_s", 1, 1e-3, 1e4, ""},
        {"volume_ul", 3, 1e-3, 100, ""},    {"closure", 0, 0, 0, "paper"},          on_or_off("swelling", false),
        {"temperature_c", 20, -10, 60, ""}, {"contact_angle_deg", -1, -1, 180, ""}, {"fidelity", 0, 0, 0, "draft"}};
    std::vector<VerifyParameter> by_default = small_run;
    for (VerifyParameter& parameter : by_default)
        if (parameter.name == "closure") parameter.word = name_of(Closure::pores);
    return {
        {"conservation",
         "An experiment on a small sample with all physics: drift of mass over the water there is, of energy over the heat exchanged. A "
         "contact angle below 0 is the fabric's own.",
         by_default, conservation},
        {"experiments_agree",
         "The same on this backend, twice, and on the CPU: the stain within 1 %, its farthest crossing within one or 1 %, each part of the "
         "water within 1 % of all, the same to the last bit when repeated.",
         small_run, experiments_agree},
        {"goes_on_on_cpu",
         "Half of an experiment on this backend, then the other half on it and, from the same state, on the CPU: the same frame to "
         "the last bit, "
         "then each part of the water within 1 % of all.",
         {small_run.begin(), small_run.end() - 2},
         goes_on_on_cpu},
        {"mixed_yarns",
         "A wet spot on stripes of two yarns that pass nothing to each other: every yarn against a cloth of its own kind, exactly.",
         {},
         mixed_yarns},
        {"backends_agree", "The yarn network and a drop in the air on this backend against one thread of the CPU.", {}, backends_agree},
    };
}

} // namespace hygroloom
