// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// One run on a thread of its own; its signals come in the thread of this object.
#pragma once

#include "core/analysis/metrics.h"
#include "core/run/runner.h"
#include "ui/basics/mailbox.h"

#include <QObject>

#include <atomic>
#include <thread>

namespace hygroloom {

class SimulationRun : public QObject {
    Q_OBJECT
public:
    enum class Outcome { finished, cancelled, device_failed, memory_short, failed };

    explicit SimulationRun(QObject* parent = nullptr);
    /// Cancels and waits, 0.2 s or so.
    ~SimulationRun() override;

    /// Precondition: not running(), and validate() found no error.
    void start(const std::shared_ptr<const Design>& design, const std::string& fabric, const std::string& experiment,
               const RunOptions& options, const std::string& backend);
    bool running() const { return running_; }
    bool paused() const { return running_ && control_->pause; }
    void setPaused(bool paused);
    void cancel();

Q_SIGNALS:
    /// From start(): running() is true; what follows may take minutes before started().
    void begun();
    /// Before it begins: it takes much of the memory that is free.
    void memoryIsShort();
    void started(const std::shared_ptr<const RunRecord>& run);
    /// metrics: of all frames up to this one.
    void frameArrived(const std::shared_ptr<const Frame>& frame, const std::shared_ptr<const Metrics>& metrics);
    /// The run to its end, with the time it took and all the devices it took; ended() follows. Not of one that was stopped.
    void completed(const std::shared_ptr<const RunRecord>& run);
    void progressed(const RunProgress& progress);
    void pausedChanged(bool paused);
    /// sentence: what went wrong, empty otherwise.
    void ended(Outcome outcome, const QString& sentence);

private:
    void post(std::function<void()> work);
    void end(Outcome outcome, const QString& sentence);

    std::unique_ptr<RunControl> control_;
    bool running_ = false;
    std::atomic<bool> was_paused_ = false;
    Mailbox mail_;
    std::jthread thread_;
};

} // namespace hygroloom
