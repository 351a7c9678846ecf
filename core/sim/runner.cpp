// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/sim/runner.h"

#include "core/base/error.h"
#include "core/sim/backend.h"
#include "core/sim/recording.h"
#include "core/sim/scene.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <thread>

namespace hygroloom {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Waits while paused; throws when cancelled.
void obey(const RunControl& control)
{
    while (control.pause && !control.cancel) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (control.cancel) throw Cancelled();
}

} // namespace

RunRecord run_experiment(const Design& design, const std::string& fabric_name, const std::string& experiment_name,
                         const RunOptions& options, Backend& backend, RunControl& control, const RunCallbacks& callbacks)
{
    const Fabric* fabric = find_fabric(design, fabric_name);
    const Experiment* experiment = find_experiment(design, experiment_name);
    if (!fabric) throw Error("There is no fabric named \"" + fabric_name + "\" in the project.");
    if (!experiment) throw Error("There is no experiment named \"" + experiment_name + "\" in the project.");

    const auto start = Clock::now();
    RunRecord run;
    run.design = design;
    run.fabric = fabric_name;
    run.experiment = experiment_name;
    run.plan = plan_model(design, *fabric, *experiment, options.fidelity, options.forced, options.knobs);
    run.plan.fidelity_reason = options.fidelity_reason;
    run.textile = textile_of_run(design, *fabric, *experiment, run.plan.region);
    run.seed = options.seed;
    run.threads = options.threads;
    run.backend = backend.name();
    backend.set_threads(options.threads);
    run.device = backend.device();
    backend.load(build_scene(design, run.textile, *experiment, run.plan, options.seed));

    std::optional<RecordingWriter> recording;
    if (!options.recording.empty()) recording.emplace(options.recording, run);
    if (callbacks.started) callbacks.started(run);

    const auto publish = [&](double time) {
        auto frame = std::make_shared<Frame>(backend.frame());
        frame->time = time;
        // Water may not appear or vanish; if it does, the result is worth nothing.
        const Ledger& l = frame->ledger;
        if (!(std::abs(l.water_imbalance()) <= 1e-9 * (l.water_delivered + l.water_initial + std::abs(l.water_evaporated))))
            throw Error("The water ledger does not close; this is a fault of the program. The recording ends before it.");
        if (recording) recording->append(*frame);
        if (callbacks.frame) callbacks.frame(frame);
    };

    publish(0);
    auto told = Clock::now();
    const auto frames = static_cast<long>(std::ceil(experiment->duration_s / run.plan.frame_interval - 1e-9));
    for (long k = 1; k <= frames; ++k) {
        const double until = k == frames ? experiment->duration_s : static_cast<double>(k) * run.plan.frame_interval;
        for (double reached = 0; reached < until;) {
            obey(control);
            reached = backend.advance(until);
            if (callbacks.progress && (seconds_since(told) > 0.1 || (k == frames && reached >= until))) {
                told = Clock::now();
                callbacks.progress({reached, experiment->duration_s, seconds_since(start), backend.liquid_steps(), backend.particles()});
            }
        }
        publish(until);
    }
    run.wall = seconds_since(start);
    if (recording) recording->finish(run.wall);
    return run;
}

} // namespace hygroloom
