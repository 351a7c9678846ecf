// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Passes on what a run comes to: frames to the recording and to the caller, one at a time, and what happened between them.
#pragma once

#include "core/run/course.h"
#include "core/run/part_watch.h"
#include "core/run/recording.h"
#include "core/run/run_options.h"

#include <chrono>
#include <optional>

namespace hygroloom {

class Publisher : public Audience {
public:
    /// The record gets the parts that come on, the devices and the wall time since start. recording: empty where none is written.
    Publisher(RunRecord& run, double duration, const Session& session, const RunCallbacks& callbacks,
              std::chrono::steady_clock::time_point start, std::filesystem::path recording);

    /// Opens the recording. Throws FileError.
    void starts() override;
    /// Records and shows it. Throws Error when water was lost, FileError, and what the caller's callback throws.
    void publish(Frame frame, double time, bool beside) override;
    /// Lets frames that nobody follows soon take effect; see RecordingWriter.
    void commit_when_due() override;
    /// Reports progress ten times a second at most, and at the end.
    void progress(double reached, bool ends) override;
    void device_failed(const std::string& sentence) override;
    void device_changed(const std::string& added) override;
    /// The run is over.
    void finish();

    /// Where the next frame may tell of a part of the physics that is to come on.
    bool takes_at_once() const override { return watch_.is_watching(); }
    bool has_due() const override { return !due_.empty(); }
    ModelPlan plan() const override { return plan_; }
    ModelPlan with_due() const override;
    /// Records and reports them. kept_off: why they stay off; empty: they are on.
    void settle_due(const char* kept_off) override;

private:
    RunRecord& run_;
    const double duration_; // s
    const Session& session_;
    const RunCallbacks& callbacks_;
    PartWatch watch_;
    ModelPlan plan_;                ///< with the parts that came on
    std::vector<SwitchedPart> due_; ///< that came over their limit and are neither on yet nor reported
    const std::filesystem::path path_;
    std::optional<RecordingWriter> recording_;
    std::mutex calling_; // held while the caller is called: a frame may be published while the run goes on
    const std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point reported_, looked_;
};

} // namespace hygroloom
