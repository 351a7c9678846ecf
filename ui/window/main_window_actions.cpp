// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Menus, shortcuts and the tool bar.
#include "ui/basics/preferred_menu.h"
#include "ui/basics/typed_value.h"
#include "ui/compare/compare_view.h"
#include "ui/export/card_dialog.h"
#include "ui/lesson/lesson_window.h"
#include "ui/panels/candidates_panel.h"
#include "ui/panels/experiment_panel.h"
#include "ui/picture/view_bar.h"
#include "ui/results/live_panel.h"
#include "ui/results/queue_list.h"
#include "ui/results/water_map_view.h"
#include "ui/window/command.h"
#include "ui/window/command_palette.h"
#include "ui/window/design_workspace.h"
#include "ui/window/examples.h"
#include "ui/window/help_window.h"
#include "ui/window/main_window.h"
#include "ui/window/recent_files.h"

#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

namespace hygroloom {

namespace {

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
    menuBar()->addMenu(tr("F&abric"))->addActions(design_->candidates().fabricActions());
    run_->fillExperimentMenu(menuBar()->addMenu(tr("E&xperiment")));
    QMenu* garment = menuBar()->addMenu(tr("&Garment"));
    connect(addCommand(garment, {}, tr("Show the Garment"), {}, tr("Cut a garment from fabrics, and wear it.")), &QAction::triggered, this,
            [this] { setWorkspace(Workspace::garment); });
    garment->addSeparator();
    run_->garment().fillMenu(garment);
    buildHelpMenu();
    buildToolBar();
}

void MainWindow::buildFileMenu()
{
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    connect(addCommand(menu, {}, tr("&New Project"), QKeySequence::New, tr("Start with a plain-weave fabric and one droplet.")),
            &QAction::triggered, this, &MainWindow::newProject);
    connect(addCommand(menu, {}, tr("S&tart Page…"), {}, tr("Choose among recent projects, examples and fabrics.")), &QAction::triggered,
            this, &MainWindow::showStartPage);
    open_ = addCommand(menu, "open", tr("&Open…"), QKeySequence::Open, tr("Open a project or a recording."));
    connect(open_, &QAction::triggered, this, &MainWindow::chooseFile);
    recent_ = new RecentFiles(*menu->addMenu(tr("Open &Recent")), this);
    connect(recent_, &RecentFiles::chosen, this, &MainWindow::openFile);
    fillExamples(menu->addMenu(tr("&Examples")));
    menu->addSeparator();
    save_ = addCommand(menu, "save", tr("&Save"), QKeySequence::Save, tr("Save the project."));
    connect(save_, &QAction::triggered, this, &MainWindow::save);
    connect(addCommand(menu, {}, tr("Save &As…"), QKeySequence("Ctrl+Shift+S"), tr("Save the project under another name.")),
            &QAction::triggered, this, &MainWindow::saveAs);
    menu->addSeparator();
    connect(addCommand(menu, "import", tr("&Import Draft…"), QKeySequence("Ctrl+I"),
                       tr("Add a fabric from a WIF draft, a text grid or a picture.")),
            &QAction::triggered, this, &MainWindow::chooseDraft);
    connect(addCommand(menu, {}, tr("E&xport Draft (WIF)…"), {}, tr("Write the selected fabric's draft for other weaving programs.")),
            &QAction::triggered, this, &MainWindow::exportDraft);
    connect(addCommand(menu, {}, tr("Export &Mesh…"), QKeySequence("Ctrl+E"),
                       tr("Write yarns or fibres for modelling and rendering programs.")),
            &QAction::triggered, this, &MainWindow::exportMesh);
    card_ = new CardDialog(document_, queue_, this);
    connect(&card_->file(), &CardExport::making, this, [this](const QString& sentence) { showMessage(sentence); });
    connect(&card_->file(), &CardExport::written, this, [this](const QString& sentence) { showMessage(sentence); });
    connect(&card_->file(), &CardExport::failed, this, &MainWindow::showProblem);
    connect(
        addCommand(menu, {}, tr("Technical Car&d…"), {}, tr("The laboratory's numbers of the selected fabric, and its card as a page.")),
        &QAction::triggered, this, [this] {
            commitTypedValue(*this);
            card_->show();
            card_->raise();
        });
    menu->addSeparator();
    run_->fillFileMenu(menu);
    screenshot_ = addCommand(menu, "camera", tr("Save &Picture…"), QKeySequence("Ctrl+Shift+P"),
                             tr("Save the fabric or garment as it is seen, or in Compare the maps side by side, as a PNG file."));
    connect(screenshot_, &QAction::triggered, this, &MainWindow::saveScreenshot);
    menu->addSeparator();
    connect(addCommand(menu, {}, tr("&Quit"), QKeySequence::Quit, tr("Close the window.")), &QAction::triggered, this, &QWidget::close);
}

void MainWindow::fillExamples(QMenu* menu)
{
    const auto fill = [this](QMenu* into, const QDir& folder) {
        const QStringList files = folder.entryList({"*.hygro"}, QDir::Files, QDir::Name);
        for (const QString& file : files) {
            QAction* action = into->addAction(QFileInfo(file).completeBaseName().replace('-', ' '));
            connect(action, &QAction::triggered, this, [this, path = folder.filePath(file)] { openExample(path); });
        }
        into->setEnabled(!files.isEmpty());
    };
    if (examplesFolder().isEmpty()) {
        menu->setEnabled(false);
        return;
    }
    fill(menu, QDir(examplesFolder()));
    QMenu* paper = menu->addMenu(tr("&Mao et al.: Hygroscopicity of Woven Textiles"));
    paper->menuAction()->setStatusTip(tr("The experiments of Mao et al., “Yarn-Level Simulation of Hygroscopicity of Woven Textiles”."));
    fill(paper, QDir(examplesFolder() + "/paper"));
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
    menu->addSeparator();
    QAction* choose = addCommand(menu, {}, tr("&Preferences…"), QKeySequence("Ctrl+,"), tr("Units, look, mouse, autosave, runs, devices."));
    choose->setMenuRole(QAction::PreferencesRole);
    connect(choose, &QAction::triggered, this, &MainWindow::showPreferences);
}

void MainWindow::buildViewMenu()
{
    QMenu* menu = menuBar()->addMenu(tr("&View"));
    addWorkspaces(menu);
    connect(addCommand(menu, {}, tr("&Lesson"), QKeySequence("Ctrl+6"), tr("Drop water on cloths with a class, on the whole screen.")),
            &QAction::triggered, this, &MainWindow::showLesson);
    menu->addSeparator();
    viewport_->bar().fillMenu(menu);
    menu->addSeparator();
    addChoices(menu->addMenu(tr("Colour &Range")), "view/range",
               {tr("Full: 0 to 100 %"), tr("Follow the run"), tr("Follow the time shown")},
               [this](int i) { viewport_->setWaterRange(static_cast<WaterRange>(i)); });
    QAction* keep = addCommand(menu, {}, tr("Keep the Colours of Maps"), {},
                               tr("The ends of the colours stay as they are, in all workspaces, whatever is shown."));
    keep->setCheckable(true);
    connect(keep, &QAction::toggled, &ranges_, &ColorRanges::setKept);
    connect(&ranges_, &ColorRanges::changed, keep, [this, keep] { keep->setChecked(ranges_.kept()); });
    connect(
        addCommand(menu, {}, tr("Fit the Colours of Maps"), {}, tr("The colours end where the maps that are shown do, in all workspaces.")),
        &QAction::triggered, &ranges_, &ColorRanges::fit);
    addPreferred(*menu->addMenu(tr("&Water Colours")), &Preferences::water_colors, waterColorNames());
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &MainWindow::showWaterColors);
    showWaterColors();
    addAppearances(menu->addMenu(tr("&Appearance")));
    menu->addSeparator();
    connect(addCommand(menu, {}, tr("Queue of Runs"), QKeySequence("Ctrl+Shift+R"), tr("Show what runs, what waits and why.")),
            &QAction::triggered, queue_button_, &QueueButton::openList);
    QMenu* panels = menu->addMenu(tr("&Panels"));
    for (QDockWidget* dock : docks()) { panels->addAction(dock->toggleViewAction()); }
    connect(addCommand(menu, {}, tr("R&eset Layout"), {}, tr("Restore the original arrangement of the panels.")), &QAction::triggered, this,
            &MainWindow::resetLayout);
}

