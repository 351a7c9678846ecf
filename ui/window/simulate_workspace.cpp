// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Panels, commands and the picture. Runs and recordings: simulate_workspace_runs.cpp.
#include "ui/window/simulate_workspace.h"

#include "ui/basics/film.h"
#include "ui/basics/typed_value.h"
#include "ui/document/document.h"
#include "ui/panels/droplet_section.h"
#include "ui/panels/experiment_panel.h"
#include "ui/picture/viewport.h"
#include "ui/results/calibrate_dialog.h"
#include "ui/results/chart.h"
#include "ui/results/results_panel.h"
#include "ui/results/run_history.h"
#include "ui/results/simulation_panel.h"
#include "ui/results/timeline.h"
#include "ui/results/water_map_view.h"
#include "ui/window/command.h"
#include "ui/window/docks.h"

#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

/// Of the project's runs of a sample.
bool canBeShown(const KeptRun& run) { return run.own && !run.worn && run.problem.isEmpty(); }

/// nullptr: there is none.
const KeptRun* newestOf(const RunHistory& history)
{
    const auto& runs = history.runs();
    const auto found = std::find_if(runs.rbegin(), runs.rend(), canBeShown);
    return found == runs.rend() ? nullptr : &*found;
}

} // namespace

SimulateWorkspace::SimulateWorkspace(Document& document, RunHistory& history, ProjectRuns& runs, WindowQueue& queue, Viewport& viewport,
                                     QMainWindow& window)
    : document_(document), history_(history), runs_(runs), viewport_(viewport), queue_(queue), window_(window), run_(queue)
{
    buildPanels(window);
    connectPanels();
    connectRun();
    connectPlayback();
}

SimulateWorkspace::~SimulateWorkspace()
{
    // The parts report their end, when the panels are half gone.
    run_.disconnect(this);
    playback_.disconnect(this);
    run_.cancel();
}

void SimulateWorkspace::buildPanels(QMainWindow& window)
{
    maps_ = new WaterMapView(playback_);
    experiment_ = new ExperimentPanel(document_);
    simulation_ = new SimulationPanel(document_, run_);
    timeline_ = new Timeline(playback_);
    chart_ = new Chart(playback_);
    results_ = new ResultsPanel(playback_);
    auto* time = new QWidget;
    auto* layout = new QVBoxLayout(time);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(timeline_);
    layout->addWidget(chart_, 1);
    docks_.experiment = makeDock(window, "experiment", tr("Experiment"), experiment_);
    docks_.simulation = makeDock(window, "simulation", tr("Simulation"), simulation_);
    docks_.timeline = makeDock(window, "timeline", tr("Time"), time);
    docks_.results = makeDock(window, "results", tr("Results"), results_);
}

void SimulateWorkspace::connectPanels()
{
    DropletSection& droplets = experiment_->droplets();
    connect(&document_, &Document::designChanged, this, &SimulateWorkspace::refreshStale);
    connect(&droplets, &DropletSection::dropletChosen, this, &SimulateWorkspace::refreshDrops);
    connect(&droplets, &DropletSection::placingChanged, this, &SimulateWorkspace::refreshDrops);
    if (TextileCanvas* canvas = viewport_.canvas()) {
        connect(canvas, &TextileCanvas::placed, &droplets, &DropletSection::placeDroplet);
        connect(canvas, &TextileCanvas::placingEnded, &droplets, &DropletSection::endPlacing);
        connect(canvas, &TextileCanvas::dropChosen, &droplets, &DropletSection::choose);
        connect(canvas, &TextileCanvas::dropMoved, &droplets, &DropletSection::moveDroplet);
        connect(canvas, &TextileCanvas::dropAdded, &droplets, &DropletSection::addDropletAt);
        connect(canvas, &TextileCanvas::dropRemoved, &droplets, &DropletSection::deleteDroplet);
    }
    connect(maps_, &WaterMapView::quantityChanged, this, [this] { viewport_.setQuantity(maps_->quantity(), maps_->values()); });
    connect(&history_, &RunHistory::changed, this, &SimulateWorkspace::refreshKept);
    connect(results_, &ResultsPanel::newestRequested, this, [this] {
        if (const KeptRun* newest = newestOf(history_)) { showEarlierRun(QString(newest->path)); }
    });
    connect(results_, &ResultsPanel::chosenRequested, this, [this] {
        if (const KeptRun* kept = keptOfChosen()) { showEarlierRun(QString(kept->path)); }
    });
    refreshKept();
    connect(simulation_, &SimulationPanel::runRequested, this, [this] { startRun(); });
    connect(simulation_, &SimulationPanel::stopRequested, this, &SimulateWorkspace::stopByHand);
    connect(simulation_, &SimulationPanel::canRunChanged, this, &SimulateWorkspace::refreshActions);
}

