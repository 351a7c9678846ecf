// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Water maps of several runs side by side, at one time and on one colour scale.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/compare/map_reader.h"
#include "ui/results/color_ranges.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QSlider;

namespace hygroloom {

class CompareMaps : public QWidget {
    Q_OBJECT
public:
    explicit CompareMaps(QWidget* parent = nullptr);

    /// Of the same experiment, with their titles; those whose titles are names of candidates have their replicates. Without runs the hint
    /// is shown instead. baseline: what differences are to, with its title; it may be one of the runs.
    void setRuns(const std::vector<KeptRun>& runs, const QStringList& titles, const QString& hint,
                 const std::optional<KeptRun>& baseline = {}, const QString& baseline_title = {}, const Comparison& comparison = {});
    enum class Shown { maps, differences };
    void show(Shown shown);
    void setWaterColors(WaterColors colors);
    /// Of the maps' water; differences have an end of their own. Precondition: it lives as long as this.
    void shareRanges(ColorRanges& ranges);
    /// From 0 to 1 of the experiment.
    void setTime(double share);
    const std::vector<WaterMap*>& maps() const { return maps_; }

Q_SIGNALS:
    void mapsChanged();
    /// The share of the experiment that has passed.
    void timeChanged(double share);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double duration() const;
    double shownTime() const;
    MapSide side() const;
    bool differs() const;
    void readMaps();
    QStringList identitiesOf(const std::vector<KeptRun>& runs) const;
    void showMaps(const MapsRead& read);
    void showDifferences(const MapsRead& read);
    QString greyText(const MapError& error, int pairs, double share, const QStringList& unknown) const;
    void showProblem(const QString& sentence);
    void showRange();

    std::vector<KeptRun> runs_;
    QStringList titles_;
    std::vector<Candidate> candidates_; ///< of each run and then the baseline
    QStringList identities_;            ///< title, path and date of each run: other ones need other maps
    QWidget* side_by_side_;
    QHBoxLayout* row_;
    QWidget* legend_;
    QLabel* empty_;
    std::optional<KeptRun> baseline_;
    QString baseline_title_;
    QComboBox* shown_;
    QComboBox* face_;
    QSlider* time_;
    QLabel* shown_time_;
    QLabel* value_;
    QLabel* problem_;
    QLabel* grey_; ///< what grey cells are
    std::vector<WaterMap*> maps_;
    long requests_ = 0;             ///< for maps
    bool any_water_ = false;        ///< on a map that is shown
    double largest_difference_ = 0; ///< kg/m2, of all times of these runs that were shown
    ColorRanges own_ranges_;
    ColorRanges* ranges_ = &own_ranges_;
    WaterColors colors_ = WaterColors::blue;
    NewestJob reader_;
};

} // namespace hygroloom