void MainWindow::showWaterColors()
{
    const int chosen = preferences().water_colors;
    if (std::exchange(water_colors_, chosen) == chosen) { return; }
    const auto colors = static_cast<WaterColors>(chosen);
    viewport_->setWaterColors(colors);
    run_->sample().maps().setWaterColors(colors);
    compare_->view().setWaterColors(colors);
    design_->live().setWaterColors(colors);
}

void MainWindow::addWorkspaces(QMenu* menu)
{
    workspaces_ = new QActionGroup(this);
    modes_ = new QActionGroup(this);
    modes_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional); // Design has none
    const auto add = [&](QActionGroup* group, const QString& text, const QString& name, const QKeySequence& keys, const QString& tip,
                         const auto& which) {
        QAction* action = addCommand(menu, {}, text, keys, tip);
        action->setIconText(name); // on its button
        action->setCheckable(true);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, which] {
            setWorkspace(which());
            showModes(); // a click on what is shown lets nothing go
        });
    };
    add(workspaces_, tr("&Design"), tr("Design"), QKeySequence("Ctrl+1"), tr("Edit the fabric."), [] { return Workspace::design; });
    add(workspaces_, tr("Run, as Last Shown"), tr("Run"), {}, tr("Run an experiment on a sample or a garment."),
        [this] { return run_->subject() == Subject::garment ? Workspace::garment : Workspace::simulate; });
    add(workspaces_, tr("Compare, as Last Shown"), tr("Compare"), {}, tr("Compare runs of the same experiment, or study many points."),
        [this] { return comparing_; });
    menu->addSeparator();
    add(modes_, tr("Run: Sample"), tr("Sample"), QKeySequence("Ctrl+2"), tr("Run an experiment on a sample of the fabric."),
        [] { return Workspace::simulate; });
    add(modes_, tr("Run: &Garment"), tr("Garment"), QKeySequence("Ctrl+4"), tr("Cut a garment from fabrics, and wear it."),
        [] { return Workspace::garment; });
    add(modes_, tr("Co&mpare: Runs"), tr("Runs"), QKeySequence("Ctrl+3"), tr("Compare runs of the same experiment side by side."),
        [] { return Workspace::compare; });
    add(modes_, tr("Compare: S&tudy"), tr("Study"), QKeySequence("Ctrl+5"), tr("Run many points, and see what matters."),
        [] { return Workspace::study; });
    menu->addSeparator();
}

