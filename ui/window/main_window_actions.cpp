// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Menus, shortcuts and the tool bar.
#include "ui/basics/appearance.h"
#include "ui/basics/command_palette.h"
#include "ui/basics/examples.h"
#include "ui/panels/candidates_panel.h"
#include "ui/panels/experiment_panel.h"
#include "ui/picture/view_bar.h"
#include "ui/results/compare_view.h"
#include "ui/results/results_panel.h"
#include "ui/results/simulation_panel.h"
#include "ui/results/timeline.h"
#include "ui/results/water_map_view.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

namespace hygroloom {

namespace {

QAction* addCommand(QMenu* menu, const QString& icon, const QString& text, const QKeySequence& shortcut, const QString& tip)
{
    auto* action = icon.isEmpty() ? menu->addAction(text) : menu->addAction(themedIcon(icon), text);
    action->setShortcut(shortcut);
    action->setStatusTip(tip);
    return action;
}

/// A menu of choices of which one holds; the choice is remembered under key.
void addChoices(QMenu* menu, const QString& key, const QStringList& names, const std::function<void(int)>& choose)
{
    auto* group = new QActionGroup(menu);
    const int saved = QSettings().value(key, 0).toInt();
    for (int i = 0; i < names.size(); ++i) {
        QAction* action = menu->addAction(names[i]);
        action->setCheckable(true);
        action->setChecked(i == saved);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, menu, [key, i, choose] {
            QSettings().setValue(key, i);
            choose(i);
        });
    }
    if (saved > 0 && saved < names.size()) { choose(saved); }
}

} // namespace

void MainWindow::buildActions()
{
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    buildFabricMenu();
    buildExperimentMenu();
    buildHelpMenu();
    buildToolBar();
    refreshRecentFiles();
}

void MainWindow::buildFileMenu()
{
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    connect(addCommand(menu, {}, tr("&New Project"), QKeySequence::New, tr("Begin with a plain fabric and one drop.")), &QAction::triggered,
            this, &MainWindow::newProject);
    open_ = addCommand(menu, "open", tr("&Open…"), QKeySequence::Open, tr("Open a project or a recording."));
    connect(open_, &QAction::triggered, this, &MainWindow::chooseFile);
    recent_ = menu->addMenu(tr("Open &Recent"));
    recent_->setToolTipsVisible(true);
    QMenu* examples = menu->addMenu(tr("&Examples"));
    const auto fill = [this](QMenu* into, const QDir& folder) {
        const QStringList files = folder.entryList({"*.hygro"}, QDir::Files, QDir::Name);
        for (const QString& file : files) {
            QAction* action = into->addAction(QFileInfo(file).completeBaseName().replace('-', ' '));
            connect(action, &QAction::triggered, this, [this, path = folder.filePath(file)] {
                if (mayDiscard() && document_.openExample(path) && !run_.running()) { playback_.clear(); }
            });
        }
        into->setEnabled(!files.isEmpty());
    };
    if (!examplesFolder().isEmpty()) {
        fill(examples, QDir(examplesFolder()));
        fill(examples->addMenu(tr("The &Paper's Experiments")), QDir(examplesFolder() + "/paper"));
    } else {
        examples->setEnabled(false);
    }
    menu->addSeparator();
    save_ = addCommand(menu, "save", tr("&Save"), QKeySequence::Save, tr("Save the project."));
    connect(save_, &QAction::triggered, this, &MainWindow::save);
    connect(addCommand(menu, {}, tr("Save &As…"), QKeySequence("Ctrl+Shift+S"), tr("Save the project in another place.")),
            &QAction::triggered, this, &MainWindow::saveAs);
    menu->addSeparator();
    connect(addCommand(menu, "import", tr("&Import Draft…"), QKeySequence("Ctrl+I"),
                       tr("Add a fabric from a WIF draft, a text grid or a picture.")),
            &QAction::triggered, this, &MainWindow::chooseDraft);
    connect(addCommand(menu, {}, tr("E&xport Draft (WIF)…"), {}, tr("Write the chosen fabric's draft for other weaving programs.")),
            &QAction::triggered, this, &MainWindow::exportDraft);
    connect(addCommand(menu, {}, tr("Export &Mesh…"), QKeySequence("Ctrl+E"),
                       tr("Write yarns or fibres for modelling and rendering programs.")),
            &QAction::triggered, this, &MainWindow::exportMesh);
    menu->addSeparator();
    save_recording_ = addCommand(menu, {}, tr("Save Re&cording As…"), {}, tr("Keep the run that is shown."));
    connect(save_recording_, &QAction::triggered, this, &MainWindow::saveRecordingAs);
    screenshot_ =
        addCommand(menu, "camera", tr("Save &Picture…"), QKeySequence("Ctrl+Shift+P"), tr("Save the picture of the fabric as PNG."));
    connect(screenshot_, &QAction::triggered, this, &MainWindow::saveScreenshot);
    menu->addSeparator();
    connect(addCommand(menu, {}, tr("&Quit"), QKeySequence::Quit, tr("Close the window.")), &QAction::triggered, this, &QWidget::close);
}

