// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The course of every run, whatever its subject: a session from its first frame to its last, on the device and, when that fails, on the
// CPU.
#pragma once

#include "core/run/run_options.h"
#include "core/run/session.h"

namespace hygroloom {

/// To whom a course shows what it comes to. Without parts of the physics that may come on by default.
class Audience {
public:
    virtual ~Audience() = default;

    /// The session is loaded; the first step comes next.
    virtual void starts() {}
    /// A frame of the session, at a time (s). From any thread, one call at a time. beside: while the next steps run.
    virtual void publish(Frame frame, double time, bool beside) = 0;
    /// Several times a second, and at the end. reached: s.
    virtual void progress(double reached, bool ends) = 0;
    /// While a run is paused.
    virtual void commit_when_due() {}
    /// Whether a frame is to be published before the next step.
    virtual bool takes_at_once() const = 0;
    /// The run is about to go on on the CPU: a sentence. Then it has: what is to be added to the device's name.
    virtual void device_failed(const std::string& sentence) = 0;
    virtual void device_changed(const std::string& added) = 0;

    /// Whether parts of the physics are to come on after the frame that was published last.
    virtual bool has_due() const { return false; }
    /// The plan as it is, and with those parts.
    virtual ModelPlan plan() const { return {}; }
    virtual ModelPlan with_due() const { return {}; }
    /// They are on; or why they stay off.
    virtual void settle_due(const char* /*kept_off*/) {}
};

/// From the first time (s) to the last, in the calling thread; frames that a GPU gives late are published from another one while the next
/// steps run. Throws Cancelled within 0.2 s when asked to stop, DeviceError where it may not go on on the CPU, and what the audience
/// throws.
void go_through(const std::vector<double>& times, Session& session, Audience& audience, const RunOptions& options,
                const RunControl& control);

} // namespace hygroloom
