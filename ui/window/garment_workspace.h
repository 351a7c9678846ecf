// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The workspace in which a garment is cut from fabrics and worn.
#pragma once

#include "ui/garment/garment_choice.h"
#include "ui/garment/garment_run.h"
#include "ui/garment/wear_playback.h"

#include <QObject>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;

namespace hygroloom {

class Chart;
class FitForm;
class GarmentPanel;
class GarmentView;
class PartsTable;
class ProjectRuns;
class RunForm;
class RunHistory;
class RunList;
class Timeline;
class WearForm;
struct KeptRun;

class GarmentWorkspace : public QObject {
    Q_OBJECT
public:
    struct Docks {
        QDockWidget* garment = nullptr;
        QDockWidget* fit = nullptr;
        QDockWidget* wear = nullptr;
        QDockWidget* run = nullptr;
        QDockWidget* time = nullptr;
        QDockWidget* parts = nullptr;
        QDockWidget* runs = nullptr;
    };
    struct Actions {
        QAction* start = nullptr;
        QAction* pause = nullptr;
        QAction* stop = nullptr;
    };

    GarmentWorkspace(Document& document, RunHistory& history, ProjectRuns& runs, WindowQueue& queue, QMainWindow& window);
    ~GarmentWorkspace() override;

    GarmentChoice& choice() { return choice_; }
    GarmentPanel& panel() { return *garment_; }
    FitForm& fit() { return *fit_; }
    WearForm& wear() { return *wear_; }
    RunForm& runForm() { return *form_; }
    GarmentRun& run() { return run_; }
    WearPlayback& playback() { return playback_; }
    Chart& chart() { return *chart_; }
    PartsTable& parts() { return *parts_; }
    RunList& list() { return *list_; }
    GarmentView& view() { return *view_; }
    const Docks& docks() const { return docks_; }
    const Actions& actions() const { return actions_; }
    void fillMenu(QMenu* menu);
    /// Its commands that stand in the tool bar are there while the workspace is on screen.
    void setShown(bool shown);
    bool pressKey(int key);
    /// Chooses the garment or the experiment of an issue.
    void showIssue(bool of_garment, int index);
    /// Reads a recording, unless a run is in progress. Where the project has neither changes nor runs, the design of the recording takes
    /// its place once that is read.
    void openRecording(const QString& path);
    /// The same, and the project stays.
    void showEarlierRun(const QString& path);
    /// The design of the run on screen, in place of the project.
    void takeDesign();
    /// Asks before a run in progress is stopped. True when it may be, or there is none.
    bool agreesToStopRun();
    /// Asks afterwards whether to keep what was recorded.
    void stopByHand();
    /// Waits until it has ended, 0.2 s or so.
    void stopRun();
    void clearResults();
    /// Writes the run that is shown, or the one kept as A, to another recording, in the background.
    void saveRun(const QString& path);
    void saveA(const QString& path);

Q_SIGNALS:
    void problemFound(const QString& sentence);
    void messageShown(const QString& sentence, int ms);
    /// There is something to see here.
    void wanted();
    /// A recording that is no run of the project was opened or saved.
    void recordingUsed(const QString& path);
    /// The user wants to edit the design of the run on screen.
    void designRequested();

private:
    void connectRun();
    void chooseRecording();
    WearMapOptions mapOptions() const;
    void saveMap();
    void saveReport();
    void chooseRunFile();
    void chooseFileOfA();
    void write(const std::shared_ptr<WornRun>& run, const QString& path, NewestJob& recorder);
    /// Where the next run is recorded; empty after the reason was given.
    QString reserve();
    void finishRun(GarmentRun::Outcome outcome, const QString& sentence);
    /// Adds the run on screen to the project's.
    void keepRun();
    const KeptRun* keptOfChosen() const;
    QString offered_; ///< the run that the line over the garment offers
    void refreshOffer();
    bool mayTakeDesign() const;
    void chooseWhatRan();
    void refreshActions();

    Document& document_;
    RunHistory& history_;
    ProjectRuns& runs_;
    QMainWindow& window_;
    GarmentChoice choice_;
    WearPlayback playback_;
    GarmentRun run_;
    NewestJob saver_;
    NewestJob recorder_;
    NewestJob recorder_of_a_;
    NewestJob reporter_;
    GarmentPanel* garment_;
    FitForm* fit_;
    WearForm* wear_;
    RunForm* form_;
    Timeline* timeline_;
    Chart* chart_;
    PartsTable* parts_;
    RunList* list_;
    GarmentView* view_;
    Docks docks_;
    Actions actions_;
    QAction* remove_ = nullptr;
    QAction* open_ = nullptr;
    QAction* save_run_ = nullptr;
    QAction* save_a_ = nullptr;
    QAction* save_map_ = nullptr;
    QAction* save_report_ = nullptr;
    QAction* copy_ = nullptr;
    QAction* steps_ = nullptr;
    QAction* keep_ = nullptr;
    QAction* drop_ = nullptr;
    QAction* take_ = nullptr;
    bool opening_ = false, taking_ = false;
    bool stopped_by_hand_ = false; ///< what was recorded is asked for
    QString to_take_;              ///< the recording whose design the project gives way to
    QString run_path_;             ///< of the run in progress
};

} // namespace hygroloom
