// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The runs of garments that are shown: the newest, and one kept as A beside it; the time shown; the scale of the colours.
#pragma once

#include "ui/basics/mailbox.h"
#include "ui/basics/newest_job.h"
#include "ui/garment/worn_run.h"
#include "ui/results/shown_run.h"

#include <atomic>

namespace hygroloom {

/// Where the scale of a run may end that holds most (g/m2, or a share) after a share of its time: as much as would be there at the end if
/// water went on coming as fast, up to the capacity; a round number that is not below most.
double scaleEndOfRun(double most, double share_of_time, double capacity);

class WearPlayback : public ShownRun {
    Q_OBJECT
public:
    explicit WearPlayback(QObject* parent = nullptr);

    /// nullptr: nothing has run. B while another is kept.
    const std::shared_ptr<WornRun>& run() const { return run_; }
    /// A; nullptr: none is kept.
    const std::shared_ptr<WornRun>& kept() const { return kept_; }
    /// One whose frames follow.
    void begin(const std::shared_ptr<WornRun>& run);
    /// metrics: of all frames up to this one. most: of any cell in it.
    void append(const std::shared_ptr<const WearFrame>& frame, const std::shared_ptr<const WearMetrics>& metrics, const MostWater& most);
    void open(const QString& path) override;
    void stopOpening() override;
    void end() override;
    void clear() override;
    /// What is kept as A stays.
    void discard() override;
    void keepAsA();
    void dropA();
    void move(const QString& from, const QString& to) override;

    int frames() const override { return run_ ? static_cast<int>(run_->frames.size()) : 0; }
    double timeOf(int index) const override { return run_->frames[static_cast<std::size_t>(index)]->time; }
    double duration() const override { return run_ ? run_->duration : 0; }
    int expectedFrames() const override;
    bool live() const override { return run_ && run_->live; }
    /// Whether all frames are there that there will be.
    bool whole() const { return whole_; }
    QString path() const override { return run_ ? run_->file : QString(); }
    const Design* design() const override { return run_ ? &run_->record->design : nullptr; }
    std::pair<std::string, std::string> names() const override { return {run_->layout().garment, run_->layout().experiment}; }
    /// Of the pinned cell, else of the garment; of A too.
    std::vector<TimePlot> plots() const override;
    /// nullptr: there is none. Of A at the time shown.
    std::shared_ptr<const WearFrame> frame() const;
    std::shared_ptr<const WearFrame> keptFrame() const;

    /// Of each cell of B its value less that of A, at the time shown; empty: there is no pair. NaN where A has no cell.
    std::vector<double> difference() const;
    /// Where the colours of the difference end: the most that any cell differs at any time so far, rounded up.
    double mostDifference() const;

    WearValue value() const { return value_; }
    void setValue(WearValue value);
    /// Where the colours end: g/m2, or a share. Both runs have the same: what the user has set, else a round number over what they hold;
    /// while a run goes on, over what it is expected to hold; this scale stays until the run holds more, or less than half is expected.
    double most() const;
    /// What the user has set; none: by the runs.
    std::optional<double> setMost() const { return most_[static_cast<std::size_t>(value_)]; }
    void setMost(std::optional<double> most);
    /// Where the eight colours end: as the user has set them, else even ones up to most(). Of a value, or of the one that is shown.
    WearSteps steps() const;
    const std::optional<WearSteps>& ownSteps(WearValue value) const { return steps_[static_cast<std::size_t>(value)]; }
    const std::optional<WearSteps>& ownSteps() const { return ownSteps(value_); }
    /// Precondition: they ascend, or there are none.
    void setSteps(WearValue value, const std::optional<WearSteps>& steps);

    const GarmentSpot& pin() const { return pin_; }
    void setPin(const GarmentSpot& spot);

Q_SIGNALS:
    void scaleChanged();
    void pinChanged();

protected:
    void bring() override { Q_EMIT frameShown(); }

private:
    QList<QPointF> curveOf(const WornRun& run) const;
    void take(const std::shared_ptr<WornRun>& run);
    void setWhole();
    void pair();
    void holdScale(double time);
    void measureDifference() const;

    std::shared_ptr<WornRun> run_, kept_;
    std::vector<int> places_; ///< of A, of each cell of B
    /// The most difference in each value, g/m2 and a share, of so many frames of B.
    mutable std::array<double, 2> most_difference_{};
    mutable int measured_ = 0;
    WearValue value_ = WearValue::water;
    std::array<std::optional<double>, 2> most_;
    std::array<double, 2> held_{}; ///< ends of the scales of a run that goes on; 0: none yet
    std::array<std::optional<WearSteps>, 2> steps_;
    GarmentSpot pin_;
    bool whole_ = false;
    std::atomic<long> opening_{0}; ///< of the newest request
    Mailbox mail_;                 ///< of what is read
    NewestJob reader_;
};

/// Whether a file is the recording of a garment; false for whatever cannot be read.
bool isGarmentRecording(const QString& path);

} // namespace hygroloom
