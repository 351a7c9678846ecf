// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The run on screen, live or from a recording: its frames, its numbers, and the time that is shown.
#pragma once

#include "core/analysis/metrics.h"
#include "ui/basics/newest_job.h"
#include "ui/results/shown_run.h"

#include <atomic>
#include <map>

namespace hygroloom {

class Recording;

/// Keeps frames in memory up to a limit; the rest is read from the recording in the background when it is needed.
class Playback : public ShownRun {
    Q_OBJECT
public:
    explicit Playback(QObject* parent = nullptr);

    /// A run that has just begun and writes to path.
    void begin(const std::shared_ptr<const RunRecord>& run, const QString& path);
    void append(const std::shared_ptr<const Frame>& frame, const std::shared_ptr<const Metrics>& metrics);
    /// The live run got to its end; what is known of it only then.
    void complete(const std::shared_ptr<const RunRecord>& run);
    void end() override;
    void open(const QString& path) override;
    void stopOpening() override;
    void discard() override;
    void move(const QString& from, const QString& to) override;

    const std::shared_ptr<const RunRecord>& run() const { return run_; }
    /// Another with each run that is shown; run() alone changes also when a live one is complete.
    long generation() const { return generation_; }
    bool live() const override { return live_; }
    /// Whether metrics() are of all frames there will be.
    bool whole() const { return whole_; }
    QString path() const override { return path_; }
    const Design* design() const override { return run_ ? &run_->design : nullptr; }
    std::pair<std::string, std::string> names() const override { return {run_->fabric, run_->experiment}; }
    int frames() const override { return static_cast<int>(times_.size()); }
    double timeOf(int index) const override { return times_[static_cast<std::size_t>(index)]; }
    double duration() const override;
    int expectedFrames() const override;
    /// When the last free liquid was absorbed, where the type of experiment reports it.
    std::optional<QString> happened() const override;
    /// Where the water is, and what the type of experiment measures.
    std::vector<TimePlot> plots() const override;
    /// What is shown; nullptr until it has been read.
    const std::shared_ptr<const Frame>& frame() const { return frame_; }
    const std::shared_ptr<const Frame>& firstFrame() const { return first_; }
    const std::shared_ptr<const Metrics>& metrics() const { return metrics_; }
    double maximumSaturation() const { return maximum_saturation_; }

Q_SIGNALS:
    /// The live run's recording can be read.
    void ended();

protected:
    void bring() override;

private:
    void reset();
    void remember(int place, const std::shared_ptr<const Frame>& frame);
    void present(int index, const std::shared_ptr<const Frame>& frame);
    void read(int index);
    void scan(const QString& path);
    /// False where it is left out already.
    bool leaveOut(int place);

    std::shared_ptr<const RunRecord> run_;
    QString path_;
    bool live_ = false;
    bool whole_ = false;
    std::vector<double> times_;
    std::vector<int> places_;                          ///< of the frames in the recording; those that cannot be read are left out
    std::map<int, std::shared_ptr<const Frame>> kept_; ///< by place
    std::size_t kept_bytes_ = 0;
    std::shared_ptr<const Frame> first_;
    std::shared_ptr<const Frame> frame_;
    std::shared_ptr<const Metrics> metrics_;
    double maximum_saturation_ = 0;
    std::atomic<long> opening_{0};         ///< of the newest request, so that nothing is opened that nobody wants any more
    long generation_ = 0;                  ///< of the run, so that late deliveries of another are dropped
    std::shared_ptr<Recording> recording_; ///< used by the reader's thread only
    NewestJob reader_;
    NewestJob scanner_;
};

} // namespace hygroloom
