// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/runner.h"

#include "core/base/error.h"
#include "core/base/moment.h"
#include "core/plan/bundling.h"
#include "core/plan/frame_times.h"
#include "core/run/course.h"
#include "core/run/plan_run.h"
#include "core/run/presence.h"
#include "core/run/publisher.h"

#include <fmt/format.h>

namespace hygroloom {
RunRecord run_experiment(const Design& design, const std::string& fabric_name, const std::string& experiment_name,
                         const RunOptions& options, Backend& backend, RunControl& control, const RunCallbacks& callbacks)
{
    const Fabric* fabric = find_fabric(design, fabric_name);
    const Experiment* experiment = find_experiment(design, experiment_name);
    if (!fabric) throw Error("There is no fabric named \"" + fabric_name + "\" in the project.");
    if (!experiment) throw Error("There is no experiment named \"" + experiment_name + "\" in the project.");

    const auto start = std::chrono::steady_clock::now();
    const Presence presence;
    RunRecord run;
    run.design = design;
    run.fabric = fabric_name;
    run.experiment = experiment_name;
    const Textile textile = options.textile ? *options.textile : textile_of_run(design, *fabric, *experiment);
    run.plan = plan_run(design, textile, *experiment, options.fidelity, options.forced, options.knobs, backend.name());
    const std::string shortage = ask_for_memory("This run", run.plan.expected_bytes, options.memory);
    if (!shortage.empty() && callbacks.memory_is_short) callbacks.memory_is_short(shortage);
    if (options.shown_side > 0) decide_shown_cells(run.plan, textile, experiment->type, options.shown_side);
    run.textile = run.plan.shown_ends > 0 ? in_cells(textile, run.plan.shown_ends, run.plan.shown_picks) : textile;
    run.plan.fidelity_reason = options.fidelity_reason;
    if (options.frame_interval > 0) run.plan.frame_interval = options.frame_interval;
    run.seed = options.seed;
    run.threads = options.threads;
    run.date = date_now();
    run.backend = backend.name();
    backend.set_threads(options.threads);
    run.device = backend.device();

    Session session(backend, build_scene(design, textile, *experiment, run.plan, options.seed), run.plan.bundling());
    Publisher publisher(run, experiment->duration_s, session, callbacks, start, options.recording);
    go_through(frame_times(*experiment, run.plan.frame_interval), session, publisher, options, control);
    publisher.finish();
    run.alone = presence.alone();
    return run;
}

} // namespace hygroloom
