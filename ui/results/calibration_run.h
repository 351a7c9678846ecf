// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A calibration on a thread of its own; its signals come in the thread of this object.
#pragma once

#include "core/queue/calibration_runs.h"
#include "ui/results/window_queue.h"

#include <QObject>

#include <thread>

namespace hygroloom {

class CalibrationRun : public QObject {
    Q_OBJECT
public:
    /// What is fitted to what.
    struct Task {
        std::shared_ptr<const Design> design;
        std::string fabric, experiment;
        MeasuredData data;
        std::vector<FreeInput> inputs;
        RunOptions how;
        std::string backend;
    };

    explicit CalibrationRun(WindowQueue& queue, QObject* parent = nullptr) : QObject(parent), queue_(queue) {}
    /// Cancels and waits, 0.2 s or so.
    ~CalibrationRun() override;

    /// Precondition: not running(), and validate() found no error.
    void start(Task task);
    bool running() const { return running_; }
    void cancel() { cancel_ = true; }

Q_SIGNALS:
    /// Runs that have ended, and the share of those that go on side by side.
    void progressed(int done, double share);
    /// result: none when it was cancelled, or failed as the sentence says.
    void ended(const std::shared_ptr<const Calibration>& result, const QString& sentence);

private:
    /// In the thread. Throws Cancelled and Error.
    std::shared_ptr<const Calibration> fitted(const Task& task);
    void post(std::function<void()> work);

    WindowQueue& queue_;
    std::atomic<bool> cancel_ = false;
    bool running_ = false;
    std::jthread thread_;
};

} // namespace hygroloom
