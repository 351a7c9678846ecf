// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Panels and commands. Runs, recordings and what is written: garment_workspace_runs.cpp.
#include "ui/window/garment_workspace.h"

#include "ui/basics/appearance.h"
#include "ui/basics/core_words.h"
#include "ui/basics/typed_value.h"
#include "ui/compare/run_list.h"
#include "ui/garment/fit_form.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_panel.h"
#include "ui/garment/garment_view.h"
#include "ui/garment/panel_table.h"
#include "ui/garment/parts_table.h"
#include "ui/garment/run_form.h"
#include "ui/garment/wear_form.h"
#include "ui/garment/zones_form.h"
#include "ui/results/chart.h"
#include "ui/results/timeline.h"
#include "ui/window/command.h"
#include "ui/window/docks.h"

#include <QVBoxLayout>

namespace hygroloom {
GarmentWorkspace::GarmentWorkspace(Document& document, RunHistory& history, ProjectRuns& runs, WindowQueue& queue, QMainWindow& window)
    : document_(document), history_(history), runs_(runs), window_(window), choice_(document), run_(queue),
      garment_(new GarmentPanel(choice_)), fit_(new FitForm(choice_)), wear_(new WearForm(choice_)), form_(new RunForm(choice_, run_)),
      timeline_(new Timeline(playback_)), chart_(new Chart(playback_)), parts_(new PartsTable(playback_)), list_(new RunList(history)),
      view_(new GarmentView(choice_, playback_))
{
    auto* time = new QWidget;
    auto* layout = new QVBoxLayout(time);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(timeline_);
    layout->addWidget(chart_, 1);
    docks_.garment = makeDock(window, "garment", tr("Garment"), garment_);
    docks_.fit = makeDock(window, "garment fit", tr("Gaps and Seams"), fit_);
    docks_.wear = makeDock(window, "wear", tr("Wear"), wear_);
    docks_.run = makeDock(window, "garment run", tr("Wear Run"), form_);
    docks_.time = makeDock(window, "garment time", tr("Time of Wear"), time);
    docks_.parts = makeDock(window, "garment parts", tr("Panels and Zones"), parts_);
    docks_.runs = makeDock(window, "garment runs", tr("Garment Runs"), list_);
    connect(view_, &GarmentView::panelClicked, this, [this](int panel) {
        view_->setChosenPanel(panel);
        garment_->panels().choosePanel(panel);
    });
    connect(&fit_->ownZones(), &ZonesForm::drawingWanted, view_, &GarmentView::setOutlining);
    connect(view_, &GarmentView::outliningEnded, &fit_->ownZones(), [this] { fit_->ownZones().setDrawing(false); });
    connect(view_, &GarmentView::designRequested, this, &GarmentWorkspace::designRequested);
    connect(&garment_->panels(), &PanelTable::panelChosen, view_, &GarmentView::setChosenPanel);
    connect(garment_, &GarmentPanel::problemFound, this, &GarmentWorkspace::problemFound);
    connect(&document_, &Document::replaced, this, &GarmentWorkspace::clearResults);
    connectRun();
}

GarmentWorkspace::~GarmentWorkspace()
{
    run_.disconnect(this); // it reports its end when the panels are half gone
    run_.disconnect(form_);
    run_.cancel();
}

void GarmentWorkspace::fillMenu(QMenu* menu)
{
    for (const std::string& kind : built_in_garments()) {
        const QString name = coreWord(kind);
        connect(
            addCommand(menu, "add", tr("Add Built-in %1").arg(name), {}, tr("Add a %1 and an experiment in which it is worn.").arg(name)),
            &QAction::triggered, this, [this, kind] { choice_.setGarmentIndex(addBuiltInGarment(document_, kind)); });
    }
    connect(addCommand(menu, {}, tr("Add Garment from a &File…"), {}, tr("Add a sewing pattern, or a mesh with flat coordinates.")),
            &QAction::triggered, garment_, &GarmentPanel::addFile);
    remove_ = addCommand(menu, "delete", tr("Remove &Garment"), {}, {});
    connect(remove_, &QAction::triggered, garment_, &GarmentPanel::removeChosen);
    menu->addSeparator();
    menu->setToolTipsVisible(true); // why a command cannot be chosen
    actions_.start = addCommand(menu, "run", tr("&Run the Wear Experiment"), QKeySequence("Ctrl+R"), {});
    connect(actions_.start, &QAction::triggered, this, [this] {
        commitTypedValue(window_);
        form_->start();
    });
    actions_.pause = addCommand(menu, "pause", tr("&Pause the Wear Experiment"), {}, tr("Pause or resume the run."));
    connect(actions_.pause, &QAction::triggered, this, [this] { run_.setPaused(!run_.paused()); });
    actions_.stop =
        addCommand(menu, "stop", tr("S&top the Wear Experiment"), {}, tr("Stop the run, and say whether to keep what it recorded."));
    connect(actions_.stop, &QAction::triggered, this, &GarmentWorkspace::stopByHand);
    keep_ = addCommand(menu, {}, tr("&Keep This Run as A"), {}, tr("Compare the next runs with this one."));
    connect(keep_, &QAction::triggered, &playback_, &WearPlayback::keepAsA);
    drop_ = addCommand(menu, {}, tr("&Drop A"), {}, tr("Show the newest run alone."));
    connect(drop_, &QAction::triggered, &playback_, &WearPlayback::dropA);
    steps_ = addCommand(menu, {}, tr("S&teps of the Colours…"), {}, tr("Set where each of the eight colours ends."));
    connect(steps_, &QAction::triggered, view_, &GarmentView::editSteps);
    menu->addSeparator();
    open_ = addCommand(menu, "open", tr("&Open Recording of a Garment…"), {}, tr("Show a recorded run of a garment."));
    connect(open_, &QAction::triggered, this, &GarmentWorkspace::chooseRecording);
    take_ = addCommand(menu, {}, tr("Open the &Design of the Recording of a Garment"), {},
                       tr("Edit the design from which the run on screen was made."));
    connect(take_, &QAction::triggered, this, &GarmentWorkspace::designRequested);
    save_run_ = addCommand(menu, {}, tr("Save R&un As…"), {}, tr("Write the run that is shown to another recording."));
    connect(save_run_, &QAction::triggered, this, &GarmentWorkspace::chooseRunFile);
    save_a_ = addCommand(menu, {}, tr("Save &A As…"), {}, tr("Write the run that is kept as A to another recording."));
    connect(save_a_, &QAction::triggered, this, &GarmentWorkspace::chooseFileOfA);
    save_map_ = addCommand(menu, {}, tr("Save &Map…"), {},
                           tr("Write pictures and textures of the panels, a table of cells, OBJ and GLB of the time shown to a folder."));
    connect(save_map_, &QAction::triggered, this, &GarmentWorkspace::saveMap);
    save_report_ = addCommand(menu, {}, tr("Save Rep&ort of the Garment…"), {},
                              tr("Save numbers, maps at each quarter of the run and curves, as PDF or web page."));
    connect(save_report_, &QAction::triggered, this, &GarmentWorkspace::saveReport);
    copy_ = addCommand(menu, "copy", tr("&Copy Numbers as CSV"), {}, tr("Copy the numbers per panel and zone."));
    connect(copy_, &QAction::triggered, parts_, &PartsTable::copy);
    refreshActions();
}

void GarmentWorkspace::setShown(bool shown)
{
    if (!actions_.start) { return; }
    actions_.start->setVisible(shown);
    actions_.pause->setVisible(shown);
    actions_.stop->setVisible(shown);
}

void GarmentWorkspace::refreshActions()
{
    if (!actions_.start) { return; }
    const bool running = run_.running(), any = playback_.frame() != nullptr;
    QString why_not;
    const bool can = form_->canRun(&why_not);
    offerCommand(actions_.start, can, tr("Run the experiment on this garment."), why_not);
    offerCommand(remove_, choice_.garment() != nullptr, tr("Remove the chosen garment and its experiments."),
                 tr("There is no garment to remove."));
    actions_.pause->setEnabled(run_.computing());
    actions_.pause->setText(run_.paused() ? tr("Resume the Wear Ex&periment") : tr("&Pause the Wear Experiment"));
    actions_.pause->setIcon(themedIcon(run_.paused() ? "run" : "pause"));
    actions_.stop->setEnabled(running);
    open_->setEnabled(!running);
    save_map_->setEnabled(any);
    save_report_->setEnabled(any && !running);
    steps_->setEnabled(any);
    take_->setEnabled(any && !running);
    save_run_->setEnabled(any && !running);
    copy_->setEnabled(any);
    keep_->setEnabled(any && !running);
    save_a_->setEnabled(playback_.kept() != nullptr);
    drop_->setEnabled(playback_.kept() != nullptr);
}

bool GarmentWorkspace::pressKey(int key)
{
    switch (key) {
    case Qt::Key_Space: timeline_->togglePlaying(); return true;
    case Qt::Key_Left: timeline_->step(-1); return true;
    case Qt::Key_Right: timeline_->step(1); return true;
    default: return view_->pressKey(key);
    }
}

void GarmentWorkspace::showIssue(bool of_garment, int index)
{
    if (of_garment) {
        choice_.setGarmentIndex(index);
        reveal(docks_.garment);
        return;
    }
    const Design& design = *document_.design();
    for (std::size_t k = 0; k < design.garments.size(); ++k) {
        if (design.garments[k].name == design.wears[static_cast<std::size_t>(index)].garment) {
            choice_.setGarmentIndex(static_cast<int>(k));
        }
    }
    choice_.setWearIndex(index);
    reveal(docks_.wear);
}

} // namespace hygroloom
