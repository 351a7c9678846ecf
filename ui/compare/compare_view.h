// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// All fabrics of the project, and recordings that were opened, on one experiment: their numbers in a table, what is missing to be run, and
// two to four of them in maps and charts.
#pragma once

#include "core/wear/wear_outcomes.h"
#include "ui/basics/newest_job.h"
#include "ui/compare/candidate_grid.h"
#include "ui/compare/study_runs.h"
#include "ui/results/water_map.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <tuple>

class QLabel;
class QTabWidget;

namespace hygroloom {

class CandidateTable;
class CardColumns;
class ClothsView;
class CompareBar;
class ColorRanges;
class CompareMaps;
class CurvesView;
class FingerprintView;
class GarmentMaps;
class ScatterView;
class WhyView;
class RunList;

class CompareView : public QWidget {
    Q_OBJECT
public:
    CompareView(Document& document, RunHistory& history, StudyRuns& runs, QWidget* parent = nullptr);

    static constexpr int most_runs = 4;

    /// The recordings whose maps and curves are shown.
    QStringList chosen() const { return chosen_; }
    /// Adds a run to the comparison, or removes it. Nothing happens where it cannot be compared with the others.
    void choose(const QString& path, bool on);
    /// The run that the verdicts are against; the first of the table where it is not in it.
    void setBaseline(const QString& path);
    /// Shows an experiment of the project; empty: the overview of all.
    void showExperiment(const std::string& name);
    const std::vector<WaterMap*>& maps() const;
    GarmentMaps& garmentMaps() { return *garment_maps_; }
    CurvesView& curves() { return *curves_; }
    CandidateTable* table() { return table_; }
    CardColumns& cards() { return *cards_; }
    CompareBar* bar() { return bar_; }
    /// The maps or the chart as it is seen; null while nothing is compared.
    QImage picture() const;
    void setWaterColors(WaterColors colors);
    void shareRanges(ColorRanges& ranges);
    /// The experiment on screen, judged; of the overview it has no candidates.
    const Comparison& comparison() const { return numbers_; }
    /// The numbers as a CSV file, the best run first.
    std::string tableCsv() const;

Q_SIGNALS:
    /// A run of the list is to be opened.
    void runRequested(const QString& path);
    void markRequested(const QString& path, bool marked);
    void forgetRequested(const QString& path);
    void mapsChanged();
    void failed(const QString& sentence);
    /// A report was written.
    void saved(const QString& file);

protected:
    void showEvent(QShowEvent* event) override;

private:
    /// An experiment to show: of the project, or of runs that are not of it.
    struct Entry {
        std::string name;
        bool own = true;
        Design conditions; ///< see conditionsOf()
        bool worn() const { return !conditions.wears.empty(); }
    };
    void connectParts();
    void connectBar();
    void refresh();
    void findEntries();
    void propose();
    void dropOutdated();
    void followReplicates();
    int entryOf(const KeptRun& run) const;
    int homeOf(const KeptRun& run) const;
    bool isOnScreen(const KeptRun& run) const;
    const Entry* entry() const { return selected_ < 0 ? nullptr : &entries_[static_cast<std::size_t>(selected_)]; }
    StudyChoice choiceOf(const Entry& entry) const;
    std::vector<StudyRow> ownRowsOf(const Entry& entry) const;
    std::vector<StudyRow> rowsOf(const Entry& entry) const;
    std::vector<KeptRun> compared() const;
    QString nameOf(const KeptRun& run) const;
    QString whyNot(const KeptRun& run) const;
    // compare_view_table.cpp
    void refreshTable();
    Grid overview();
    void markMissing(Grid& grid) const;
    QString noteOf(const QString& path) const;
    /// The newest run of it on an older design; nullptr: there is none.
    const KeptRun* outdatedRun(const std::string& fabric, const std::string& experiment) const;
    void refreshMissing();
    void refreshLower();
    void refreshTabs();
    void refreshParts();
    std::vector<OutcomeInfo> criteriaOf(const Entry& entry) const;
    std::vector<GridEntry> gridEntries(const std::vector<StudyRow>& rows) const;
    // compare_view_notes.cpp
    void refreshHint();
    QString outdatedText() const;
    std::vector<StudyJob> missing() const;
    QString whyNoRun() const;
    /// None: not known yet. 0: it cannot be known.
    std::optional<double> secondsOf(const StudyJob& job) const;
    void plan(const std::vector<StudyJob>& jobs);
    void start(const std::vector<StudyJob>& jobs);
    void saveTable();
    void saveReport();
    void chooseMeasured();
    /// Takes up the file that was chosen for the experiment in an earlier session.
    void recallMeasured();
    LaboratoryTable measuredIn(const QString& file) const;

    using KindOfJob = std::tuple<std::string, std::string, Fidelity, bool>; ///< fabric, experiment; whether it is recorded
    static KindOfJob kindOf(const StudyJob& job) { return {job.fabric, job.experiment, job.fidelity, job.recorded}; }

    Document& document_;
    RunHistory& history_;
    StudyRuns& runs_;
    std::vector<Entry> entries_;
    int selected_ = -1;                               ///< less than 0: the overview
    std::vector<StudyRow> rows_;                      ///< of the selected experiment
    std::vector<std::vector<StudyRow>> all_rows_;     ///< in the overview, of each of the project's experiments
    Comparison numbers_;                              ///< of rows_, judged
    std::map<std::string, LaboratoryTable> measured_; ///< by experiment
    QStringList chosen_;
    std::string baseline_;                 ///< as named in the table
    WearPartName part_;                    ///< of garments, whose numbers are shown
    bool proposing_ = true;                ///< until the user chooses
    bool selecting_ = true;                ///< the same of the experiment
    bool fidelity_follows_ = true;         ///< the same of the fidelity
    bool replicates_follow_ = true;        ///< the same of the replicates
    std::string replicates_of_;            ///< the experiment for which they were set
    std::map<KindOfJob, double> expected_; ///< s, of a run of planned_
    std::shared_ptr<const Design> planned_;
    CompareBar* bar_;
    CardColumns* cards_;
    QTabWidget* upper_;
    CandidateTable* table_;
    RunList* list_;
    QTabWidget* lower_;
    CompareMaps* maps_;
    GarmentMaps* garment_maps_;
    CurvesView* curves_;
    FingerprintView* fingerprint_;
    ScatterView* scatter_;
    WhyView* why_;
    ClothsView* cloths_;
    QLabel* note_;
    QTimer soon_; ///< many runs may end in a short time
    NewestJob planner_;
    NewestJob reporter_;
};

} // namespace hygroloom
