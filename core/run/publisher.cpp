// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/run/publisher.h"

#include "core/base/error.h"
#include "core/run/clock.h"
#include "core/run/session.h"
#include "core/scene/ledger_closes.h"

namespace hygroloom {
namespace {

/// Whether frames are spread from bundles over their yarns, and recorded as bundles.
bool in_bundles(const ModelPlan& plan) { return plan.crossings_per_cell > 1 && plan.shown_ends == 0; }

} // namespace

Publisher::Publisher(RunRecord& run, double duration, const Session& session, const RunCallbacks& callbacks, Clock::time_point start,
                     std::filesystem::path recording)
    : run_(run), duration_(duration), session_(session), callbacks_(callbacks), watch_(session.scene(), run.plan), plan_(run.plan),
      path_(std::move(recording)), start_(start)
{
}

void Publisher::starts()
{
    if (!path_.empty()) recording_.emplace(path_, run_, in_bundles(run_.plan));
    if (callbacks_.started) callbacks_.started(run_);
}

void Publisher::publish(Frame frame, double time, bool beside)
{
    frame.time = time;
    if (!ledger_closes(frame.ledger, session_.scene())) // then the result is worth nothing
        throw Error("The water ledger does not close; this is a fault of the program. The recording ends before it.");
    for (SwitchedPart& part : watch_.see(frame)) due_.push_back(std::move(part));
    frame.round_fields();
    std::optional<Frame> recorded;
    if (recording_ && in_bundles(run_.plan)) recorded = frame;
    frame = session_.of_single_yarns(std::move(frame));
    if (recorded) {
        recorded->water_top = frame.water_top;
        recorded->water_bottom = frame.water_bottom;
    }
    if (recording_) {
        const auto begin = Clock::now();
        recording_->append(recorded ? *recorded : frame);
        if (!beside) run_.recorded_in += seconds_since(begin);
    }
    if (time >= duration_) settle_due("the run was over");
    if (!callbacks_.frame) return;
    const std::scoped_lock alone(calling_);
    callbacks_.frame(std::make_shared<const Frame>(std::move(frame)));
}

void Publisher::commit_when_due()
{
    if (!recording_ || seconds_since(looked_) <= 0.05) return;
    looked_ = Clock::now();
    recording_->commit_when_due();
}

void Publisher::progress(double reached, bool ends)
{
    commit_when_due();
    if (!callbacks_.progress || (seconds_since(reported_) <= 0.1 && !ends)) return;
    std::unique_lock alone(calling_, std::try_to_lock);
    if (!alone && !ends) return; // the caller looks at a frame; the steps need not wait
    if (!alone) alone.lock();
    reported_ = Clock::now();
    const Backend& on = session_.backend();
    callbacks_.progress({reached, duration_, seconds_since(start_), on.liquid_steps(), on.particles()});
}

void Publisher::device_failed(const std::string& sentence)
{
    if (callbacks_.device_failed) callbacks_.device_failed(sentence);
}

void Publisher::device_changed(const std::string& added)
{
    run_.device += added;
    if (recording_) recording_->note_device(run_.device);
}

void Publisher::finish()
{
    run_.wall = seconds_since(start_);
    if (recording_) recording_->finish(run_.wall);
}

ModelPlan Publisher::with_due() const
{
    ModelPlan with = plan_;
    for (const SwitchedPart& part : due_) with = with_part(std::move(with), part.name);
    return with;
}

void Publisher::settle_due(const char* kept_off)
{
    if (*kept_off == 0) plan_ = with_due();
    for (SwitchedPart& part : due_) {
        part.kept_off = kept_off;
        if (recording_) recording_->note_switched_on(part);
        if (callbacks_.switched_on) callbacks_.switched_on(part);
        run_.switched_on.push_back(std::move(part));
    }
    due_.clear();
}

} // namespace hygroloom
