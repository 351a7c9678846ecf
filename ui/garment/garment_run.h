// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The run of a worn garment that the window watches, and the reading of one on a thread of its own.
#pragma once

#include "ui/garment/worn_run.h"
#include "ui/results/queued_run.h"

#include <thread>

namespace hygroloom {

class GarmentRun : public QueuedRun {
    Q_OBJECT
public:
    explicit GarmentRun(WindowQueue& queue, QObject* parent = nullptr);
    ~GarmentRun() override;

    /// base: that the garment's source is relative to. Precondition: not running(), and validate() found no error.
    void start(const std::shared_ptr<const Design>& design, const std::string& experiment, const std::filesystem::path& base,
               const RunOptions& options, const std::string& backend);
    /// Reads a recording. Precondition: not running().
    void open(const std::filesystem::path& recording);
    bool running() const { return computing() || reading_; }
    /// Whether it computes; else it reads a recording, which has no pause.
    bool computing() const { return QueuedRun::running(); }
    void cancel();

Q_SIGNALS:
    /// The device failed, and the run goes on on the CPU; a sentence.
    void deviceFailed(const QString& sentence);
    /// The first frame follows.
    void started(const std::shared_ptr<WornRun>& run);
    /// metrics: of all frames up to this one. most: of any cell in it.
    void frameArrived(const std::shared_ptr<const WearFrame>& frame, const std::shared_ptr<const WearMetrics>& metrics,
                      const MostWater& most);

private:
    void show(const std::shared_ptr<const WearRecord>& record, const std::shared_ptr<const WearFrame>& frame, const WearMetrics& metrics);
    void read(const std::filesystem::path& recording);

    bool reading_ = false;
    std::atomic<bool> stop_reading_ = false;
    std::jthread reader_;
};

/// Whether a file is the recording of a garment; false for whatever cannot be read.
bool isGarmentRecording(const QString& path);

} // namespace hygroloom
