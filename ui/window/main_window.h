// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The window: puts the panels round the picture, and connects them.
#pragma once

#include "ui/basics/color_map.h"
#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/picture/viewport.h"
#include "ui/results/playback.h"
#include "ui/results/run_history.h"
#include "ui/results/simulation_run.h"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QPointer>
#include <QTemporaryDir>

class QActionGroup;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace hygroloom {

class CandidatesPanel;
class Chart;
class CompareView;
class DraftEditor;
class ExperimentPanel;
class ExportDialog;
class FabricPanel;
class IssuesPanel;
class ResultsPanel;
class SimulationPanel;
class Timeline;
class WaterMapView;
class WeaveEditor;

enum class Workspace { design, simulate, compare };

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// A project or a recording, told apart by its ending. False after the user was told why not.
    bool openFile(const QString& path);
    /// Asks what to take of a draft, a grid of text or a picture, and adds it as a candidate. False after the user was told why not.
    bool importDraft(const QString& path);
    /// The example that ships with the program; an empty project where it cannot be found.
    void openShippedExample();
    /// Asks whether to open what an earlier window had not saved when it ended, where there is such.
    void offerLeftOver();

    Document& document() { return document_; }
    Playback& playback() { return playback_; }
    SimulationRun& simulation() { return run_; }
    SimulationPanel& simulationPanel() { return *simulation_panel_; }
    Viewport& viewport() { return *viewport_; }
    WaterMapView& waterMaps() { return *maps_; }
    CompareView& compareView() { return *compare_; }
    RunHistory& runs() { return history_; }
    Chart& chart() { return *chart_; }
    ResultsPanel& results() { return *results_; }
    Timeline& timeline() { return *timeline_; }
    Workspace workspace() const { return workspace_; }
    void setWorkspace(Workspace workspace);
    bool resultsAreStale() const { return stale_; }

public Q_SLOTS:
    void startRun();
    void resetLayout();

protected:
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    static constexpr int layout_version = 3;
    // main_window.cpp
    void buildPanels();
    void connectParts();
    void arrange(Workspace workspace);
    void refreshTitle();
    void refreshPicture();
    void chooseWhatRan();
    void refreshDrops();
    void refreshStale();
    /// Of results that are stale, in a sentence.
    QString whyStale() const;
    void keepRun();
    void makeRoom();
    bool ownRecording(const QString& path) const;
    void showRun(const QString& recording);
    void openRecording(const QString& path);
    void refreshIssueCount();
    void showIssue(const QString& where);
    void showFabricIssue(const QString& where, const QString& part);
    void showMaterialIssue(int material);
    void takeTypedValue();
    void showRunEnd(SimulationRun::Outcome outcome, const QString& sentence);
    void tellProblem(const QString& sentence);
    // main_window_actions.cpp
    void buildActions();
    void buildFileMenu();
    void buildEditMenu();
    void buildViewMenu();
    void buildFabricMenu();
    void buildExperimentMenu();
    void buildHelpMenu();
    void buildToolBar();
    void refreshActions();
    void findCommand();
    void about();
    // main_window_files.cpp
    void offer(const LeftOver& left);
    void newProject();
    void chooseFile();
    bool save();
    bool saveAs();
    void saveRecordingAs();
    void saveScreenshot();
    void chooseDraft();
    void exportDraft();
    void exportMesh();
    bool mayDiscard();
    bool mayStop(const QString& what, const QString& question, const QString& consequence, const QString& button);
    bool mayStopRun();
    bool mayDropRuns();
    bool mayStopExport();
    void addRecentFile(const QString& path);
    void refreshRecentFiles();

    Document document_;
    Recovery recovery_{document_};
    QTemporaryDir recordings_; // outlives those who read and write in it
    Playback playback_;
    SimulationRun run_;
    RunHistory history_;
    QPointer<ExportDialog> export_;
    NewestJob copier_;
    int runs_ = 0;
    QString run_path_;
    QElapsedTimer run_clock_;
    double run_elapsed_ = 0; ///< s, of the run at run_path_ once it has ended
    QString opening_;        ///< the recording whose design is to be taken with it
    QString next_;           ///< the recording to open once the run that was stopped has ended
    Workspace workspace_ = Workspace::design;
    QByteArray states_[3]; ///< by workspace
    QByteArray first_states_[3];
    bool stale_ = false;
    bool closing_ = false; ///< questions are being asked, or an end is awaited

    Viewport* viewport_ = nullptr;
    WaterMapView* maps_ = nullptr;
    QStackedWidget* middle_ = nullptr; ///< the fabric with its maps, or runs side by side
    CompareView* compare_ = nullptr;
    CandidatesPanel* candidates_ = nullptr;
    WeaveEditor* weave_ = nullptr;
    DraftEditor* draft_ = nullptr;
    FabricPanel* fabric_panel_ = nullptr;
    ExperimentPanel* experiment_panel_ = nullptr;
    SimulationPanel* simulation_panel_ = nullptr;
    IssuesPanel* issues_ = nullptr;
    Timeline* timeline_ = nullptr;
    Chart* chart_ = nullptr;
    ResultsPanel* results_ = nullptr;
    QDockWidget* candidates_dock_ = nullptr;
    QDockWidget* weave_dock_ = nullptr;
    QDockWidget* draft_dock_ = nullptr;
    QDockWidget* fabric_dock_ = nullptr;
    QDockWidget* experiment_dock_ = nullptr;
    QDockWidget* simulation_dock_ = nullptr;
    QDockWidget* issues_dock_ = nullptr;
    QDockWidget* timeline_dock_ = nullptr;
    QDockWidget* results_dock_ = nullptr;
    QToolButton* issue_count_ = nullptr;

    QAction* open_ = nullptr;
    QAction* save_ = nullptr;
    QAction* save_recording_ = nullptr;
    QAction* screenshot_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QAction* start_ = nullptr;
    QAction* pause_ = nullptr;
    QAction* stop_ = nullptr;
    QAction* play_ = nullptr;
    QAction* plan_ = nullptr;
    QAction* shown_plan_ = nullptr;
    QAction* take_design_ = nullptr;
    QMenu* recent_ = nullptr;
    QActionGroup* workspaces_ = nullptr;
};

} // namespace hygroloom
