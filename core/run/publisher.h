// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Passes on what a run comes to: frames to the recording and to the caller, one at a time, and what happened between them.
#pragma once

#include "core/run/part_watch.h"
#include "core/run/recording.h"
#include "core/run/run_options.h"

#include <chrono>
#include <optional>

namespace hygroloom {

class Session;

class Publisher {
public:
    /// The record gets the parts that come on, the devices and the wall time since start.
    Publisher(RunRecord& run, double duration, const Session& session, const RunCallbacks& callbacks,
              std::chrono::steady_clock::time_point start);

    /// The run is about to take its first step: opens the recording, unless the path is empty. Throws FileError.
    void start(const std::filesystem::path& recording);
    /// Records and shows a frame of the session. From any thread, one call at a time. beside: while the run goes on, which so takes no
    /// longer. Throws Error when water was lost, FileError, and what the caller's callback throws.
    void publish(Frame frame, double time, bool beside);
    /// Lets frames that nobody follows soon take effect; see RecordingWriter.
    void commit_when_due();
    /// Reports progress ten times a second at most, and at the end.
    void progress(double reached, bool ends);
    /// The run is about to go on on the CPU, from a time (s).
    void device_failed(const std::string& why, double from) const;
    /// The run has gone on from there on the session's machine.
    void device_changed(double from);
    /// The run is over.
    void finish();

    /// Whether the next frame may tell of a part of the physics that is to come on.
    bool is_watching() const { return watch_.is_watching(); }
    /// Parts that came over their limit and are neither on yet nor reported.
    const std::vector<SwitchedPart>& due() const { return due_; }
    /// Records and reports them. kept_off: why they stay off; empty: they are on.
    void settle_due(const char* kept_off);

private:
    RunRecord& run_;
    const double duration_; // s
    const Session& session_;
    const RunCallbacks& callbacks_;
    PartWatch watch_;
    std::vector<SwitchedPart> due_;
    std::optional<RecordingWriter> recording_;
    std::mutex calling_; // held while the caller is called: a frame may be published while the run goes on
    const std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point reported_, looked_;
};

} // namespace hygroloom
