// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments side by side, flat and in 3D, with their water at one time on one colour scale, or its difference to the baseline's.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/garment/worn_run.h"
#include "ui/results/run_history.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QSlider;

namespace hygroloom {

class GarmentPane;
class StepLegend;

class GarmentMaps : public QWidget {
    Q_OBJECT
public:
    explicit GarmentMaps(QWidget* parent = nullptr);

    /// Of the same experiment, with their titles. Without runs the hint is shown instead. baseline: what differences are to; it may be one
    /// of the runs.
    void setRuns(const std::vector<KeptRun>& runs, const QStringList& titles, const QString& hint, const std::optional<KeptRun>& baseline);
    enum class Shown { water, share, water_difference, share_difference };
    void show(Shown shown);
    /// From 0 to 1 of the experiment.
    void setTime(double share);
    const std::vector<GarmentPane*>& panes() const { return panes_; }
    StepLegend& legend() { return *legend_; }
    /// What is said of the place under the pointer.
    QString probeText() const;
    QImage picture();

Q_SIGNALS:
    /// All garments are drawn as they were asked for.
    void mapsChanged();

private:
    /// A run as it was read, and its frame at the time shown.
    struct Drawn {
        QString identity;                               ///< path and date
        std::shared_ptr<const WearRecording> recording; ///< used by the reader's thread only
        std::shared_ptr<const WornRun> run;
        std::shared_ptr<const WearFrame> frame;
    };
    Shown shown() const;
    WearValue value() const;
    bool differs() const;
    double duration() const;
    void makePanes();
    void connectPane(std::size_t pane);
    void read();
    void draw();
    void drawDifferences();
    void showProbe(std::size_t pane, const GarmentSpot& spot);
    static Drawn readOne(const KeptRun& run, double share, const std::vector<Drawn>& known);

    std::vector<KeptRun> runs_;
    QStringList titles_;
    std::optional<KeptRun> baseline_;
    std::vector<Drawn> drawn_; ///< of each run, and the baseline as the last; empty until panes that are new show them
    std::vector<Drawn> known_; ///< what was read last
    QStringList identities_;
    std::array<double, 4> most_{}; ///< of any cell at the times that were shown, for each of Shown
    QWidget* side_by_side_;
    QHBoxLayout* row_;
    std::vector<GarmentPane*> panes_;
    StepLegend* legend_;
    QLabel* empty_;
    QLabel* probe_;
    QLabel* problem_;
    QComboBox* sides_;
    QComboBox* shown_;
    QSlider* time_;
    QLabel* shown_time_;
    NewestJob reader_;
};

} // namespace hygroloom
