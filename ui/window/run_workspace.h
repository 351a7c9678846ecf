// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The workspace in which experiments run, on a sample or on a garment: panels, commands, the run in progress, the recording that is shown.
#pragma once

#include "ui/window/garment_subject.h"
#include "ui/window/sample_subject.h"

class QComboBox;
class QStackedWidget;

namespace hygroloom {

class Chart;
class ProjectRuns;
class RunList;
class RunPanel;
class Timeline;

enum class Subject { sample, garment };

class RunWorkspace : public QObject {
    Q_OBJECT
public:
    /// Of a garment there are two more: how it is cut, and its gaps and seams.
    struct Docks {
        QDockWidget* experiment = nullptr;
        QDockWidget* run = nullptr;
        QDockWidget* time = nullptr;
        QDockWidget* results = nullptr;
        QDockWidget* runs = nullptr;
        QDockWidget* garment = nullptr;
        QDockWidget* fit = nullptr;
    };
    /// Commands that the tool bar shares with the menu.
    struct Actions {
        QAction* start = nullptr;
        QAction* pause = nullptr;
        QAction* stop = nullptr;
        QAction* plan = nullptr;
        QAction* play = nullptr;
        QAction* take_design = nullptr;
        QAction* save_recording = nullptr;
        QAction* save_report = nullptr;
    };

    RunWorkspace(Document& document, RunHistory& history, ProjectRuns& runs, WindowQueue& queue, Viewport& viewport, QMainWindow& window);
    ~RunWorkspace() override;

    SampleSubject& sample() { return sample_; }
    GarmentSubject& garment() { return garment_; }
    Subject subject() const { return subject_; }
    /// Shows its experiment, its run and its numbers.
    void setSubject(Subject subject);
    QueuedRun& run() { return run_; }
    RunPanel& panel() { return *panel_; }
    RunList& list() { return *list_; }
    Timeline& timeline() { return timelineOf(subject_); }
    Timeline& timelineOf(Subject subject) { return *times_[static_cast<std::size_t>(subject)].timeline; }
    Chart& chartOf(Subject subject) { return *times_[static_cast<std::size_t>(subject)].chart; }
    const Docks& docks() const { return docks_; }
    const Actions& actions() const { return actions_; }
    /// Adds saving of recordings to the File menu.
    void fillFileMenu(QMenu* menu);
    void fillExperimentMenu(QMenu* menu);
    /// Whether the workspace is on screen.
    void setShown(bool shown);
    void refreshActions();
    /// Shows the panel of a garment, else that of the experiment.
    void revealForm(bool of_garment);
    /// False: the key means nothing here.
    bool pressKey(int key);

    /// Runs what is chosen. beyond_memory: also where it takes more than is free.
    void start(bool beyond_memory = false);
    /// Asks afterwards whether to keep what was recorded.
    void stopByHand();
    /// Opens a recording, with its design if the project has neither changes nor runs. False when the user keeps the run in progress.
    bool openRecording(const QString& path);
    /// Opens the recording of an earlier run; the project stays.
    void showEarlierRun(const QString& recording);
    /// Replaces the project's design by that of the run on screen.
    void takeDesign() { takeDesignOf(current()); }
    /// Writes a recording to another file, in the background.
    void saveRecording(const QString& from, const QString& to);
    /// Lets go of the runs that are shown, unless one is in progress.
    void clearResults();
    /// Asks before a run in progress is stopped. True when it may be, or there is none.
    bool agreesToStopRun();
    /// Stops a run in progress, and keeps what is recorded.
    void stopRun();

Q_SIGNALS:
    void problemFound(const QString& sentence);
    /// For the status bar, for a time in ms.
    void messageShown(const QString& sentence, int ms);
    /// There is something to see of this subject.
    void wanted(hygroloom::Subject subject);
    /// A recording that is no run of the project was opened or saved.
    void recordingUsed(const QString& path);
    void designRequested();

private:
    /// What goes through the time of a subject's run.
    struct Time {
        QWidget* page = nullptr;
        Timeline* timeline = nullptr;
        Chart* chart = nullptr;
    };
    // run_workspace.cpp
    void buildPanels();
    QWidget* makeForm();
    static Time makeTime(ShownRun& shown);
    void connectParts();
    void connectSubject(Subject subject);
    void refreshChoice();
    void choose(int index);
    void finish(QueuedRun::Outcome outcome, const QString& sentence);
    void runAgain(bool beyond_memory);
    void offerInstead(QueuedRun::Outcome outcome, const QString& sentence);
    // run_workspace_files.cpp
    void keepRun(RunSubject& subject);
    bool mayTakeDesign() const;
    bool mayReplace(const RunSubject& subject);
    void takeDesignOf(RunSubject& subject);
    void takeOpened(Subject subject, const QString& path);
    Subject subjectOf(const QString& recording) const;
    void askToSaveRecording(const QString& from);
    void saveReport();

    RunSubject& of(Subject subject) { return subject == Subject::sample ? static_cast<RunSubject&>(sample_) : garment_; }
    RunSubject& current() { return of(subject_); }

    Document& document_;
    RunHistory& history_;
    ProjectRuns& runs_;
    QMainWindow& window_;
    WindowQueue& queue_;
    SampleSubject sample_;
    GarmentSubject garment_;
    QueuedRun run_; ///< ends before what it shows goes
    NewestJob copier_;
    Subject subject_ = Subject::sample;
    RunSubject* running_ = nullptr; ///< of the last run
    QString run_path_;
    QString opening_;              ///< the recording whose design is to be taken with it
    bool stopped_by_hand_ = false; ///< what was recorded is asked for
    bool stopping_ = false;        ///< to leave; nothing is offered instead
    bool taking_ = false;          ///< the design of a run, which stays on screen
    bool shown_ = false;

    QComboBox* choice_ = nullptr;
    QStackedWidget* forms_ = nullptr;
    QStackedWidget* time_ = nullptr;
    QStackedWidget* results_ = nullptr;
    std::array<Time, 2> times_;
    RunPanel* panel_;
    RunList* list_;
    Docks docks_;
    Actions actions_;
};

} // namespace hygroloom