void SimulateWorkspace::fillFileMenu(QMenu* menu)
{
    actions_.save_recording = addCommand(menu, {}, tr("Save Re&cording As…"), {}, tr("Save the run that is shown."));
    connect(actions_.save_recording, &QAction::triggered, this, &SimulateWorkspace::saveRecordingAs);
    actions_.save_report =
        addCommand(menu, {}, tr("Save Repor&t…"), {},
                   tr("Save the results of the run that is shown, with maps at the time shown and charts, as PDF or web page."));
    connect(actions_.save_report, &QAction::triggered, this, &SimulateWorkspace::saveReport);
    actions_.save_top = addCommand(menu, {}, tr("Save Map of the Top &Face…"), {},
                                   tr("Save the map of the top face at the time shown, as picture or table."));
    connect(actions_.save_top, &QAction::triggered, this, [this] { saveMap(MapSide::top); });
    actions_.save_bottom = addCommand(menu, {}, tr("Save Map of the &Bottom Face…"), {},
                                      tr("Save the map of the bottom face at the time shown, as picture or table."));
    connect(actions_.save_bottom, &QAction::triggered, this, [this] { saveMap(MapSide::bottom); });
    maps_->offerSaving(actions_.save_top, actions_.save_bottom);
    actions_.save_pictures = addCommand(menu, {}, tr("Save Picture Se&quence…"), {},
                                        tr("Save the picture at each time of the run that is shown, as numbered PNG files."));
    connect(actions_.save_pictures, &QAction::triggered, this, &SimulateWorkspace::savePictures);
    actions_.save_film = addCommand(menu, {}, tr("Save Fil&m (MP4)…"), {}, tr("Save the pictures of the run that is shown as a film."));
    connect(actions_.save_film, &QAction::triggered, this, &SimulateWorkspace::saveFilm);
}

void SimulateWorkspace::fillExperimentMenu(QMenu* menu)
{
    Actions& a = actions_;
    a.start = addCommand(menu, "run", tr("&Run"), QKeySequence("Ctrl+R"), tr("Run the experiment on the selected fabric."));
    connect(a.start, &QAction::triggered, this, [this] { startRun(); });
    a.pause = addCommand(menu, "pause", tr("&Pause"), {}, tr("Pause or resume the run."));
    connect(a.pause, &QAction::triggered, this, [this] { run_.setPaused(!run_.paused()); });
    a.stop = addCommand(menu, "stop", tr("S&top"), {}, tr("Stop the run, and say whether to keep what it recorded."));
    connect(a.stop, &QAction::triggered, this, &SimulateWorkspace::stopByHand);
    QAction* plan =
        addCommand(menu, "plan", tr("&What Will Be Modelled, and Why…"), {}, tr("Which physics the next run models, and the reasons."));
    connect(plan, &QAction::triggered, simulation_, &SimulationPanel::showPlan);
    a.shown_plan =
        addCommand(menu, {}, tr("What W&as Modelled, and Why…"), {}, tr("Which physics the run on screen modelled, and the reasons."));
    connect(a.shown_plan, &QAction::triggered, results_, &ResultsPanel::showPlan);
    connect(addCommand(menu, {}, tr("&Calibrate…"), {}, tr("Fit what is not known of the selected fabric to a measurement.")),
            &QAction::triggered, this, [this] {
                commitTypedValue(window_);
                CalibrateDialog(document_, queue_, simulation_->fidelity(), simulation_->backend(), &window_).exec();
            });
    menu->addSeparator();
    a.play = addCommand(menu, {}, tr("P&lay or Pause the Recording") + "\t" + tr("Space"), {}, tr("Play back the run."));
    connect(a.play, &QAction::triggered, timeline_, &Timeline::togglePlaying);
    a.take_design =
        addCommand(menu, {}, tr("Open the &Design of the Recording"), {}, tr("Edit the design from which the run on screen was made."));
    connect(a.take_design, &QAction::triggered, this, &SimulateWorkspace::designRequested);
    menu->addSeparator();
    connect(addCommand(menu, "add", tr("&Add Droplet"), {}, tr("Add a droplet to the experiment.")), &QAction::triggered,
            &experiment_->droplets(), &DropletSection::addDroplet);
    connect(addCommand(menu, {}, tr("Add &Experiment"), {}, tr("Add a copy of the experiment.")), &QAction::triggered, experiment_,
            &ExperimentPanel::addExperiment);
}

void SimulateWorkspace::refreshActions()
{
    const Actions& a = actions_;
    if (!a.start) { return; }
    const bool running = run_.running(), any = playback_.run() != nullptr;
    a.start->setEnabled(simulation_->canRun());
    a.pause->setEnabled(running);
    a.pause->setText(run_.paused() ? tr("&Resume") : tr("&Pause"));
    a.pause->setIcon(themedIcon(run_.paused() ? "run" : "pause"));
    a.stop->setEnabled(running);
    a.save_recording->setEnabled(any && !playback_.live() && !playback_.path().isEmpty());
    a.save_report->setEnabled(any);
    a.save_top->setEnabled(any && playback_.frame());
    a.save_bottom->setEnabled(any && playback_.frame());
    const bool filmable = any && !playback_.live() && viewport_.canvas();
    a.save_pictures->setEnabled(filmable);
    const bool encoder = Film::whyNoMovie().isEmpty();
    a.save_film->setEnabled(filmable && encoder);
    a.save_film->setText(encoder ? tr("Save Fil&m (MP4)…") : tr("Save Fil&m (MP4): ffmpeg Is Not Installed"));
    a.take_design->setEnabled(any);
    a.play->setEnabled(any);
    a.shown_plan->setEnabled(any);
}

