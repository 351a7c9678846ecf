// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/runner.h"

#include "core/base/error.h"
#include "core/plan/expectation.h"
#include "core/run/part_watch.h"
#include "core/run/recording.h"
#include "core/scene/coarse_scene.h"
#include "core/scene/scene.h"
#include "core/solver/backend.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <mutex>
#include <optional>
#include <system_error>
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

template <typename T> bool is_ready(const std::future<T>& result)
{
    return result.valid() && result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// A backend with its scene, and the CPU that takes over when it fails, if that is wanted.
class SafeMachine {
public:
    SafeMachine(Backend& backend, Scene scene, const RunOptions& options) : backend_(&backend), scene_(std::move(scene)), options_(options)
    {
    }

    Backend& backend() const { return *backend_; }
    const Scene& scene() const { return scene_; }
    void load() { backend_->load(scene_); }
    /// The frame that a failed device's run goes on from; 0: the start.
    long kept_frame() const { return frame_; }
    /// Whether what has been come to at that frame is to be kept: now and then, where the CPU may have to take over.
    bool is_to_keep(long frame) const { return may_fail_over() && frame > 0 && seconds_since(kept_) >= pause_; }
    void keep(long frame)
    {
        const auto start = Clock::now();
        try {
            state_ = backend_->state();
            frame_ = frame;
        } catch (const std::bad_alloc&) {
            // No reason to end a run that is well; it would go on from an earlier frame.
        }
        pause_ = std::max(least_pause, 20 * seconds_since(start));
        kept_ = Clock::now();
    }
    /// Keeps it for sure.
    void hold(long frame)
    {
        state_ = backend_->state();
        frame_ = frame;
    }
    /// Goes on from what was held with the plan's parts.
    void go_on_with(const ModelPlan& plan)
    {
        set_parts(scene_, plan);
        load();
        backend_->go_on_from(state_);
        if (!may_fail_over()) state_ = {};
    }
    /// Throws the error again if it may not.
    void go_on_on_cpu(const DeviceError& error)
    {
        if (!options_.may_go_on_on_cpu || cpu_) throw DeviceError(error);
        backend_->unload();
        if (options_.one_on_cpu) turn_ = std::unique_lock(*options_.one_on_cpu);
        cpu_ = make_cpu_backend();
        backend_ = cpu_.get();
        cpu_->set_threads(options_.threads);
        load();
        if (frame_ > 0) cpu_->go_on_from(state_);
    }

private:
    static constexpr double least_pause = 2; // s of wall time, for copying everything takes some

    bool may_fail_over() const { return options_.may_go_on_on_cpu && !cpu_ && backend_->name() != "cpu"; }

    Backend* backend_;
    Scene scene_;
    const RunOptions& options_;
    std::unique_ptr<Backend> cpu_;
    std::vector<std::byte> state_;
    long frame_ = 0;
    double pause_ = least_pause;
    std::unique_lock<std::mutex> turn_;
    Clock::time_point kept_ = Clock::now();
};

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
    if (backend.name() != "cpu") expect(run.plan, shipped_measurements(backend.name()));
    run.textile = textile_of_run(design, *fabric, *experiment, run.plan.region);
    run.seed = options.seed;
    run.threads = options.threads;
    run.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
    run.backend = backend.name();
    backend.set_threads(options.threads);
    run.device = backend.device();
    Scene scene = build_scene(design, run.textile, *experiment, run.plan, options.seed);
    std::optional<Scene> single; // with single yarns, as frames are shown, where they are simulated in bundles
    if (run.plan.crossings_per_cell > 1) {
        single = std::move(scene);
        scene = coarsened(*single, run.plan.crossings_per_cell);
    }
    SafeMachine machine(backend, std::move(scene), options);
    ModelPlan now = run.plan; // with the parts that are switched on while it runs
    PartWatch watch(machine.scene(), run.plan);
    std::vector<SwitchedPart> due;

    std::optional<RecordingWriter> recording;
    /// kept_off: why the parts that are due stay off; empty: they are on.
    const auto tell_due = [&](const char* kept_off) {
        for (SwitchedPart& part : due) {
            part.kept_off = kept_off;
            if (recording) recording->note_switched_on(part);
            if (callbacks.switched_on) callbacks.switched_on(part);
            run.switched_on.push_back(std::move(part));
        }
        due.clear();
    };
    std::mutex telling; // held by who calls back: a frame may be published while the run goes on
    const auto publish = [&](Frame frame, double time) {
        frame.time = time;
        // Water may not appear or vanish; if it does, the result is worth nothing.
        const Ledger& l = frame.ledger;
        if (!(std::abs(l.water_imbalance()) <= 1e-9 * (l.water_delivered + l.water_initial + std::abs(l.water_evaporated))))
            throw Error("The water ledger does not close; this is a fault of the program. The recording ends before it.");
        for (SwitchedPart& part : watch.see(frame)) due.push_back(std::move(part));
        if (single) frame = refined(std::move(frame), machine.scene(), *single);
        if (recording) recording->append(frame);
        if (time >= experiment->duration_s) tell_due("the run was over");
        if (!callbacks.frame) return;
        const std::scoped_lock alone(telling);
        callbacks.frame(std::make_shared<const Frame>(std::move(frame)));
    };
    Clock::time_point told;
    const auto tell = [&](double reached, bool ends, const Backend& on) {
        if (!callbacks.progress || (seconds_since(told) <= 0.1 && !ends)) return;
        std::unique_lock alone(telling, std::try_to_lock);
        if (!alone && !ends) return; // a frame is being looked at; the steps need not wait
        if (!alone) alone.lock();
        told = Clock::now();
        callbacks.progress({reached, experiment->duration_s, seconds_since(start), on.liquid_steps(), on.particles()});
    };

    const auto frames = static_cast<long>(std::ceil(experiment->duration_s / run.plan.frame_interval - 1e-9));
    const auto time_of = [&](long k) { return k == frames ? experiment->duration_s : static_cast<double>(k) * run.plan.frame_interval; };
    const auto go_on = [&](const DeviceError& error) {
        const double from = time_of(machine.kept_frame());
        if (options.may_go_on_on_cpu && callbacks.device_failed)
            callbacks.device_failed(fmt::format("{} The run goes on on the CPU, from {:.3g} s.", error.what(), from));
        machine.go_on_on_cpu(error);
        run.device += fmt::format("; from {:.3g} s on {}", from, machine.backend().device());
        if (recording) recording->note_device(run.device);
    };
    long published = -1;          // the last frame; not to be asked while another is on its way
    std::future<Frame> taken;     // from the backend, until it is published
    std::future<void> publishing; // the frame before, while the run goes on; what ends the run waits for it
    const auto wait_for_frame = [&] {
        if (publishing.valid()) publishing.get();
    };
    const auto go_on_beside = [&](const auto& show) {
        try {
            publishing = std::async(std::launch::async, show);
        } catch (const std::system_error&) { // the system has no thread left
            show();
        }
    };
    const auto try_to = [&](const auto& act) {
        try {
            act();
            return true;
        } catch (const DeviceError& error) {
            try {
                wait_for_frame();
            } catch (const DeviceError&) {
                // The same device; that frame comes again.
            }
            go_on(error);
            return false;
        }
    };
    // Where the device fails at this, it goes on on the CPU: from an earlier frame if nothing could be held, else from here.
    const auto switch_on = [&](long frame) {
        bool holds = false;
        const char* kept_off = "";
        try {
            if (!try_to([&] { machine.hold(frame); })) return false;
            holds = true;
            ModelPlan with = now;
            for (const SwitchedPart& part : due) with = with_part(std::move(with), part.name);
            try_to([&] { machine.go_on_with(with); });
            now = std::move(with);
        } catch (const std::bad_alloc&) { // no reason to end a run that is well
            kept_off = "the memory did not suffice";
            if (holds) try_to([&] { machine.go_on_with(now); });
        }
        tell_due(kept_off);
        return true;
    };

    try_to([&] { machine.load(); });
    if (!options.recording.empty()) recording.emplace(options.recording, run);
    if (callbacks.started) callbacks.started(run);
    for (long k = 0; k <= frames;) {
        const double until = time_of(k);
        bool done = try_to([&] {
            Backend& on = machine.backend();
            for (double reached = 0; reached < until;) {
                if (is_ready(publishing)) wait_for_frame();
                obey(control);
                reached = on.advance(until);
                tell(reached, k == frames && reached >= until, on);
            }
            if (publishing.valid()) {
                wait_for_frame();
                obey(control); // who saw that frame may not want another
            }
            taken = on.take_frame();
            if (k > published) {
                const auto show = [&, k, until] {
                    publish(taken.get(), until);
                    published = k;
                };
                // What is watched may change what comes next; after the last frame nothing does.
                if (is_ready(taken) || watch.is_watching() || k == frames)
                    show();
                else
                    go_on_beside(show);
            }
            if (machine.is_to_keep(k)) {
                wait_for_frame(); // or the run could go on from a frame that nobody has seen
                machine.keep(k);
            }
        });
        if (done && !due.empty() && k == published) done = switch_on(k);
        k = done ? k + 1 : machine.kept_frame() + (machine.kept_frame() > 0 ? 1 : 0);
    }
    run.wall = seconds_since(start);
    if (recording) recording->finish(run.wall);
    return run;
}

} // namespace hygroloom
