// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/course.h"

#include "core/base/error.h"
#include "core/run/failover.h"

#include <fmt/format.h>

#include <system_error>
#include <thread>

namespace hygroloom {
namespace {

/// Waits while paused, in which recorded frames take effect; throws when cancelled.
void obey(const RunControl& control, Audience& audience)
{
    while (control.pause && !control.cancel) {
        audience.commit_when_due();
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
    Course(const std::vector<double>& times, Session& session, Audience& audience, const RunOptions& options, const RunControl& control)
        : session_(session), audience_(audience), control_(control), failover_(session, options), may_fail_over_(options.may_go_on_on_cpu),
          times_(times), frames_(static_cast<long>(times_.size()) - 1)
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
            if (done && audience_.has_due() && k == published_) done = switch_on(k);
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
            obey(control_, audience_);
            reached = session_.advance(until);
            audience_.progress(reached, k == frames_ && reached >= until);
        }
        if (publishing_.valid()) {
            wait_for_frame();
            obey(control_, audience_); // the caller may have cancelled at that frame
        }
    }
    /// Publishes the frame, where it is late while the next steps run.
    void show(long k)
    {
        taken_ = session_.take_frame();
        if (k > published_) {
            const auto publish = [this, k](bool beside) {
                audience_.publish(taken_.get(), time_of(k), beside);
                published_ = k;
            };
            // What is watched may change what comes next; after the last frame nothing does.
            if (is_ready(taken_) || audience_.takes_at_once() || k == frames_)
                publish(false);
            else
                start_beside(publish);
        }
        if (failover_.is_due(k)) {
            wait_for_frame();                            // or the run could go on from a frame that nobody has seen
            if (!audience_.has_due()) failover_.keep(k); // a part begins at this frame, not where steps ended before
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
            if (may_fail_over_) audience_.device_failed(fmt::format("{} The run goes on on the CPU, from {:.3g} s.", error.what(), from));
            failover_.go_on_on_cpu(error);
            audience_.device_changed(fmt::format("; from {:.3g} s on {}", from, session_.backend().device()));
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
            attempt([&] { failover_.go_on_with(audience_.with_due()); });
        } catch (const std::bad_alloc&) { // the run itself is well
            kept_off = "the memory did not suffice";
            if (holds) attempt([&] { failover_.go_on_with(audience_.plan()); });
        }
        audience_.settle_due(kept_off);
        return true;
    }

    Session& session_;
    Audience& audience_;
    const RunControl& control_;
    Failover failover_;
    const bool may_fail_over_;
    const std::vector<double>& times_; // s, of the frames
    const long frames_;                // the last one's number
    long published_ = -1;              // the last frame; may be read only while publishing_ is not under way
    std::future<Frame> taken_;         // from the backend, until it is published
    std::future<void> publishing_;     // the frame before; the last member, so that what ends the run waits for it
};

} // namespace

void go_through(const std::vector<double>& times, Session& session, Audience& audience, const RunOptions& options,
                const RunControl& control)
{
    Course course(times, session, audience, options, control);
    course.load();
    audience.starts();
    course.go();
}

} // namespace hygroloom
