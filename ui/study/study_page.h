// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The page of studies: set one up at the left, run it, and read its results at the right.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/study/study_cost.h"
#include "ui/study/study_data.h"
#include "ui/study/study_task.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;
class QTabWidget;

namespace hygroloom {

class Document;
class EffectsView;
class IndicesView;
class PairsView;
class ParallelView;
class StudySetup;
class StudyTableModel;

class StudyPage : public QWidget {
    Q_OBJECT
public:
    StudyPage(Document& document, WindowQueue& queue, QWidget* parent = nullptr);
    ~StudyPage() override;

    StudySetup& setup() { return *setup_; }
    StudyTask& job() { return job_; }
    ParallelView& parallel() { return *parallel_; }
    PairsView& pairs() { return *pairs_; }
    IndicesView& indices() { return *indices_; }
    StudyTableModel& table() { return *model_; }
    /// nullptr: no results are shown.
    const std::shared_ptr<const StudyData>& results() const { return data_; }
    /// s, that the last opening took until the table stood there.
    double openingTime() const { return opening_time_; }
    QString cost() const;
    QString status() const;
    /// The table or chart that is seen.
    QImage picture() const;

    /// A study file. False after failed().
    bool openStudy(const QString& path);
    bool saveStudy(const QString& path);
    /// A folder of a study, or results.csv or study.sqlite. shown() or failed() follows.
    void openResults(const QString& path);
    void setFolder(const QString& folder);
    QString folder() const;
    /// Runs what the folder lacks.
    void run(bool retry_failed = false);
    void choose(std::optional<std::size_t> row);
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// Adds the chosen row's fabric to the project.
    void makeCandidate();
    bool modified() const;
    /// Asks about an edited study, and about one that runs. True when both may go.
    bool agreesToLeave();
    /// Until it has ended.
    void stopRun();

Q_SIGNALS:
    void failed(const QString& sentence);
    void messageShown(const QString& sentence);
    /// Results stand in the table and the charts.
    void shown();
    void costForetold();

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    // study_page_build.cpp
    void build();
    QWidget* buildLeft();
    QWidget* buildRight();
    QWidget* buildTable();
    void connectParts();
    // study_page.cpp
    /// The project, with files of garments named in full: a study runs in another folder.
    std::shared_ptr<const Design> design() const;
    void refreshSetup();
    void foretell();
    void newStudy();
    void chooseStudy();
    bool save(bool as);
    bool mayDiscardStudy();
    void chooseFolder();
    void chooseResults();
    void showRecent();
    void proposeFolder();
    void remember(const QString& folder);
    void showCluster();
    // study_page_results.cpp
    void refreshRun();
    void endRun();
    void showResults(const std::shared_ptr<const StudyData>& study);
    void followRun();
    void takeBrush();
    void computeIndices();
    void showFailures();

    Document& document_;
    StudySetup* setup_;
    StudyTableModel* model_;
    EffectsView* effects_;
    PairsView* pairs_;
    ParallelView* parallel_;
    IndicesView* indices_;

    QString proposed_; ///< folder for the results
    QString path_;     ///< of the study file; empty: it has none
    Study saved_;      ///< as the file has it
    std::shared_ptr<const StudyData> data_;
    std::optional<std::size_t> chosen_;
    double opening_time_ = 0;
    bool asks_indices_ = false; ///< of the results that are being read, once they are there
    std::size_t followed_ = 0;  ///< rows that had ended when the table was last read

    QLabel* name_;
    QLabel* problems_;
    QLabel* cost_;
    QComboBox* folder_;
    QPushButton *run_, *stop_, *retry_, *cluster_, *failures_;
    QLabel* heading_;
    QLabel* row_;
    QPushButton* candidate_;
    QTableView* view_;
    QTabWidget* tabs_;
    QProgressBar* bar_;
    QLabel* status_;
    QTimer pause_;     ///< after an edit, until the cost is foretold
    QTimer following_; ///< while a study runs
    StudyTask job_;
    NewestJob foreteller_, reader_, analyst_; // last: they end before the rest goes
};

} // namespace hygroloom