/// Which workspace is shown, and which of its two modes.
void MainWindow::showModes()
{
    const auto [workspace, mode] = placeOf(workspace_);
    if (workspace_ == Workspace::compare || workspace_ == Workspace::study) { comparing_ = workspace_; }
    workspaces_->actions().at(workspace)->setChecked(true);
    for (int i = 0; i < modes_->actions().size(); ++i) {
        modes_->actions().at(i)->setChecked(i == mode);
        if (!mode_buttons_.empty()) { mode_buttons_[static_cast<std::size_t>(i)]->setVisible(mode >= 0 && i / 2 == mode / 2); }
    }
    for (const QAction* action : workspaces_->actions() + modes_->actions()) // the sentence of the command that led here
        if (statusBar()->currentMessage() == action->statusTip()) { statusBar()->clearMessage(); }
}

void MainWindow::addAppearances(QMenu* menu)
{
    auto* group = new QActionGroup(menu);
    const std::pair<Appearance, QString> looks[] = {{Appearance::desktop, tr("As the &Desktop")},
                                                    {Appearance::light, tr("&Light")},
                                                    {Appearance::dark, tr("D&ark")},
                                                    {Appearance::contrast, tr("High &Contrast")}};
    for (const auto& [look, name] : looks) {
        QAction* action = menu->addAction(name);
        action->setCheckable(true);
        group->addAction(action);
        connect(menu, &QMenu::aboutToShow, action, [action, chosen = look] { action->setChecked(savedAppearance() == chosen); });
        action->setChecked(savedAppearance() == look);
        connect(action, &QAction::triggered, action, [chosen = look] {
            saveAppearance(chosen);
            applyAppearance(chosen);
        });
    }
}

