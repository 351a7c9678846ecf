// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Two to four runs of the same experiment side by side: their numbers in a table and their water maps.
#pragma once

#include "ui/results/run_history.h"
#include "ui/results/water_map.h"

#include <QImage>
#include <QWidget>

class QLabel;
class QPushButton;
class QTableWidget;
class QTreeWidget;

namespace hygroloom {

class CompareMaps;
class RunActions;
struct Comparison;

class CompareView : public QWidget {
    Q_OBJECT
public:
    explicit CompareView(RunHistory& history, QWidget* parent = nullptr);

    static constexpr int most_runs = 4;

    /// The recordings that are compared.
    QStringList chosen() const { return chosen_; }
    /// Adds a run to the comparison, or removes it. Nothing happens where it cannot be compared with the others.
    void choose(const QString& path, bool on);
    /// The run that the verdicts are against; the first of the list where it is not among the compared ones.
    void setBaseline(const QString& path);
    const std::vector<WaterMap*>& maps() const;
    const QTableWidget* table() const { return table_; }
    /// The maps as they are seen; null while nothing is compared.
    QImage picture() const;
    void setWaterColors(WaterColors colors);
    /// The numbers as a CSV file, the best run first.
    std::string tableCsv() const;

Q_SIGNALS:
    /// A run of the list is to be opened.
    void runRequested(const QString& path);
    void markRequested(const QString& path, bool marked);
    void forgetRequested(const QString& path);
    void mapsChanged();
    void failed(const QString& sentence);

private:
    QWidget* buildList();
    /// The fabric, with the run's number where the history has more runs of it.
    QString nameOf(const KeptRun& run) const;
    std::vector<KeptRun> compared() const;
    /// Why a run of the list cannot be chosen now; empty when it can.
    QString whyNot(const KeptRun& run) const;
    void propose();
    void refresh();
    void refreshList();
    void refreshTable();
    void refreshMaps();
    Comparison comparison() const;
    void saveTable();

    RunHistory& history_;
    QStringList chosen_;
    QString baseline_;
    bool proposing_ = true; ///< until the user chooses
    QTreeWidget* list_;
    RunActions* actions_;
    QTableWidget* table_;
    CompareMaps* maps_;
    QLabel* origin_;
    QPushButton* save_;
};

} // namespace hygroloom
