// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The window: the document, the three workspaces round one picture, menus and files.
#pragma once

#include "ui/document/document.h"
#include "ui/document/recovery.h"
#include "ui/picture/viewport.h"
#include "ui/results/color_ranges.h"
#include "ui/window/compare_workspace.h"
#include "ui/window/run_workspace.h"

#include <QMainWindow>
#include <QPointer>

class QActionGroup;
class QStackedWidget;
class QToolButton;

namespace hygroloom {

enum class Reply;
class CardDialog;
class DesignWorkspace;
class ExportDialog;
class HelpWindow;
class IssuesPanel;
class LessonWindow;
class PreferencesDialog;
class QueueButton;
class RecentFiles;
class StartPage;
class StudyPage;

/// What the window shows. The workspace Run is of a sample (simulate) or a garment, Compare of runs or a study.
enum class Workspace { design, simulate, compare, garment, study };

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a project, a recording or a draft, by its ending. False after a message box gave the reason, or when the user cancels.
    bool openFile(const QString& path);
    /// Asks what to take of a draft, a grid of text or a picture, and adds it as a candidate. False as openFile().
    bool importDraft(const QString& path);
    /// The example that ships with the program; an empty project where it cannot be found.
    void openShippedExample();
    /// Offers to open unsaved work of a window that crashed. True when some was opened.
    bool offerLeftOver();
    /// What to begin with. The program asks for it where no file was named.
    void showStartPage();
    void showPreferences();

    Document& document() { return document_; }
    Viewport& viewport() { return *viewport_; }
    DesignWorkspace& design() { return *design_; }
    RunWorkspace& run() { return *run_; }
    CompareWorkspace& compare() { return *compare_; }
    StudyPage& study() { return *study_; }
    /// nullptr until the user's guide has been opened.
    HelpWindow* guide() { return guide_; }
    /// nullptr unless a lesson is on.
    LessonWindow* lesson();
    Workspace workspace() const { return workspace_; }
    void setWorkspace(Workspace workspace);

public Q_SLOTS:
    void resetLayout();

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    static constexpr int layout_version = 6;
    // main_window.cpp
    void buildPanels();
    void connectParts();
    void restoreLayout();
    void fitPanels();
    void stayOnScreen();
    std::vector<QDockWidget*> docks() const;
    void arrange(Workspace workspace);
    void showDocks(Workspace workspace);
    /// Which of the three workspaces it is, and which mode of it; -1: it has none.
    static std::pair<int, int> placeOf(Workspace workspace);
    /// Which state of the panels it has, and its name in the settings.
    static std::size_t stateOf(Workspace workspace);
    static QString stateName(std::size_t state);
    void showModes();
    void refreshTitle();
    void refreshPicture();
    void refreshIssueCount();
    void showIssue(const Place& where);
    void showProblem(const QString& sentence);
    void showMessage(const QString& sentence, int ms = 4000);
    // main_window_actions.cpp
    void buildActions();
    void buildFileMenu();
    void fillExamples(QMenu* menu);
    void buildEditMenu();
    void buildViewMenu();
    void addWorkspaces(QMenu* menu);
    static void addAppearances(QMenu* menu);
    void showWaterColors();
    void buildHelpMenu();
    void buildToolBar();
    void findCommand();
    void showGuide();
    void showGuidePage(const QString& page);
    void showLesson();
    QString guidePage() const;
    void about();
    // main_window_files.cpp
    bool offer(const LeftOver& left);
    void newProject();
    /// With this fabric of the library.
    void newProjectOf(int preset);
    bool takeNewProject();
    void openExample(const QString& path);
    /// Offers to delete the project's oldest runs where they take more than is preferred.
    void offerRoom();
    void chooseFile();
    bool save();
    Reply askAboutChangedFile();
    bool saveAs();
    void saveScreenshot();
    void chooseDraft();
    void exportDraft();
    void exportMesh();
    /// Asks about everything that would be lost with the project: a run in progress, changes, runs without a place of their own.
    /// A run in progress is then stopped.
    bool mayLeave();
    bool agreesToLeave();
    bool mayDiscard();
    bool mayDropRuns();
    /// Waits until runs have been copied to their project. False when the user does not wait.
    bool copiesAreDone();
    bool agreesToStopExport();
    bool agreesToEndFilms();
    void endFilms();
    void stopExport();

    Document document_;
    ColorRanges ranges_; ///< of the maps of all workspaces
    WindowQueue queue_;  ///< of the runs of all workspaces
    Recovery recovery_{document_};
    QPointer<ExportDialog> export_;
    QPointer<StartPage> start_page_;
    QPointer<PreferencesDialog> preferences_;
    QPointer<LessonWindow> lesson_;
    std::unique_ptr<DesignWorkspace> design_;
    std::unique_ptr<CompareWorkspace> compare_;
    std::unique_ptr<RunWorkspace> run_; ///< reads the runs of compare_
    Workspace workspace_ = Workspace::design;
    QByteArray states_[4];        ///< of the panels: see stateOf()
    QList<QSize> fitted_;         ///< the window's size and which panels are seen, for which the shares are
    int wide_ = 100, high_ = 100; ///< %, of what panels ask for
    int water_colors_ = 0;        ///< that are shown
    bool asking_room_ = false;
    bool closing_ = false;    ///< a question is open, or an export is ending
    bool keeps_film_ = false; ///< as the user said when asked

    Viewport* viewport_ = nullptr;
    QStackedWidget* middle_ = nullptr; ///< the fabric with its maps, runs side by side, a garment, or a study
    StudyPage* study_ = nullptr;
    CardDialog* card_ = nullptr;
    IssuesPanel* issues_ = nullptr;
    QDockWidget* issues_dock_ = nullptr;
    QToolButton* issue_count_ = nullptr;
    QueueButton* queue_button_ = nullptr;
    RecentFiles* recent_ = nullptr;
    HelpWindow* guide_ = nullptr;

    QAction* open_ = nullptr;
    QAction* save_ = nullptr;
    QAction* screenshot_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QActionGroup* workspaces_ = nullptr; ///< Design, Run, Compare
    QActionGroup* modes_ = nullptr;      ///< of Run: sample, garment; of Compare: runs, study
    std::vector<QAction*> mode_buttons_;
    Workspace comparing_ = Workspace::compare; ///< as last shown
};

} // namespace hygroloom
