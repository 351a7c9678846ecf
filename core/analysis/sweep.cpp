// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/analysis/sweep.h"

#include "core/base/error.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace hygroloom {

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
