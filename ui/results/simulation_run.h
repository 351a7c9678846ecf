// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The run of a sample that the window watches.
#pragma once

#include "ui/results/queued_run.h"

namespace hygroloom {

class SimulationRun : public QueuedRun {
    Q_OBJECT
public:
    explicit SimulationRun(WindowQueue& queue, QObject* parent = nullptr);
    ~SimulationRun() override { stopAndWait(); }

    /// Precondition: not running(), and validate() found no error.
    void start(const std::shared_ptr<const Design>& design, const std::string& fabric, const std::string& experiment,
               const RunOptions& options, const std::string& backend);

Q_SIGNALS:
    /// From start(): running() is true; what follows may take minutes before started().
    void begun();
    void started(const std::shared_ptr<const RunRecord>& run);
    /// metrics: of all frames up to this one.
    void frameArrived(const std::shared_ptr<const Frame>& frame, const std::shared_ptr<const Metrics>& metrics);
    /// The run to its end, with the time it took and all the devices it took; ended() follows. Not of one that was stopped.
    void completed(const std::shared_ptr<const RunRecord>& run);
};

} // namespace hygroloom