bool SimulateWorkspace::drawRun()
{
    if (!playback_.run()) { return false; }
    viewport_.showRun(playback_.run());
    if (playback_.frame()) { viewport_.showFrame(playback_.frame(), playback_.maximumSaturation()); }
    viewport_.setNotice(stale_ ? whyStale() : QString());
    return true;
}

bool SimulateWorkspace::drawSample()
{
    if (!document_.experiment() || document_.hasError()) { return false; }
    viewport_.showSample(document_.design(), document_.fabricIndex(), *document_.experiment());
    return true;
}

void SimulateWorkspace::refreshDrops()
{
    TextileCanvas* canvas = viewport_.canvas();
    if (!canvas) { return; }
    const DropletSection& droplets = experiment_->droplets();
    std::vector<QPointF> places;
    const Experiment* experiment = document_.experiment();
    const bool marked = shown_ && experiment && uses_field(experiment->type, "droplets");
    if (marked) {
        for (const Droplet& drop : experiment->droplets) { places.emplace_back(drop.at_mm[0], drop.at_mm[1]); }
    }
    canvas->setDrops(places, droplets.chosen());
    canvas->setDropsEditable(marked);
    canvas->setPlacing(shown_ && droplets.placing());
}

void SimulateWorkspace::refreshStale()
{
    stale_ = false;
    if (const auto& run = playback_.run()) {
        const bool chosen = document_.fabric() && document_.experiment() && document_.fabric()->name == run->fabric &&
                            document_.experiment()->name == run->experiment;
        stale_ = !chosen || !holdsFor(*run, *document_.design());
    }
    results_->setChosenKept(stale_ && keptOfChosen());
}

void SimulateWorkspace::refreshKept()
{
    const auto& runs = history_.runs();
    results_->setKept(static_cast<int>(std::count_if(runs.begin(), runs.end(), canBeShown)));
    results_->setChosenKept(stale_ && keptOfChosen());
    if (stale_) { Q_EMIT pictureChanged(); } // whose notice says so
}

/// The newest run of the project that holds for the selected fabric and experiment; nullptr: there is none.
const KeptRun* SimulateWorkspace::keptOfChosen() const
{
    if (!document_.fabric() || !document_.experiment()) { return nullptr; }
    const auto& runs = history_.runs();
    const auto found = std::find_if(runs.rbegin(), runs.rend(), [this](const KeptRun& kept) {
        return canBeShown(kept) && kept.complete() && kept.run->fabric == document_.fabric()->name &&
               kept.run->experiment == document_.experiment()->name && holdsFor(*kept.run, *document_.design());
    });
    return found == runs.rend() ? nullptr : &*found;
}

QString SimulateWorkspace::whyStale() const
{
    const auto& run = playback_.run();
    if (keptOfChosen()) {
        const bool chosen = document_.fabric()->name == run->fabric && document_.experiment()->name == run->experiment;
        return chosen ? tr("Out of date: the design has changed since this run. Results has a link to a run of it.")
                      : tr("These results are for “%1, %2”. Results has a link to the run of what is selected.")
                            .arg(QString::fromStdString(run->fabric), QString::fromStdString(run->experiment));
    }
    if (!document_.fabric() || document_.fabric()->name != run->fabric) {
        return tr("These results are for “%1”. Run the selected fabric.").arg(QString::fromStdString(run->fabric));
    }
    if (!document_.experiment() || document_.experiment()->name != run->experiment) {
        return tr("These results are for “%1”. Run the selected experiment.").arg(QString::fromStdString(run->experiment));
    }
    return tr("Out of date: the design has changed since this run. Run again.");
}

/// Chooses the fabric and the experiment of the run on screen.
void SimulateWorkspace::chooseWhatRan()
{
    const auto& run = playback_.run();
    const Design& design = *document_.design();
    for (std::size_t i = 0; i < design.fabrics.size(); ++i) {
        if (design.fabrics[i].name == run->fabric) { document_.setFabricIndex(static_cast<int>(i)); }
    }
    for (std::size_t i = 0; i < design.experiments.size(); ++i) {
        if (design.experiments[i].name == run->experiment) { document_.setExperimentIndex(static_cast<int>(i)); }
    }
}

void SimulateWorkspace::takeDesign()
{
    document_.take(playback_.run()->design, tr("Design of the recording"));
    chooseWhatRan();
}

void SimulateWorkspace::showIssue(const Place& where)
{
    reveal(docks_.experiment);
    experiment_->showField(where);
}

} // namespace hygroloom