void MainWindow::buildEditMenu()
{
    QMenu* menu = menuBar()->addMenu(tr("&Edit"));
    undo_ = document_.history()->createUndoAction(this, tr("&Undo"));
    undo_->setShortcut(QKeySequence::Undo);
    undo_->setIcon(themedIcon("undo"));
    redo_ = document_.history()->createRedoAction(this, tr("&Redo"));
    redo_->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    redo_->setIcon(themedIcon("redo"));
    menu->addActions({undo_, redo_});
}

void MainWindow::buildViewMenu()
{
    QMenu* menu = menuBar()->addMenu(tr("&View"));
    workspaces_ = new QActionGroup(this);
    QAction* design = addCommand(menu, {}, tr("&Design"), QKeySequence("Ctrl+1"), tr("Edit the fabric."));
    QAction* simulate = addCommand(menu, {}, tr("&Simulate"), QKeySequence("Ctrl+2"), tr("Run an experiment on the fabric."));
    QAction* compare = addCommand(menu, {}, tr("Co&mpare"), QKeySequence("Ctrl+3"), tr("Put runs of the same experiment side by side."));
    for (QAction* action : {design, simulate, compare}) {
        action->setCheckable(true);
        workspaces_->addAction(action);
    }
    design->setChecked(true);
    connect(design, &QAction::triggered, this, [this] { setWorkspace(Workspace::design); });
    connect(simulate, &QAction::triggered, this, [this] { setWorkspace(Workspace::simulate); });
    connect(compare, &QAction::triggered, this, [this] { setWorkspace(Workspace::compare); });
    menu->addSeparator();
    viewport_->bar().fillMenu(menu);
    menu->addSeparator();
    addChoices(menu->addMenu(tr("Colour &Range")), "view/range", {tr("Full: 0 to 100 %"), tr("Follow the run"), tr("Follow the moment")},
               [this](int i) { viewport_->setWaterRange(static_cast<WaterRange>(i)); });
    addChoices(menu->addMenu(tr("&Water Colours")), "view/colors", {tr("Blue"), tr("Cividis")}, [this](int i) {
        viewport_->setWaterColors(static_cast<WaterColors>(i));
        maps_->setWaterColors(static_cast<WaterColors>(i));
        compare_->setWaterColors(static_cast<WaterColors>(i));
    });
    QMenu* appearance = menu->addMenu(tr("&Appearance"));
    auto* group = new QActionGroup(appearance);
    const std::pair<Appearance, QString> looks[] = {{Appearance::desktop, tr("As the &Desktop")},
                                                    {Appearance::light, tr("&Light")},
                                                    {Appearance::dark, tr("D&ark")},
                                                    {Appearance::contrast, tr("High &Contrast")}};
    for (const auto& [look, name] : looks) {
        QAction* action = appearance->addAction(name);
        action->setCheckable(true);
        action->setChecked(savedAppearance() == look);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [chosen = look] {
            saveAppearance(chosen);
            applyAppearance(chosen);
        });
    }
    menu->addSeparator();
    QMenu* docks = menu->addMenu(tr("&Panels"));
    for (QDockWidget* dock : {candidates_dock_, weave_dock_, draft_dock_, fabric_dock_, experiment_dock_, simulation_dock_, timeline_dock_,
                              results_dock_, issues_dock_}) {
        docks->addAction(dock->toggleViewAction());
    }
    connect(addCommand(menu, {}, tr("R&eset Layout"), {}, tr("Put the panels back where they were at first.")), &QAction::triggered, this,
            &MainWindow::resetLayout);
}

void MainWindow::buildFabricMenu()
{
    QMenu* menu = menuBar()->addMenu(tr("F&abric"));
    menu->addActions(candidates_->fabricActions());
}

