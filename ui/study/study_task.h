// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A study that runs in the background, in its folder, where each run is kept as soon as it has ended.
#pragma once

#include "core/study/study_run.h"
#include "ui/results/window_queue.h"

#include <QObject>
#include <QString>

#include <memory>
#include <thread>

namespace hygroloom {

class StudyTask : public QObject {
    Q_OBJECT
public:
    explicit StudyTask(WindowQueue& queue, QObject* parent = nullptr);
    /// Cancels and waits, 0.2 s or so.
    ~StudyTask() override;

    /// Runs what the folder lacks of the study, with retry also what failed there. Preconditions: none runs; validate() found no error.
    void start(const std::shared_ptr<const Design>& design, const Study& study, const QString& folder, bool retry_failed);
    bool running() const { return running_; }
    /// What has ended is kept.
    void cancel();

    const QString& folder() const { return folder_; }
    const StudyProgress& progress() const { return progress_; }
    /// Of the last that ended.
    const StudyOutcome& outcome() const { return outcome_; }
    /// Why it could not run, in a sentence; empty: it could.
    const QString& failure() const { return failure_; }
    /// "12 of 96 runs, 2 failed, about 3 min left", or "paused"
    QString progressText() const;
    /// In the list of runs.
    bool paused() const { return paused_; }

Q_SIGNALS:
    void progressed();
    /// As of a device that failed.
    void noted(const QString& sentence);
    void ended();

private:
    struct Result {
        StudyOutcome outcome;
        QString failure;
    };
    Result run(const Design& design, const Study& study, const QString& folder, bool retry_failed);
    void post(std::function<void()> work);

    QString folder_, failure_;
    StudyProgress progress_;
    StudyOutcome outcome_;
    bool running_ = false, paused_ = false;
    WindowQueue& queue_;
    std::atomic<bool> cancel_ = false;
    std::jthread thread_; // last: joined before the rest goes
};

} // namespace hygroloom
