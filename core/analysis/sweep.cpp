// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/sweep.h"

#include "core/base/error.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace hygroloom {

void TradeoffSweep::add(const TradeoffVariant& variant, ModelPlan plan)
{
    for (TradeoffPoint& other : result_.points)
        if (variant.timed && run_alike(other.plan, plan)) {
            other.stands_for.push_back(variant.name);
            return;
        }
    TradeoffPoint point;
    point.variant = variant;
    point.plan = std::move(plan);
    result_.points.push_back(std::move(point));
}

void TradeoffSweep::run(const std::function<TradeoffOutcome(std::size_t, int)>& run, const std::function<void()>& changed)
{
    outcomes_.resize(result_.points.size());
    for (int repeat = 0; repeat < result_.repeats; ++repeat)
        for (std::size_t i = 0; i < result_.points.size(); ++i) {
            if (repeat > 0 && !result_.points[i].variant.timed) continue;
            keep(i, run(i, repeat));
            changed();
        }
    result_.complete = true;
    changed();
}

void TradeoffSweep::keep(std::size_t i, TradeoffOutcome outcome)
{
    TradeoffPoint& point = result_.points[i];
    if (point.variant.timed) {
        point.walls.push_back(outcome.wall);
        point.peaks.push_back(outcome.peak_bytes);
    }
    point.closed_forms = closed_form_errors(outcome);
    point.liquid_steps = outcome.liquid_steps;
    point.switched_on = outcome.switched_on;
    point.stages.clear();
    for (const StageTime& stage : outcome.stages) point.stages[stage.name] = 100 * stage.seconds / outcome.wall;
    if (result_.backend.empty()) { // particles in double precision may run on a CPU
        result_.backend = outcome.backend;
        result_.device = outcome.device;
    }
    outcomes_[i] = std::move(outcome);
    compare();
}

const TradeoffOutcome* TradeoffSweep::outcome_named(const std::string& name) const
{
    for (std::size_t i = 0; i < result_.points.size(); ++i) {
        const TradeoffPoint& point = result_.points[i];
        const bool stands_for = std::find(point.stands_for.begin(), point.stands_for.end(), name) != point.stands_for.end();
        if ((point.variant.name == name || stands_for) && outcomes_[i]) return &*outcomes_[i];
    }
    return nullptr;
}

void TradeoffSweep::compare()
{
    const TradeoffOutcome* reference = outcome_named("reference");
    for (std::size_t i = 0; reference && i < outcomes_.size(); ++i)
        if (outcomes_[i]) result_.points[i].errors = tradeoff_errors(*outcomes_[i], *reference);
    mark_pareto(result_.points);
    result_.convergence.clear();
    const std::pair<const char*, const char*> steps[] = {{"reference", "reference x 2"}, {"reference x 2", "reference x 4"}};
    for (const auto& [coarse, fine] : steps) {
        const TradeoffOutcome *a = outcome_named(coarse), *b = outcome_named(fine);
        if (a && b) result_.convergence.push_back({coarse, fine, tradeoff_errors(*a, *b)});
    }
}

void run_comparison(Comparison& comparison, const std::vector<std::string>& fabrics, const std::vector<std::unique_ptr<Backend>>& backends,
                    RunControl& control, const std::function<CandidateRun(std::size_t, Backend&)>& run,
                    const std::function<void(std::size_t)>& ended)
{
    std::mutex mutex;
    std::vector<std::optional<Candidate>> candidates(fabrics.size());
    const std::size_t all = fabrics.size() * static_cast<std::size_t>(comparison.replicates);
    std::size_t done = 0;
    const auto run_one = [&](std::size_t i, Backend& backend) {
        try {
            return run(i, backend);
        } catch (const Cancelled&) {
            throw;
        } catch (const std::exception& error) {
            CandidateRun failed;
            failed.candidate.fabric = fabrics[i % fabrics.size()];
            failed.candidate.failure = error.what();
            return failed;
        }
    };
    run_side_by_side(backends, all, control, [&](std::size_t i, Backend& backend) {
        CandidateRun finished = run_one(i, backend);
        const std::lock_guard lock(mutex);
        auto& candidate = candidates[i % fabrics.size()];
        if (!candidate) candidate.emplace();
        add_replicate(*candidate, finished.candidate, static_cast<int>(i / fabrics.size()));
        comparison.candidates.clear();
        for (const auto& known : candidates)
            if (known) comparison.candidates.push_back(*known);
        comparison.complete = ++done == all;
        judge(comparison);
        ended(i);
        return finished.device_failed;
    });
}

FinishedRun run_and_measure(const Design& design, const std::string& fabric, const std::string& experiment, const RunOptions& options,
                            Backend& backend, RunControl& control, const RunCallbacks& beside)
{
    MetricsCollector collector;
    FinishedRun finished;
    RunCallbacks callbacks = beside;
    callbacks.started = [&](const RunRecord& record) {
        collector.start(record);
        if (beside.started) beside.started(record);
    };
    callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) {
        collector.add(*frame);
        if (beside.frame) beside.frame(frame);
    };
    callbacks.switched_on = [&](const SwitchedPart& part) {
        collector.add(part);
        if (beside.switched_on) beside.switched_on(part);
    };
    callbacks.device_failed = [&](const std::string& sentence) {
        finished.device_failure = sentence;
        if (beside.device_failed) beside.device_failed(sentence);
    };
    finished.run = run_experiment(design, fabric, experiment, options, backend, control, callbacks);
    finished.metrics = collector.metrics();
    return finished;
}

} // namespace hygroloom
