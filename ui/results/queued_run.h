// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One run that the window watches, in its queue; signals come in the thread of this object.
#pragma once

#include "ui/basics/mailbox.h"
#include "ui/results/window_queue.h"

namespace hygroloom {

/// Why a run came to no end, in a sentence of the window's language; empty where it did, or was stopped. else_do: what to do where the
/// memory does not suffice.
QString failureText(const RunResult& result, const QString& else_do);

class QueuedRun : public QObject {
    Q_OBJECT
public:
    enum class Outcome { finished, cancelled, device_failed, memory_short, failed };

    explicit QueuedRun(WindowQueue& queue, QObject* parent = nullptr);
    /// Stops it and waits, 0.2 s or so.
    ~QueuedRun() override;

    /// else_do: see failureText(). completed: in the thread of the run, which came to its end. Precondition: not running(), and validate()
    /// found no error.
    void start(RunJob job, const std::string& backend, const QString& else_do, std::function<void(RunResult&)> completed);
    /// What the callbacks of the job have for this object's thread, in order, before ended(). From any thread.
    void post(std::function<void()> work) { mail_.post(std::move(work)); }
    bool running() const { return id_ != 0; }
    bool paused() const { return paused_; }
    void setPaused(bool paused);
    void cancel();
    /// Whether the last run was not cancelled by cancel(): in the list of runs.
    bool stoppedInList(Outcome outcome) const { return outcome == Outcome::cancelled && !stops_here_; }

Q_SIGNALS:
    /// From start(); its first word may take minutes.
    void begun();
    /// The device failed, and the run goes on on the CPU; a sentence.
    void deviceFailed(const QString& sentence);
    /// Before it begins: it takes much of the memory that is free.
    void memoryIsShort();
    void progressed(const RunProgress& progress);
    void pausedChanged(bool paused);
    /// sentence: what went wrong, empty otherwise.
    void ended(Outcome outcome, const QString& sentence);

private:
    void end(const std::shared_ptr<RunResult>& result);
    void showPaused(bool paused);

    WindowQueue& queue_;
    QString else_do_;
    int id_ = 0; ///< in the queue; 0: none is on
    bool paused_ = false, stops_here_ = false;
    Mailbox mail_;
};

} // namespace hygroloom
