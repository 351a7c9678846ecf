// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Two to four runs of the same experiment side by side: their maps at one moment in one range of colours, and their numbers.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/results/run_history.h"
#include "ui/results/water_map.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QSlider;
class QTableWidget;
class QTreeWidget;

namespace hygroloom {

struct Comparison;

class CompareView : public QWidget {
    Q_OBJECT
public:
    explicit CompareView(RunHistory& history, QWidget* parent = nullptr);

    static constexpr int most_runs = 4;

    /// The recordings that stand side by side.
    QStringList chosen() const { return chosen_; }
    /// Puts a run beside the others, or takes it away. Nothing happens where it cannot be compared with them.
    void choose(const QString& path, bool on);
    const std::vector<WaterMap*>& maps() const { return maps_; }
    const QTableWidget* table() const { return table_; }
    void setWaterColors(WaterColors colors);
    /// The numbers as a CSV file, the best run first.
    std::string tableCsv() const;

Q_SIGNALS:
    /// A run of the list is to be looked at by itself.
    void runRequested(const QString& path);
    void mapsChanged();
    void failed(const QString& sentence);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QWidget* buildList();
    QWidget* buildMaps();
    const KeptRun* find(const QString& path) const;
    /// The fabric, with the run's number where the history has more runs of it.
    QString nameOf(const KeptRun& run) const;
    std::vector<KeptRun> compared() const;
    double duration() const;
    double moment() const;
    /// Why a run of the list cannot be chosen now; empty when it can.
    QString whyNot(const KeptRun& run) const;
    void propose();
    void refresh();
    void refreshList();
    void refreshTable();
    void refreshMaps();
    void readMaps();
    void showMaps(const std::vector<FaceMap>& maps);
    void showProblem(const QString& sentence);
    void showRange();
    Comparison comparison() const;
    void saveTable();

    RunHistory& history_;
    QStringList chosen_;
    bool proposing_ = true; ///< until the user chooses
    QTreeWidget* list_;
    QTableWidget* table_;
    QLabel* empty_;
    QLabel* origin_;
    QPushButton* save_;
    QWidget* side_by_side_;
    QHBoxLayout* row_ = nullptr;
    QWidget* legend_;
    QComboBox* face_;
    QSlider* time_;
    QLabel* shown_time_;
    QLabel* value_;
    QLabel* problem_;
    std::vector<WaterMap*> maps_;
    QStringList mapped_; ///< what the maps are of
    QStringList drawn_;  ///< their titles and when they ran, by which other maps are told
    long asked_ = 0;     ///< for maps, so many times
    double maximum_ = 0; ///< kg/m2, of all moments of these runs that were looked at
    WaterColors colors_ = WaterColors::blue;
    NewestJob reader_;
};

} // namespace hygroloom