void MainWindow::buildHelpMenu()
{
    QMenu* menu = menuBar()->addMenu(tr("&Help"));
    connect(addCommand(menu, {}, tr("&User's Guide"), QKeySequence("F1"), tr("Explain this workspace or experiment.")), &QAction::triggered,
            this, &MainWindow::showGuide);
    connect(addCommand(menu, {}, tr("&Find Command…"), QKeySequence("Ctrl+K"), tr("Find a command by letters of its name.")),
            &QAction::triggered, this, &MainWindow::findCommand);
    menu->addSeparator();
    connect(addCommand(menu, {}, tr("&About Hygroloom"), {}, tr("Version and licence.")), &QAction::triggered, this, &MainWindow::about);
    connect(addCommand(menu, {}, tr("About &Qt"), {}, tr("The toolkit of this program.")), &QAction::triggered, qApp,
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
    const auto& run = run_->actions();
    bar->addActions({run.start, run.pause, run.stop});
    auto* gap = new QWidget;
    gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(gap);
    const auto addButton = [bar](QAction* action, const QString& name) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setAutoRaise(true);
        button->setMinimumWidth(84);
        button->setAccessibleName(name.arg(action->iconText()));
        return bar->addWidget(button);
    };
    for (QAction* action : modes_->actions()) { mode_buttons_.push_back(addButton(action, tr("Show %1"))); }
    bar->addSeparator();
    for (QAction* action : workspaces_->actions()) { addButton(action, tr("Workspace %1")); }
    showModes();
    for (QAction* action : bar->actions()) {
        if (QWidget* widget = bar->widgetForAction(action); widget && widget->accessibleName().isEmpty()) {
            widget->setAccessibleName(action->iconText());
        }
    }
}

void MainWindow::findCommand()
{
    CommandPalette palette(*menuBar(), this);
    if (palette.exec() == QDialog::Accepted && palette.chosen()) { palette.chosen()->trigger(); }
}

void MainWindow::showGuide() { showGuidePage(guidePage()); } // of the field that has the focus now

void MainWindow::showGuidePage(const QString& page)
{
    if (!guide_) { guide_ = new HelpWindow(this); }
    guide_->showPage(page);
    guide_->show();
    guide_->raise();
    guide_->activateWindow();
}

LessonWindow* MainWindow::lesson() { return lesson_; }

/// It has the whole screen until Esc.
void MainWindow::showLesson()
{
    if (!lesson_) {
        lesson_ = new LessonWindow(document_, this);
        lesson_->setAttribute(Qt::WA_DeleteOnClose);
        connect(lesson_, &LessonWindow::helpWanted, this, [this] { showGuidePage("lesson"); });
    }
    lesson_->showFullScreen();
    lesson_->activateWindow();
}

/// The experiment's type while one of its fields has the focus, else the workspace.
QString MainWindow::guidePage() const
{
    const QWidget* focus = QApplication::focusWidget() ? QApplication::focusWidget() : focusWidget();
    const Experiment* experiment = document_.experiment();
    if (experiment && focus && run_->sample().experiment().isAncestorOf(focus)) { return name_of(experiment->type); }
    const char* pages[] = {"design", "simulate", "compare", "garment", "studies"};
    return pages[static_cast<int>(workspace_)];
}

void MainWindow::about()
{
    QMessageBox box(this);
    box.setWindowTitle(tr("About Hygroloom"));
    box.setIconPixmap(themedIcon("hygroloom").pixmap(64, 64));
    box.setText("<h3>Hygroloom " + QApplication::applicationVersion() + "</h3><p>" +
                tr("Simulates how woven fabrics take up, spread and dry water.") + "</p>");
    box.setInformativeText(
        "<p>" +
        tr("This program is free software under the GNU General Public License, version 3 or later, with an additional permission "
           "to link with the CUDA runtime. It comes with no warranty, to the extent the law permits.") +
        "</p>");
    box.exec();
}

} // namespace hygroloom
