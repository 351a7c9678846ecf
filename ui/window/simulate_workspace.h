// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The workspace in which experiments run: its panels, the run in progress, and the recording that is shown.
#pragma once

#include "ui/results/playback.h"
#include "ui/results/simulation_run.h"

#include <QObject>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;

namespace hygroloom {

class Chart;
class Document;
class ExperimentPanel;
class Place;
class ResultsPanel;
class RunFilm;
class ProjectRuns;
enum class MapSide;
struct KeptRun;
class RunHistory;
class SimulationPanel;
class Timeline;
class Viewport;
class WaterMapView;

class SimulateWorkspace : public QObject {
    Q_OBJECT
public:
    struct Docks {
        QDockWidget* experiment = nullptr;
        QDockWidget* simulation = nullptr;
        QDockWidget* timeline = nullptr;
        QDockWidget* results = nullptr;
    };
    /// Commands that the tool bar shares with the menu.
    struct Actions {
        QAction* start = nullptr;
        QAction* pause = nullptr;
        QAction* stop = nullptr;
        QAction* play = nullptr;
        QAction* shown_plan = nullptr;
        QAction* take_design = nullptr;
        QAction* save_recording = nullptr;
        QAction* save_report = nullptr;
        QAction* save_top = nullptr;
        QAction* save_bottom = nullptr;
        QAction* save_pictures = nullptr;
        QAction* save_film = nullptr;
    };

    SimulateWorkspace(Document& document, RunHistory& history, ProjectRuns& runs, WindowQueue& queue, Viewport& viewport,
                      QMainWindow& window);
    ~SimulateWorkspace() override;

    Playback& playback() { return playback_; }
    SimulationRun& run() { return run_; }
    SimulationPanel& panel() { return *simulation_; }
    ExperimentPanel& experiment() { return *experiment_; }
    WaterMapView& maps() { return *maps_; }
    Chart& chart() { return *chart_; }
    ResultsPanel& results() { return *results_; }
    Timeline& timeline() { return *timeline_; }
    const Docks& docks() const { return docks_; }
    const Actions& actions() const { return actions_; }
    /// Adds saving of the recording to the File menu.
    void fillFileMenu(QMenu* menu);
    void fillExperimentMenu(QMenu* menu);

    /// Whether this workspace is the one on screen.
    void setShown(bool shown) { shown_ = shown; }
    /// Draws the run that is shown; false when there is none.
    bool drawRun();
    /// Draws the dry sample of the experiment; false when the project has an error or no experiment.
    bool drawSample();
    /// Marks where drops fall; the markers can be dragged.
    void refreshDrops();
    void refreshActions();
    bool resultsAreStale() const { return stale_; }
    /// Focuses the field of a value of an experiment or a liquid.
    void showIssue(const Place& where);

    /// Asks afterwards whether to keep what was recorded.
    void stopByHand();
    /// beyond_memory: also where it takes more than is free.
    void startRun(bool beyond_memory = false);
    /// Opens a recording, with its design if the project has neither changes nor runs. False when the user keeps the run in progress.
    bool openRecording(const QString& path);
    /// Opens the recording of an earlier run; the project stays.
    void showEarlierRun(const QString& recording);
    /// Clears the results, unless a run is in progress.
    void clearResults();
    /// Replaces the project's design by that of the recording.
    void takeDesign();
    /// Asks before a run in progress is stopped. True when it may be, or there is none.
    bool agreesToStopRun();
    /// Stops a run in progress, and keeps what is recorded.
    void stopRun();

Q_SIGNALS:
    void problemFound(const QString& sentence);
    /// For the status bar, for a time in ms.
    void messageShown(const QString& sentence, int ms);
    /// There is something to see here: a run or a recording.
    void wanted();
    /// A recording that is no run of the project was opened or saved.
    void recordingUsed(const QString& path);
    void pictureChanged();
    void designRequested();

private:
    // simulate_workspace.cpp
    void buildPanels(QMainWindow& window);
    void connectPanels();
    void refreshStale();
    void refreshKept();
    const KeptRun* keptOfChosen() const;
    QString whyStale() const;
    void chooseWhatRan();
    // simulate_workspace_runs.cpp
    void connectRun();
    void connectPlayback();
    void showRunEnd(SimulationRun::Outcome outcome, const QString& sentence);
    bool mayStopRun();
    void takeOpened(const QString& path);
    void keepRun();
    bool mayTakeDesign() const;
    void saveRecordingAs();
    void saveReport();
    void saveMap(MapSide side);
    void savePictures();
    void saveFilm();
    /// In the picture's window, frame by frame.
    RunFilm* makeFilm();
    void copyRecording(const QString& from, const QString& to);

    Document& document_;
    RunHistory& history_;
    ProjectRuns& runs_;
    Viewport& viewport_;
    WindowQueue& queue_;
    QMainWindow& window_;
    Playback playback_;
    SimulationRun run_;
    NewestJob copier_;
    QString run_path_;
    bool stopped_by_hand_ = false; ///< what was recorded is asked for
    bool stopping_ = false;        ///< to leave; nothing is offered instead
    QString opening_;              ///< the recording whose design is to be taken with it
    bool shown_ = false;
    bool stale_ = false;

    ExperimentPanel* experiment_ = nullptr;
    SimulationPanel* simulation_ = nullptr;
    WaterMapView* maps_ = nullptr;
    Timeline* timeline_ = nullptr;
    Chart* chart_ = nullptr;
    ResultsPanel* results_ = nullptr;
    Docks docks_;
    Actions actions_;
};

} // namespace hygroloom
