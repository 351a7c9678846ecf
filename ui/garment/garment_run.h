// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A run of a worn garment on a thread of its own, and reading one; signals come in the thread of this object.
#pragma once

#include "core/wear/wear_run.h"
#include "ui/basics/mailbox.h"
#include "ui/garment/worn_run.h"

#include <QObject>

#include <atomic>
#include <thread>

namespace hygroloom {

class GarmentRun : public QObject {
    Q_OBJECT
public:
    enum class Outcome { finished, cancelled, memory_short, failed };

    struct Request {
        std::shared_ptr<const Design> design;
        std::string garment, experiment;
        std::filesystem::path base; ///< that the garment's source is relative to
        WearOptions options;
        std::string backend;
        int threads = 0;                 ///< 0: all
        std::filesystem::path recording; ///< empty: none is written
    };

    explicit GarmentRun(QObject* parent = nullptr);
    /// Cancels and waits, 0.2 s or so.
    ~GarmentRun() override;

    /// Precondition: not running(), and validate() found no error.
    void start(const Request& request);
    /// Reads a recording. Precondition: not running().
    void open(const std::filesystem::path& recording);
    bool running() const { return running_; }
    /// Whether it computes; else it reads a recording, which has no pause.
    bool computing() const { return running_ && computing_; }
    bool paused() const { return running_ && control_.pause; }
    void setPaused(bool paused);
    void cancel();

Q_SIGNALS:
    /// Before it begins: it takes much of the memory that is free.
    void memoryIsShort();
    /// The device failed, and the run goes on on the CPU; a sentence.
    void deviceFailed(const QString& sentence);
    /// The first frame follows.
    void started(const std::shared_ptr<WornRun>& run);
    /// metrics: of all frames up to this one. most: of any cell in it.
    void frameArrived(const std::shared_ptr<const WearFrame>& frame, const std::shared_ptr<const WearMetrics>& metrics,
                      const MostWater& most);
    void progressed(const RunProgress& progress);
    void pausedChanged(bool paused);
    /// sentence: what went wrong, empty otherwise.
    void ended(Outcome outcome, const QString& sentence);

private:
    void post(std::function<void()> work);
    void begin(const std::function<void()>& work);
    void compute(const Request& request);
    void read(const std::filesystem::path& recording);

    RunControl control_;
    bool running_ = false, computing_ = false;
    std::atomic<bool> was_paused_ = false;
    Mailbox mail_;
    std::jthread thread_;
};

/// Whether a file is the recording of a garment; false for whatever cannot be read.
bool isGarmentRecording(const QString& path);

} // namespace hygroloom
