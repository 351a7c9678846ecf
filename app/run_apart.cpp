// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "app/run_apart.h"

#include "app/cli.h"
#include "app/cli_interrupt.h"

#include "core/run/apart.h"
#include "gpu/backends.h"

namespace hygroloom {
namespace {

TradeoffOutcome run_here(const ApartRun& run, const TradeoffVariant& variant, const std::function<void(double)>& progress)
{
    RunControl control;
    const InterruptCancels cancels(control.cancel);
    RunOptions options = run.options;
    options.fidelity = variant.fidelity;
    options.knobs = variant.settings;
    options.shown_side = 1e-9; // m: each segment, so that maps of all variants have the same cells
    const std::unique_ptr<Backend> backend = make_backend(backend_for(run.backend, variant.settings));
    if (backend->name() == "cpu") backend->time_stages(); // on a GPU it would keep stages from running on without the host
    OutcomeCollector collector;
    RunCallbacks callbacks;
    callbacks.started = [&](const RunRecord& record) { collector.start(record); };
    callbacks.frame = [&](const std::shared_ptr<const Frame>& frame) { collector.add(*frame); };
    callbacks.progress = [&](const RunProgress& p) { progress(p.duration > 0 ? p.simulated / p.duration : 1.0); };
    const RunRecord record = run_experiment(run.design, run.fabric, run.experiment, options, *backend, control, callbacks);
    TradeoffOutcome outcome = collector.outcome(record);
    outcome.liquid_steps = backend->liquid_steps();
    outcome.stages = backend->stage_times();
    return outcome;
}

} // namespace

TradeoffOutcome run_apart(const ApartRun& run, const TradeoffVariant& variant, const std::atomic<bool>& cancel,
                          const std::function<void(double)>& progress)
try {
    const auto work = [&](const std::function<void(double)>& report) { return outcome_json(run_here(run, variant, report)); };
    const ApartResult result = run_apart(variant.name, work, cancel, progress);
    TradeoffOutcome outcome = outcome_from_json(result.text);
    outcome.peak_bytes = result.peak_bytes;
    return outcome;
} catch (const DeviceError& error) {
    throw Stop(exit_no_device, std::string(error.what()) + " Use --backend cpu.");
}

} // namespace hygroloom
