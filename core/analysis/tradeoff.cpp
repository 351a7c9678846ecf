// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/tradeoff.h"

#include "core/analysis/cell_map.h"
#include "core/analysis/closed_forms.h"
#include "core/analysis/outcomes.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "core/plan/expectation.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

namespace hygroloom {
namespace {

constexpr int moments = 4, cell_crossings = 2;

/// Two or four times as fine, where a knob goes that far. What is off in the reference (0) stays off.
KnobSettings refined(const Knobs& reference, double factor)
{
    KnobSettings settings;
    for (const KnobInfo& knob : knob_table()) {
        const double value = reference.*knob.value;
        if (!knob.words.empty()) settings[knob.name] = value;
        if (!knob.words.empty() || value == 0) continue;
        const double fine = knob.cheaper < knob.finer ? value * factor : value / factor;
        settings[knob.name] = std::clamp(knob.whole ? std::round(fine) : fine, knob.least, knob.most);
    }
    return settings;
}

double relative(double value, double reference, double scale)
{
    return value == reference ? 0.0 : scale > 0 ? std::abs(value - reference) / scale : 1.0;
}

void compare_metrics(const TradeoffOutcome& run, const TradeoffOutcome& reference, TradeoffErrors& errors)
{
    for (const auto& [name, wanted] : reference.metrics) {
        const auto found = run.metrics.find(name);
        MetricError m{name, found == run.metrics.end() ? std::nullopt : found->second, wanted, 0};
        if (m.value && m.reference) {
            m.error = relative(*m.value, *m.reference, error_scale(name, *m.reference, reference.air_temperature_c));
        } else if (m.value || m.reference) {
            m.error = 1;
        }
        errors.metrics.push_back(m);
    }
}

/// What contents are compared with: all water that was somewhere else than at the start, at most.
double water_at_stake(const TradeoffOutcome& reference)
{
    double most = 0;
    for (const TradeoffMoment& moment : reference.moments) {
        double moved = 0;
        for (const auto& [name, water] : moment.contents) moved += std::abs(water);
        most = std::max(most, moved);
    }
    return most;
}

void compare_contents(const TradeoffOutcome& run, const TradeoffOutcome& reference, TradeoffErrors& errors)
{
    const double scale = water_at_stake(reference);
    std::map<std::string, MetricError> worst;
    for (std::size_t k = 0; k < std::min(run.moments.size(), reference.moments.size()); ++k)
        for (const auto& [name, wanted] : reference.moments[k].contents) {
            const auto found = run.moments[k].contents.find(name);
            const double value = found == run.moments[k].contents.end() ? 0 : found->second;
            const double error = relative(value, wanted, scale);
            const auto [entry, is_new] = worst.try_emplace(name, MetricError{name, value, wanted, error});
            if (!is_new && error > entry->second.error) entry->second = {name, value, wanted, error};
        }
    for (const auto& [name, error] : worst) errors.metrics.push_back(error);
}

void compare_maps(const TradeoffOutcome& run, const TradeoffOutcome& reference, TradeoffErrors& errors)
{
    double difference = 0, size = 0;
    long both = 0, either = 0;
    for (std::size_t k = 0; k < std::min(run.moments.size(), reference.moments.size()); ++k) {
        const TradeoffMoment &a = run.moments[k], &b = reference.moments[k];
        for (std::size_t i = 0; i < std::min(a.map.size(), b.map.size()); ++i) {
            difference += (a.map[i] - b.map[i]) * (a.map[i] - b.map[i]);
            size += b.map[i] * b.map[i];
        }
        for (std::size_t i = 0; i < std::min(a.wet.size(), b.wet.size()); ++i) {
            both += a.wet[i] && b.wet[i];
            either += a.wet[i] || b.wet[i];
        }
    }
    if (size > 0) errors.map = std::sqrt(difference / size);
    if (either > 0) errors.overlap = static_cast<double>(both) / static_cast<double>(either);
}

TradeoffMoment moment_of(const Textile& textile, const Frame& frame, const Frame& start, double bound_at_start)
{
    const Ledger& l = frame.ledger;
    TradeoffMoment moment;
    moment.time = frame.time;
    moment.contents = {{"free_water_kg", l.water_free},
                       {"yarn_water_kg", l.water_liquid},
                       {"bound_water_kg", l.water_bound - bound_at_start},
                       {"evaporated_kg", l.water_evaporated},
                       {"dripped_kg", l.water_dripped}};
    moment.map = cell_map(textile, frame, start, MapSide::total, cell_crossings).water;
    for (float saturation : frame.saturation) moment.wet.push_back(saturation >= wet_saturation);
    return moment;
}

/// The numbers of a run but those in rings, which are the same numbers made coarse.
std::map<std::string, std::optional<double>> numbers_of(const RunRecord& run, const Metrics& metrics)
{
    std::map<std::string, std::optional<double>> numbers;
    for (const Outcome& outcome : outcomes_of(run, metrics))
        if (!outcome.in_rings && outcome.text.empty()) numbers[outcome.key] = outcome.value;
    return numbers;
}

} // namespace

double error_scale(const std::string& metric, double value, double air_temperature_c)
{
    if (metric == "surface_temperature_steady_c") return std::max(1.0, std::abs(value - air_temperature_c));
    if (metric == "one_way_transport_pct") return std::max(100.0, std::abs(value)); // a difference; its grades lie about 100 % apart
    if (metric == "stain_armness") return 1.0;                                      // a share of the stain's radius already
    return std::abs(value);
}

std::vector<TradeoffVariant> tradeoff_ladder()
{
    std::vector<TradeoffVariant> variants;
    variants.reserve(std::size(all_fidelities));
    for (Fidelity fidelity : all_fidelities) variants.push_back({name_of(fidelity), fidelity, {}, true});
    return variants;
}

std::vector<TradeoffVariant> tradeoff_variants(const std::vector<std::string>& names)
{
    std::vector<TradeoffVariant> variants = tradeoff_ladder();
    const auto add = [&](const KnobInfo& knob) {
        for (double value : {knob.cheaper, knob.finer})
            variants.push_back({fmt::format("{}={}", knob.name, knob.words.empty() ? fmt::format("{:g}", value) : text_of(knob, value)),
                                Fidelity::standard,
                                {{knob.name, value}},
                                true});
    };
    for (const std::string& name : names) add(knob_named(name));
    if (names.empty())
        for (const KnobInfo& knob : knob_table()) add(knob);
    return variants;
}

std::vector<TradeoffVariant> convergence_variants(const KnobSettings& settings)
{
    const Knobs reference = with_settings(knobs_of(Fidelity::reference), settings);
    return {{"reference x 2", Fidelity::reference, refined(reference, 2), false},
            {"reference x 4", Fidelity::reference, refined(reference, 4), false}};
}

bool run_alike(const ModelPlan& a, const ModelPlan& b)
{
    const auto parts_on = [](const ModelPlan& plan) { // older plans do not name all
        std::vector<std::string> names;
        for (const PlannedPart& part : plan.parts)
            if (part.on) names.push_back(part.name);
        return names;
    };
    if (parts_on(a) != parts_on(b)) return false;
    if (a.particles_per_droplet != b.particles_per_droplet || a.fibre_shells != b.fibre_shells ||
        a.crossings_per_cell != b.crossings_per_cell || a.rest_tolerance != b.rest_tolerance || a.knobs.step_error != b.knobs.step_error ||
        a.knobs.saturation_change != b.knobs.saturation_change || a.knobs.network_step_limit != b.knobs.network_step_limit)
        return false;
    if ((a.watches("sorption") || b.watches("sorption")) && a.knobs.fibre_shells != b.knobs.fibre_shells) return false; // it may come on
    const auto watches = [](const ModelPlan& plan) {
        return std::any_of(plan.parts.begin(), plan.parts.end(), [](const PlannedPart& part) { return part.watched; });
    };
    if ((watches(a) || watches(b)) && a.knobs.neglected_share != b.knobs.neglected_share) return false;
    return !a.on("liquid") ||
           (a.knobs.double_precision == b.knobs.double_precision && a.knobs.density_tolerance == b.knobs.density_tolerance &&
            a.knobs.settle_share == b.knobs.settle_share && a.knobs.liquid_step_factor == b.knobs.liquid_step_factor &&
            a.knobs.steps_between_absorption == b.knobs.steps_between_absorption);
}

void OutcomeCollector::start(const RunRecord& run)
{
    metrics_.start(run);
    run_ = run;
    start_.reset();
    moments_.clear();
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    duration_ = experiment ? experiment->duration_s : 0;
    air_temperature_c_ = experiment ? climate_at(*experiment, duration_).temperature_c : 0;
}

void OutcomeCollector::add(const Frame& frame)
{
    metrics_.add(frame);
    if (!start_) {
        start_ = start_of_maps(run_, frame);
        bound_at_start_ = frame.ledger.water_bound;
        return;
    }
    const double due = duration_ * static_cast<double>(moments_.size() + 1) / moments;
    if (moments_.size() < moments && frame.time >= due * (1 - 1e-9))
        moments_.push_back(moment_of(run_.textile, frame, *start_, bound_at_start_));
}

TradeoffOutcome OutcomeCollector::outcome(const RunRecord& run) const
{
    TradeoffOutcome outcome;
    const Metrics metrics = metrics_.metrics();
    outcome.metrics = numbers_of(run, metrics);
    if (!metrics.conditioning || metrics.conditioning->settled) outcome.closed_forms = closed_forms(run);
    outcome.moments = moments_;
    outcome.air_temperature_c = air_temperature_c_;
    outcome.wall = run.wall;
    outcome.backend = run.backend;
    outcome.device = run.device;
    outcome.plan = run.plan;
    outcome.switched_on = run.switched_on;
    return outcome;
}

TradeoffErrors tradeoff_errors(const TradeoffOutcome& run, const TradeoffOutcome& reference)
{
    TradeoffErrors errors;
    compare_metrics(run, reference, errors);
    compare_contents(run, reference, errors);
    compare_maps(run, reference, errors);
    for (const MetricError& m : errors.metrics) errors.largest = std::max(errors.largest, m.error);
    if (errors.overlap && wets_a_part(reference.plan.counts.type)) errors.largest = std::max(errors.largest, 1 - *errors.overlap);
    return errors;
}

std::vector<MetricError> closed_form_errors(const TradeoffOutcome& run)
{
    std::vector<MetricError> errors;
    for (const auto& [name, answer] : run.closed_forms) {
        const auto found = run.metrics.find(name);
        if (found == run.metrics.end() || !found->second) continue;
        const double scale = error_scale(name, answer, run.air_temperature_c);
        errors.push_back({name, found->second, answer, relative(*found->second, answer, scale)});
    }
    return errors;
}

Tradeoff tradeoff_here(const Fabric& fabric, const Experiment& experiment)
{
    Tradeoff t;
    t.program = std::string("Hygroloom ") + program_version();
    t.commit = program_commit();
    t.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
    utsname machine{};
    if (uname(&machine) == 0) t.machine = machine.nodename;
    if (double load = 0; getloadavg(&load, 1) == 1) t.load = load;
    t.fabric = fabric.name;
    t.experiment = experiment.name;
    t.type = name_of(experiment.type);
    t.duration = experiment.duration_s;
    return t;
}

double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double TradeoffPoint::wall() const { return median(walls); }
double TradeoffPoint::peak() const { return median(peaks); }

void mark_pareto(std::vector<TradeoffPoint>& points)
{
    const auto counts = [](const TradeoffPoint& p) { return p.errors && !p.walls.empty(); };
    for (TradeoffPoint& p : points)
        p.pareto = counts(p) && std::none_of(points.begin(), points.end(), [&](const TradeoffPoint& q) {
                       return counts(q) && q.wall() <= p.wall() && q.errors->largest <= p.errors->largest &&
                              (q.wall() < p.wall() || q.errors->largest < p.errors->largest);
                   });
}

} // namespace hygroloom
