// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/tradeoff.h"

#include "core/analysis/outcomes.h"
#include "core/base/moment.h"
#include "core/base/version.h"

#include <fmt/format.h>

#include <sys/utsname.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <set>

namespace hygroloom {
namespace {

constexpr std::size_t moments = 4;

double relative(double value, double reference, double scale)
{
    return value == reference ? 0.0 : scale > 0 ? std::abs(value - reference) / scale : 1.0;
}

/// Whether a metric's error counts for the largest one. When a stain comes to rest does not: the last segment that gets wet decides it. Nor
/// do what fell through holes and what lies between yarns in the end, of which there may be next to nothing: contents are shares of all.
bool counts(const std::string& metric)
{
    static const std::set<std::string> left_out{"time_of_arrest_s", "water_shed_below_g", "water_between_yarns_g"};
    return !left_out.contains(metric);
}

/// Whether an experiment of this type leaves a wetted area with an edge. Where all of the cloth is wet alike, segments dry or get wet all
/// at about the same time, and how many of them at a moment says nothing.
bool wets_a_part(const std::string& type)
{
    constexpr ExperimentType all_wet[] = {ExperimentType::drying, ExperimentType::conditioning, ExperimentType::sweat};
    return std::none_of(std::begin(all_wet), std::end(all_wet), [&](ExperimentType each) { return type == name_of(each); });
}

void compare_metrics(const TradeoffOutcome& run, const TradeoffOutcome& reference, TradeoffErrors& errors)
{
    for (const auto& [name, wanted] : reference.metrics) {
        const auto found = run.metrics.find(name);
        const std::optional<double> value = found == run.metrics.end() ? std::nullopt : found->second;
        double error = value || wanted ? 1.0 : 0.0;
        if (value && wanted)
            error = errors.metrics[name] = relative(*value, *wanted, error_scale(name, *wanted, reference.air_temperature_c));
        if (counts(name)) errors.largest = std::max(errors.largest, error);
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

void compare_moments(const TradeoffOutcome& run, const TradeoffOutcome& reference, TradeoffErrors& errors)
{
    const double scale = water_at_stake(reference);
    long both = 0, either = 0;
    for (std::size_t k = 0; k < std::min(run.moments.size(), reference.moments.size()); ++k) {
        const TradeoffMoment &a = run.moments[k], &b = reference.moments[k];
        for (const auto& [name, wanted] : b.contents) {
            const double error = relative(a.contents.at(name), wanted, scale);
            errors.metrics[name] = std::max(errors.metrics[name], error);
            errors.largest = std::max(errors.largest, error);
        }
        for (std::size_t i = 0; i < std::min(a.wet.size(), b.wet.size()); ++i) {
            both += a.wet[i] && b.wet[i];
            either += a.wet[i] || b.wet[i];
        }
    }
    if (either > 0 && wets_a_part(reference.type))
        errors.largest = std::max(errors.largest, 1.0 - static_cast<double>(both) / static_cast<double>(either));
}

TradeoffMoment moment_of(const Frame& frame, double bound_at_start)
{
    const Ledger& l = frame.ledger;
    TradeoffMoment moment;
    moment.contents = {{"free_water_kg", l.water_free},
                       {"yarn_water_kg", l.water_liquid},
                       {"bound_water_kg", l.water_bound - bound_at_start},
                       {"evaporated_kg", l.water_evaporated},
                       {"dripped_kg", l.water_dripped}};
    for (float saturation : frame.saturation) moment.wet.push_back(saturation >= wet_saturation);
    return moment;
}

} // namespace

double error_scale(const std::string& metric, double value, double air_temperature_c)
{
    if (metric == "surface_temperature_steady_c") return std::max(1.0, std::abs(value - air_temperature_c));
    if (metric == "one_way_transport_pct") return std::max(100.0, std::abs(value)); // a difference; its grades lie about 100 % apart
    if (metric == "stain_armness") return 1.0;                                      // a share of the stain's radius already
    return std::abs(value);
}

KnobSettings refined(const KnobSettings& settings, double factor)
{
    const Knobs reference = with_settings(knobs_of(Fidelity::reference), settings);
    KnobSettings finer;
    for (const KnobInfo& knob : knob_table()) {
        const double value = reference.*knob.value;
        if (!knob.words.empty()) finer[knob.name] = value;
        if (!knob.words.empty() || value == 0) continue; // what is off stays off
        const double fine = knob.cheaper < knob.finer ? value * factor : value / factor;
        finer[knob.name] = std::clamp(knob.whole ? std::round(fine) : fine, knob.least, knob.most);
    }
    return finer;
}

void OutcomeCollector::start(const RunRecord& run)
{
    outcome_ = {};
    bound_at_start_.reset();
    const Experiment* experiment = find_experiment(run.design, run.experiment);
    duration_ = experiment ? experiment->duration_s : 0;
    outcome_.air_temperature_c = experiment ? climate_at(*experiment, duration_).temperature_c : 0;
}

void OutcomeCollector::add(const Frame& frame)
{
    if (!bound_at_start_) {
        bound_at_start_ = frame.ledger.water_bound;
        return;
    }
    const double due = duration_ * static_cast<double>(outcome_.moments.size() + 1) / moments;
    if (outcome_.moments.size() < moments && frame.time >= due * (1 - 1e-9)) outcome_.moments.push_back(moment_of(frame, *bound_at_start_));
}

TradeoffOutcome OutcomeCollector::outcome(const RunRecord& run, const Metrics& metrics) const
{
    TradeoffOutcome outcome = outcome_;
    for (const Outcome& number : outcomes_of(run, metrics)) // but those in rings, which are the same numbers made coarse
        if (!number.in_rings && number.text.empty()) outcome.metrics[number.key] = number.value;
    outcome.type = run.plan.counts.type;
    outcome.wall = run.wall;
    outcome.backend = run.backend;
    outcome.device = run.device;
    return outcome;
}

TradeoffErrors tradeoff_errors(const TradeoffOutcome& run, const TradeoffOutcome& reference)
{
    TradeoffErrors errors;
    compare_metrics(run, reference, errors);
    compare_moments(run, reference, errors);
    return errors;
}

Tradeoff tradeoff_here(const std::string& fabric, const std::string& experiment)
{
    Tradeoff t;
    t.program = std::string("Hygroloom ") + program_version();
    t.commit = program_commit();
    t.date = date_now();
    utsname machine{};
    if (uname(&machine) == 0) t.machine = machine.nodename;
    if (double load = 0; getloadavg(&load, 1) == 1) t.load = load;
    t.fabric = fabric;
    t.experiment = experiment;
    return t;
}

void compare_runs(std::vector<TradeoffRun>& runs)
{
    const auto named = [&](const std::string& name) {
        const auto found = std::find_if(runs.begin(), runs.end(), [&](const TradeoffRun& run) { return run.name == name; });
        return found == runs.end() || !found->outcome ? nullptr : &*found->outcome;
    };
    for (TradeoffRun& run : runs) {
        const TradeoffOutcome* other = named(run.coarser.empty() ? name_of(Fidelity::reference) : run.coarser);
        if (!run.outcome || other == nullptr) continue;
        run.errors = run.coarser.empty() ? tradeoff_errors(*run.outcome, *other) : tradeoff_errors(*other, *run.outcome);
    }
}

double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

} // namespace hygroloom