void MainWindow::buildExperimentMenu()
{
    QMenu* menu = menuBar()->addMenu(tr("E&xperiment"));
    start_ = addCommand(menu, "run", tr("&Run"), QKeySequence("Ctrl+R"), tr("Run the experiment on the chosen fabric."));
    connect(start_, &QAction::triggered, this, &MainWindow::startRun);
    pause_ = addCommand(menu, "pause", tr("&Pause"), {}, tr("Hold the run, or let it go on."));
    connect(pause_, &QAction::triggered, this, [this] { run_.setPaused(!run_.paused()); });
    stop_ = addCommand(menu, "stop", tr("S&top"), {}, tr("Stop the run; what was simulated so far stays."));
    connect(stop_, &QAction::triggered, &run_, &SimulationRun::cancel);
    plan_ = addCommand(menu, "plan", tr("&What Is Modelled, and Why…"), {},
                       tr("Which physics the next run takes into account, and for what reason."));
    connect(plan_, &QAction::triggered, simulation_panel_, &SimulationPanel::showPlan);
    shown_plan_ = addCommand(menu, {}, tr("What W&as Modelled, and Why…"), {},
                             tr("Which physics the run that is shown took into account, and for what reason."));
    connect(shown_plan_, &QAction::triggered, results_, &ResultsPanel::showPlan);
    menu->addSeparator();
    play_ = addCommand(menu, {}, tr("P&lay or Pause the Recording") + "\t" + tr("Space"), {}, tr("Show the run as it went."));
    connect(play_, &QAction::triggered, timeline_, &Timeline::togglePlaying);
    take_design_ =
        addCommand(menu, {}, tr("Open the &Design of the Recording"), {}, tr("Edit the design that the shown run was made from."));
    connect(take_design_, &QAction::triggered, this, [this] {
        if (playback_.run() && mayDiscard()) {
            document_.take(playback_.run()->design, tr("Design of the recording"));
            chooseWhatRan();
        }
    });
    menu->addSeparator();
    connect(addCommand(menu, "add", tr("&Add Droplet"), {}, tr("Add a droplet to the experiment.")), &QAction::triggered, experiment_panel_,
            &ExperimentPanel::addDroplet);
    connect(addCommand(menu, {}, tr("Add &Experiment"), {}, tr("Add a copy of the experiment.")), &QAction::triggered, experiment_panel_,
            &ExperimentPanel::addExperiment);
}

void MainWindow::buildHelpMenu()
{
    QMenu* menu = menuBar()->addMenu(tr("&Help"));
    connect(addCommand(menu, {}, tr("&Find Command…"), QKeySequence("Ctrl+K"), tr("Any command by a few letters of its name.")),
            &QAction::triggered, this, &MainWindow::findCommand);
    menu->addSeparator();
    connect(addCommand(menu, {}, tr("&About Hygroloom"), {}, tr("Version and licence.")), &QAction::triggered, this, &MainWindow::about);
    connect(addCommand(menu, {}, tr("About &Qt"), {}, tr("The toolkit of this window.")), &QAction::triggered, qApp,
            &QApplication::aboutQt);
}

void MainWindow::buildToolBar()
{
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName("tools");
    bar->setMovable(false);
    bar->setIconSize({20, 20});
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->addActions({open_, save_});
    bar->addSeparator();
    bar->addActions({undo_, redo_});
    bar->addSeparator();
    bar->addActions({viewport_->bar().fitAction(), screenshot_});
    bar->addSeparator();
    bar->addActions({start_, pause_, stop_});
    auto* gap = new QWidget;
    gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(gap);
    for (QAction* action : workspaces_->actions()) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setAutoRaise(true);
        button->setMinimumWidth(84);
        button->setAccessibleName(tr("Workspace %1").arg(action->iconText()));
        bar->addWidget(button);
    }
    for (QAction* action : bar->actions()) {
        if (QWidget* widget = bar->widgetForAction(action); widget && widget->accessibleName().isEmpty()) {
            widget->setAccessibleName(action->iconText());
        }
    }
}

void MainWindow::refreshActions()
{
    if (!take_design_) { return; }
    const bool running = run_.running();
    start_->setEnabled(simulation_panel_->canRun());
    pause_->setEnabled(running);
    pause_->setText(run_.paused() ? tr("&Go On") : tr("&Pause"));
    pause_->setIcon(themedIcon(run_.paused() ? "run" : "pause"));
    stop_->setEnabled(running);
    save_recording_->setEnabled(playback_.run() && !playback_.live() && !playback_.path().isEmpty());
    take_design_->setEnabled(playback_.run() != nullptr);
    play_->setEnabled(playback_.run() != nullptr);
    shown_plan_->setEnabled(playback_.run() != nullptr);
}

void MainWindow::findCommand()
{
    CommandPalette palette(*menuBar(), this);
    if (palette.exec() == QDialog::Accepted && palette.chosen()) { palette.chosen()->trigger(); }
}

void MainWindow::about()
{
    QMessageBox box(this);
    box.setWindowTitle(tr("About Hygroloom"));
    box.setIconPixmap(themedIcon("hygroloom").pixmap(64, 64));
    box.setText("<h3>Hygroloom " + QApplication::applicationVersion() + "</h3><p>" +
                tr("Simulates how a woven fabric takes up a drop of water.") + "</p>");
    box.setInformativeText(
        "<p>" +
        tr("This program is free software under the GNU General Public License, version 3 or later, with an additional permission "
           "to link with the CUDA runtime. It comes with no warranty, to the extent the law permits.") +
        "</p>");
    box.exec();
}

} // namespace hygroloom
