// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/runner.h"

#include "core/base/error.h"
#include "core/plan/bundling.h"
#include "core/plan/frame_times.h"
#include "core/run/failover.h"
#include "core/run/plan_run.h"
#include "core/run/publisher.h"
#include "core/run/session.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cmath>
#include <system_error>
#include <thread>

namespace hygroloom {
namespace {

/// Waits while paused, in which recorded frames take effect; throws when cancelled.
void obey(const RunControl& control, Publisher& publisher)
{
    while (control.pause && !control.cancel) {
        publisher.commit_when_due();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (control.cancel) throw Cancelled();
}

template <typename T> bool is_ready(const std::future<T>& result)
{
    return result.valid() && result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// One run as it goes on, frame by frame. A device that fails at something is replaced by the CPU, where that is allowed, and the run goes
/// on from the last frame that was kept.
class Course {
public:
    Course(RunRecord& run, const Experiment& experiment, Session& session, Publisher& publisher, const RunOptions& options,
           const RunControl& control)
        : session_(session), publisher_(publisher), control_(control), failover_(session, options),
          may_fail_over_(options.may_go_on_on_cpu), plan_(run.plan), times_(frame_times(experiment, run.plan.frame_interval)),
          frames_(static_cast<long>(times_.size()) - 1)
    {
    }

    void load()
    {
        attempt([&] { session_.load(); });
    }
    /// From the first frame to the last.
    void go()
    {
        for (long k = 0; k <= frames_;) {
            bool done = attempt([&] {
                advance_to(k);
                show(k);
            });
            if (done && !publisher_.due().empty() && k == published_) done = switch_on(k);
            const long kept = failover_.kept_frame();
            k = done ? k + 1 : kept > 0 ? kept + 1 : 0;
        }
    }

private:
    double time_of(long k) const { return times_[static_cast<std::size_t>(k)]; }

    void advance_to(long k)
    {
        const double until = time_of(k);
        for (double reached = 0; reached < until;) {
            if (is_ready(publishing_)) wait_for_frame();
            obey(control_, publisher_);
            reached = session_.advance(until);
            publisher_.progress(reached, k == frames_ && reached >= until);
        }
        if (publishing_.valid()) {
            wait_for_frame();
            obey(control_, publisher_); // the caller may have cancelled at that frame
        }
    }
    /// Publishes the frame, where it is late while the next steps run.
    void show(long k)
    {
        taken_ = session_.take_frame();
        if (k > published_) {
            const auto publish = [this, k](bool beside) {
                publisher_.publish(taken_.get(), time_of(k), beside);
                published_ = k;
            };
            // What is watched may change what comes next; after the last frame nothing does.
            if (is_ready(taken_) || publisher_.is_watching() || k == frames_)
                publish(false);
            else
                start_beside(publish);
        }
        if (failover_.is_due(k)) {
            wait_for_frame();                                // or the run could go on from a frame that nobody has seen
            if (publisher_.due().empty()) failover_.keep(k); // a part begins at this frame, not where steps ended before
        }
    }
    void start_beside(const std::function<void(bool beside)>& publish)
    {
        try {
            publishing_ = std::async(std::launch::async, publish, true);
        } catch (const std::system_error&) { // the system has no thread left
            publish(false);
        }
    }
    void wait_for_frame()
    {
        if (publishing_.valid()) publishing_.get();
    }

    /// Whether the device did it; else the run has gone on on the CPU. Throws the device's error where it may not.
    bool attempt(const std::function<void()>& act)
    {
        try {
            act();
            return true;
        } catch (const DeviceError& error) {
            try {
                wait_for_frame();
            } catch (const DeviceError&) {
                // The same device; that frame comes again.
            }
            const double from = time_of(failover_.kept_frame());
            if (may_fail_over_) publisher_.device_failed(error.what(), from);
            failover_.go_on_on_cpu(error);
            publisher_.device_changed(from);
            return false;
        }
    }
    /// Goes on with the parts that are due. Where the device fails at this, it goes on on the CPU: from an earlier frame if the state could
    /// not be kept, which it returns false for, else from here.
    bool switch_on(long frame)
    {
        bool holds = false;
        const char* kept_off = "";
        try {
            if (!attempt([&] {
                    session_.stay();
                    failover_.hold(frame);
                }))
                return false;
            holds = true;
            ModelPlan with = plan_;
            for (const SwitchedPart& part : publisher_.due()) with = with_part(std::move(with), part.name);
            attempt([&] { failover_.go_on_with(with); });
            plan_ = std::move(with);
        } catch (const std::bad_alloc&) { // the run itself is well
            kept_off = "the memory did not suffice";
            if (holds) attempt([&] { failover_.go_on_with(plan_); });
        }
        publisher_.settle_due(kept_off);
        return true;
    }

    Session& session_;
    Publisher& publisher_;
    const RunControl& control_;
    Failover failover_;
    const bool may_fail_over_;
    ModelPlan plan_;                  // with the parts that came on
    const std::vector<double> times_; // s, of the frames
    const long frames_;               // the last one's number
    long published_ = -1;             // the last frame; may be read only while publishing_ is not under way
    std::future<Frame> taken_;        // from the backend, until it is published
    std::future<void> publishing_;    // the frame before; the last member, so that what ends the run waits for it
};

/// Of a run, as long as it lives: whether there was another of this process.
class Presence {
public:
    Presence() : others_(running_++ > 0)
    {
        if (others_) ++meetings_;
        meetings_before_ = meetings_;
    }
    ~Presence() { --running_; }
    Presence(const Presence&) = delete;
    Presence& operator=(const Presence&) = delete;
    bool alone() const { return !others_ && meetings_ == meetings_before_; }

private:
    inline static std::atomic<int> running_ = 0;
    inline static std::atomic<long> meetings_ = 0; ///< runs that began beside another
    bool others_;
    long meetings_before_;
};

} // namespace

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
    run.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
    run.backend = backend.name();
    backend.set_threads(options.threads);
    run.device = backend.device();

    Session session(backend, build_scene(design, textile, *experiment, run.plan, options.seed), run.plan.crossings_per_cell);
    Publisher publisher(run, experiment->duration_s, session, callbacks, start);
    Course course(run, *experiment, session, publisher, options, control);
    course.load();
    publisher.start(options.recording);
    course.go();
    publisher.finish();
    run.alone = presence.alone();
    return run;
}

} // namespace hygroloom
