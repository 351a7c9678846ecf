// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Two to four runs in three dimensions, side by side, with one camera and one clock.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/picture/viewport.h"
#include "ui/results/run_history.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QSlider;

namespace hygroloom {

/// Nothing is built or read before it is seen.
class ClothsView : public QWidget {
    Q_OBJECT
public:
    explicit ClothsView(QWidget* parent = nullptr);

    void setRuns(const std::vector<KeptRun>& runs, const QStringList& titles, const QString& hint);
    /// From 0 to 1 of the experiment.
    void setTime(double share);
    void setWaterColors(WaterColors colors);
    const std::vector<Viewport*>& cloths() const { return cloths_; }

Q_SIGNALS:
    /// From 0 to 1 of the experiment.
    void timeChosen(double share);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void addCloth(const KeptRun& run, const QString& title);
    void readFrames();
    void follow(const Viewport* moved);

    std::vector<KeptRun> runs_;
    QStringList built_; ///< path and date of each run that is shown
    QStringList titles_;
    double time_ = 1;
    WaterColors colors_ = WaterColors::blue;
    bool following_ = false;
    QHBoxLayout* row_;
    QLabel* empty_;
    QSlider* clock_;
    QLabel* shown_time_;
    QLabel* problem_;
    std::vector<Viewport*> cloths_;
    NewestJob reader_;
};

} // namespace hygroloom
