// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/main_window.h"

#include "core/project/project_file.h"
#include "ui/basics/appearance.h"
#include "ui/basics/wheel_guard.h"
#include "ui/panels/candidates_panel.h"
#include "ui/panels/experiment_panel.h"
#include "ui/panels/fabric_panel.h"
#include "ui/panels/issues_panel.h"
#include "ui/picture/textile_canvas.h"
#include "ui/results/chart.h"
#include "ui/results/compare_view.h"
#include "ui/results/results_panel.h"
#include "ui/results/simulation_panel.h"
#include "ui/results/timeline.h"
#include "ui/results/water_map_view.h"
#include "ui/weave/draft_editor.h"
#include "ui/weave/order_editor.h"
#include "ui/weave/point_paper.h"
#include "ui/weave/weave_editor.h"

#include <QAbstractSpinBox>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMessageBox>
#include <QRegularExpression>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

constexpr double most_recorded = 2e9; // bytes, of runs that are not saved

/// What a run depends on, as text: equal texts mean that the results still hold.
std::string dependence(const Design& design, const std::string& fabric, const std::string& experiment)
{
    Design part;
    part.materials = design.materials;
    if (const Fabric* found = find_fabric(design, fabric)) { part.fabrics.push_back(*found); }
    if (const Experiment* found = find_experiment(design, experiment)) {
        part.experiments.push_back(*found);
        if (const Liquid* liquid = find_liquid(design, found->liquid)) { part.liquids.push_back(*liquid); }
    }
    return format_project(part);
}

/// Also of a window of its own, such as a floating dock.
bool isPartOf(const QObject* part, const QObject* whole)
{
    while (part && part != whole) { part = part->parent(); }
    return part;
}

void reveal(QDockWidget* dock)
{
    dock->setVisible(true);
    dock->raise();
}

} // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent)
{
    useResources();
    setObjectName("main window");
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    buildPanels();
    (new WheelGuard(this))->guard(this);
    buildActions();
    connectParts();
    // With its frame the window fits the screen it opens on.
    const QSize room = screen()->availableSize() - QSize(16, 48);
    resize(QSize(1360, 860).boundedTo(room));
    for (const Workspace workspace : {Workspace::compare, Workspace::simulate, Workspace::design}) {
        arrange(workspace);
        first_states_[static_cast<int>(workspace)] = saveState(layout_version);
    }
    QSettings settings;
    restoreGeometry(settings.value("window/geometry").toByteArray());
    states_[0] = settings.value("window/design").toByteArray();
    states_[1] = settings.value("window/simulate").toByteArray();
    states_[2] = settings.value("window/compare").toByteArray();
    if (!states_[0].isEmpty()) { restoreState(states_[0], layout_version); }
    maps_->setVisible(false);
    refreshTitle();
    refreshPicture();
    refreshIssueCount();
    refreshActions();
}

MainWindow::~MainWindow()
{
    // The parts tell about their end; nobody is left to listen.
    run_.disconnect(this);
    playback_.disconnect(this);
    document_.disconnect(this);
    run_.cancel();
}

void MainWindow::buildPanels()
{
    viewport_ = new Viewport;
    maps_ = new WaterMapView(playback_);
    auto* middle = new QSplitter(Qt::Horizontal);
    middle->setChildrenCollapsible(false);
    middle->addWidget(viewport_);
    middle->addWidget(maps_);
    middle->setStretchFactor(0, 3);
    middle->setStretchFactor(1, 2);
    middle->setSizes({600, 400});
    compare_ = new CompareView(history_);
    middle_ = new QStackedWidget;
    middle_->addWidget(middle);
    middle_->addWidget(compare_);
    setCentralWidget(middle_);

    const auto dock = [this](const char* name, const QString& title, QWidget* widget) {
        auto* made = new QDockWidget(title, this);
        made->setObjectName(name);
        made->setAccessibleName(title);
        made->setWidget(widget);
        return made;
    };
    candidates_ = new CandidatesPanel(document_);
    weave_ = new WeaveEditor(document_);
    draft_ = new DraftEditor(document_);
    fabric_panel_ = new FabricPanel(document_);
    experiment_panel_ = new ExperimentPanel(document_);
    simulation_panel_ = new SimulationPanel(document_, run_);
    issues_ = new IssuesPanel(document_);
    timeline_ = new Timeline(playback_);
    chart_ = new Chart(playback_);
    results_ = new ResultsPanel(playback_);
    auto* moment = new QWidget;
    auto* layout = new QVBoxLayout(moment);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(timeline_);
    layout->addWidget(chart_, 1);
    candidates_dock_ = dock("candidates", tr("Candidates"), candidates_);
    weave_dock_ = dock("weave", tr("Weave"), weave_);
    draft_dock_ = dock("draft", tr("Draft"), draft_);
    fabric_dock_ = dock("fabric", tr("Fabric"), fabric_panel_);
    experiment_dock_ = dock("experiment", tr("Experiment"), experiment_panel_);
    simulation_dock_ = dock("simulation", tr("Simulation"), simulation_panel_);
    issues_dock_ = dock("issues", tr("Issues"), issues_);
    timeline_dock_ = dock("timeline", tr("Time"), moment);
    results_dock_ = dock("results", tr("Results"), results_);

    issue_count_ = new QToolButton;
    issue_count_->setAutoRaise(true);
    issue_count_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    statusBar()->addPermanentWidget(issue_count_);
    connect(issue_count_, &QToolButton::clicked, this, [this] {
        issues_dock_->setVisible(!issues_dock_->isVisible());
        issues_dock_->raise();
    });
}

void MainWindow::arrange(Workspace workspace)
{
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    for (QDockWidget* dock : {candidates_dock_, weave_dock_, draft_dock_, fabric_dock_, experiment_dock_, simulation_dock_, issues_dock_,
                              timeline_dock_, results_dock_}) {
        dock->setFloating(false);
    }
    addDockWidget(Qt::LeftDockWidgetArea, candidates_dock_);
    addDockWidget(Qt::LeftDockWidgetArea, weave_dock_);
    splitDockWidget(candidates_dock_, weave_dock_, Qt::Vertical);
    addDockWidget(Qt::RightDockWidgetArea, fabric_dock_);
    addDockWidget(Qt::RightDockWidgetArea, experiment_dock_);
    splitDockWidget(fabric_dock_, experiment_dock_, Qt::Vertical);
    splitDockWidget(experiment_dock_, simulation_dock_, Qt::Vertical);
    addDockWidget(Qt::BottomDockWidgetArea, timeline_dock_);
    addDockWidget(Qt::BottomDockWidgetArea, draft_dock_);
    splitDockWidget(timeline_dock_, draft_dock_, Qt::Vertical);
    addDockWidget(Qt::BottomDockWidgetArea, issues_dock_);
    splitDockWidget(draft_dock_, issues_dock_, Qt::Vertical);
    splitDockWidget(timeline_dock_, results_dock_, Qt::Horizontal);
    const bool design = workspace == Workspace::design, simulate = workspace == Workspace::simulate;
    candidates_dock_->setVisible(design);
    weave_dock_->setVisible(design);
    fabric_dock_->setVisible(design);
    experiment_dock_->setVisible(simulate);
    simulation_dock_->setVisible(simulate);
    timeline_dock_->setVisible(simulate);
    results_dock_->setVisible(simulate);
    draft_dock_->setVisible(false);
    issues_dock_->setVisible(false);
    if (design) {
        resizeDocks({candidates_dock_, weave_dock_}, {130, 470}, Qt::Vertical);
        resizeDocks({candidates_dock_, fabric_dock_}, {230, 320}, Qt::Horizontal);
    } else if (simulate) {
        resizeDocks({experiment_dock_, simulation_dock_}, {480, 240}, Qt::Vertical);
        resizeDocks({experiment_dock_}, {310}, Qt::Horizontal);
        resizeDocks({timeline_dock_, results_dock_}, {600, 350}, Qt::Horizontal);
        resizeDocks({timeline_dock_}, {200}, Qt::Vertical);
    }
}

void MainWindow::setWorkspace(Workspace workspace)
{
    if (workspace == workspace_) { return; }
    states_[static_cast<int>(workspace_)] = saveState(layout_version);
    workspace_ = workspace;
    const QByteArray& state = states_[static_cast<int>(workspace)];
    restoreState(state.isEmpty() ? first_states_[static_cast<int>(workspace)] : state, layout_version);
    maps_->setVisible(workspace == Workspace::simulate);
    middle_->setCurrentIndex(workspace == Workspace::compare ? 1 : 0);
    workspaces_->actions().at(static_cast<int>(workspace))->setChecked(true);
    refreshPicture();
}

void MainWindow::resetLayout()
{
    for (QByteArray& state : states_) { state.clear(); }
    arrange(workspace_);
    first_states_[static_cast<int>(workspace_)] = saveState(layout_version);
}

void MainWindow::connectParts()
{
    connect(&document_, &Document::designChanged, this, [this] {
        refreshStale();
        refreshPicture();
        refreshIssueCount();
    });
    connect(experiment_panel_, &ExperimentPanel::dropletChosen, this, &MainWindow::refreshDrops);
    connect(experiment_panel_, &ExperimentPanel::placingChanged, this, &MainWindow::refreshDrops);
    if (TextileCanvas* canvas = viewport_->canvas()) {
        connect(canvas, &TextileCanvas::placed, experiment_panel_, &ExperimentPanel::placeDroplet);
        connect(canvas, &TextileCanvas::placingEnded, experiment_panel_, &ExperimentPanel::endPlacing);
    }
    connect(&document_, &Document::pathChanged, this, &MainWindow::refreshTitle);
    connect(&document_, &Document::modifiedChanged, this, &MainWindow::refreshTitle);
    connect(&document_, &Document::failed, this, &MainWindow::tellProblem);
    connect(&playback_, &Playback::failed, this, &MainWindow::tellProblem);
    connect(simulation_panel_, &SimulationPanel::runRequested, this, &MainWindow::startRun);
    connect(simulation_panel_, &SimulationPanel::canRunChanged, this, &MainWindow::refreshActions);
    connect(weave_->paper(), &PointPaper::crossingHovered, viewport_, &Viewport::setHighlight);
    connect(viewport_, &Viewport::repeatHovered, weave_->paper(), &PointPaper::setHighlight);
    connect(viewport_, &Viewport::repeatSelected, weave_->paper(), &PointPaper::setSelectedYarn);
    connect(candidates_, &CandidatesPanel::told, this, [this](const QString& sentence, bool problem) {
        if (problem) {
            tellProblem(sentence);
        } else {
            statusBar()->showMessage(sentence, 4000);
        }
    });
    connect(weave_, &WeaveEditor::draftRequested, this, [this] {
        draft_dock_->setVisible(true);
        resizeDocks({draft_dock_}, {std::max(300, height() * 2 / 5)}, Qt::Vertical);
        draft_->paper()->setFocus();
    });
    connect(draft_->order(), &OrderEditor::yarnActivated, this, [this](int yarn) {
        reveal(fabric_dock_);
        fabric_panel_->showYarn(yarn);
    });
    connect(issues_, &IssuesPanel::issueActivated, this, &MainWindow::showIssue);
    connect(&run_, &SimulationRun::started, this, [this](const std::shared_ptr<const RunRecord>& run) {
        run_clock_.start();
        playback_.begin(run, run_path_);
        makeRoom();
    });
    connect(&run_, &SimulationRun::frameArrived, &playback_, &Playback::append);
    connect(&run_, &SimulationRun::completed, &playback_, &Playback::complete);
    connect(&run_, &SimulationRun::pausedChanged, this, &MainWindow::refreshActions);
    connect(&run_, &SimulationRun::ended, this, &MainWindow::showRunEnd);
    connect(&playback_, &Playback::runChanged, this, [this] {
        refreshStale();
        refreshPicture();
        refreshActions();
    });
    connect(&playback_, &Playback::frameShown, this, [this] {
        if (workspace_ == Workspace::simulate && playback_.frame()) {
            viewport_->showFrame(playback_.frame(), playback_.maximumSaturation());
        }
    });
    connect(&playback_, &Playback::metricsChanged, this, [this] {
        if (!playback_.live()) { viewport_->setRunMaximum(playback_.maximumSaturation()); }
        keepRun();
    });
    connect(compare_, &CompareView::runRequested, this, &MainWindow::showRun);
    connect(compare_, &CompareView::failed, this, &MainWindow::tellProblem);
    connect(&playback_, &Playback::opened, this, [this](const QString& path) {
        if (!ownRecording(path)) { addRecentFile(path); }
        if (path == opening_ && !document_.modified()) {
            document_.take(playback_.run()->design, tr("Design of %1").arg(QFileInfo(path).fileName()));
        }
        if (path != opening_ || !document_.modified()) { chooseWhatRan(); }
        setWorkspace(Workspace::simulate);
    });
}

void MainWindow::refreshTitle()
{
    const QString title = document_.title().isEmpty() ? tr("Untitled") : document_.title();
    setWindowTitle(tr("%1[*] – Hygroloom").arg(title));
    setWindowModified(document_.modified());
    setWindowFilePath(document_.path());
    refreshActions();
}

void MainWindow::refreshPicture()
{
    refreshDrops();
    if (workspace_ == Workspace::simulate && playback_.run()) {
        viewport_->showRun(playback_.run());
        if (playback_.frame()) { viewport_->showFrame(playback_.frame(), playback_.maximumSaturation()); }
        viewport_->setNotice(stale_ ? whyStale() : QString());
        return;
    }
    if (!document_.fabric()) {
        viewport_->showNothing(tr("This project has no fabric. Add one with Fabric ▸ Add Fabric."));
        return;
    }
    if (document_.fabricHasError()) {
        QString why;
        for (const Issue& issue : document_.issues()) {
            if (issue.severity == Severity::error) {
                why = QString::fromStdString(issue.text);
                break;
            }
        }
        viewport_->setNotice(tr("Not up to date: %1").arg(why));
        return;
    }
    if (workspace_ == Workspace::simulate && document_.experiment() && !document_.hasError()) {
        viewport_->showSample(document_.design(), document_.fabricIndex(), *document_.experiment());
    } else {
        viewport_->showFabric(document_.design(), document_.fabricIndex());
    }
}

/// The fabric and the experiment of the run that is shown.
void MainWindow::chooseWhatRan()
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

/// What is shown, once all of it is known.
void MainWindow::keepRun()
{
    const QString& path = playback_.path();
    if (!playback_.run() || !playback_.metrics() || !playback_.whole() || path.isEmpty()) { return; }
    KeptRun kept{path, playback_.run(), playback_.metrics()};
    kept.own = ownRecording(path);
    kept.saved = !kept.own;
    kept.elapsed = path == run_path_ ? run_elapsed_ : 0;
    history_.keep(kept);
}

void MainWindow::makeRoom()
{
    const int lost = history_.dropOldest(most_recorded);
    if (lost == 1) { statusBar()->showMessage(tr("The oldest run was dropped to make room; its recording was not saved."), 10000); }
    if (lost > 1) {
        statusBar()->showMessage(tr("The %1 oldest runs were dropped to make room; their recordings were not saved.").arg(lost), 10000);
    }
}

bool MainWindow::ownRecording(const QString& path) const { return recordings_.isValid() && path.startsWith(recordings_.path() + "/"); }

/// Where drops are to fall, as long as no run shows where they fell.
void MainWindow::refreshDrops()
{
    TextileCanvas* canvas = viewport_->canvas();
    if (!canvas) { return; }
    std::vector<QPointF> places;
    const Experiment* experiment = document_.experiment();
    const bool asked = !playback_.run() || experiment_panel_->placing();
    if (workspace_ == Workspace::simulate && asked && experiment && experiment->type == ExperimentType::droplet) {
        for (const Droplet& drop : experiment->droplets) { places.emplace_back(drop.at_mm[0], drop.at_mm[1]); }
    }
    canvas->setDrops(places, experiment_panel_->droplet());
    canvas->setPlacing(workspace_ == Workspace::simulate && experiment_panel_->placing());
}

void MainWindow::refreshStale()
{
    bool stale = false;
    if (const auto& run = playback_.run()) {
        const bool chosen = document_.fabric() && document_.experiment() && document_.fabric()->name == run->fabric &&
                            document_.experiment()->name == run->experiment;
        stale = !chosen ||
                dependence(run->design, run->fabric, run->experiment) != dependence(*document_.design(), run->fabric, run->experiment);
    }
    stale_ = stale;
}

QString MainWindow::whyStale() const
{
    const auto& run = playback_.run();
    if (!document_.fabric() || document_.fabric()->name != run->fabric) {
        return tr("Results of “%1”, which is not the fabric that is chosen. Run to see that one.").arg(QString::fromStdString(run->fabric));
    }
    if (!document_.experiment() || document_.experiment()->name != run->experiment) {
        return tr("Results of “%1”, which is not the experiment that is chosen. Run to see that one.")
            .arg(QString::fromStdString(run->experiment));
    }
    return tr("Stale: results of an earlier design. Run again to renew them.");
}

void MainWindow::refreshIssueCount()
{
    int counts[3] = {};
    for (const Issue* issue : issuesToTell(document_)) { ++counts[static_cast<int>(issue->severity)]; }
    QStringList parts;
    const auto count = [&](Severity severity, const QString& one, const QString& many) {
        if (const int found = counts[static_cast<int>(severity)]) { parts << (found == 1 ? one : many.arg(found)); }
    };
    count(Severity::error, tr("1 error"), tr("%1 errors"));
    count(Severity::warning, tr("1 warning"), tr("%1 warnings"));
    count(Severity::note, tr("1 note"), tr("%1 notes"));
    const Severity worst = counts[2] ? Severity::error : counts[1] ? Severity::warning : Severity::note;
    issue_count_->setText(parts.isEmpty() ? tr("No issues") : parts.join(", "));
    issue_count_->setIcon(parts.isEmpty() ? QIcon() : severityIcon(worst));
    issue_count_->setAccessibleName(tr("Issues: %1").arg(issue_count_->text()));
    issue_count_->setToolTip(tr("Show or hide the issues of the project."));
}

/// Chooses what the issue is about, and gives its field the focus.
void MainWindow::showIssue(const QString& where)
{
    static const QRegularExpression form("^(fabrics|experiments|materials|liquids)\\[(\\d+)\\]\\.?(.*)$");
    const auto match = form.match(where);
    const QString list = match.captured(1);
    const int index = match.captured(2).toInt();
    if (list == "fabrics") {
        document_.setFabricIndex(index);
        showFabricIssue(where, match.captured(3));
    } else if (list == "materials") {
        showMaterialIssue(index);
    } else if (match.hasMatch()) {
        if (list == "experiments") { document_.setExperimentIndex(index); }
        reveal(experiment_dock_);
        experiment_panel_->showField(where.toStdString());
    }
}

void MainWindow::showFabricIssue(const QString& where, const QString& part)
{
    if (part.isEmpty() || part == "name") {
        reveal(candidates_dock_);
        candidates_->setFocus();
    } else if (part.startsWith("weave")) {
        reveal(weave_dock_);
        weave_->paper()->setFocus();
    } else if (part.startsWith("warp_order") || part.startsWith("weft_order")) {
        reveal(draft_dock_);
        draft_->order()->showOrder(part.startsWith("warp_order"));
    } else {
        reveal(fabric_dock_);
        fabric_panel_->showField(where.toStdString());
    }
}

/// A project's own materials have no fields here; their yarns do.
void MainWindow::showMaterialIssue(int material)
{
    const Design& design = *document_.design();
    if (material >= static_cast<int>(design.materials.size())) { return; }
    const std::string& name = design.materials[static_cast<std::size_t>(material)].name;
    const auto made_of = [&name](const Yarn& yarn) {
        return std::any_of(yarn.material.begin(), yarn.material.end(), [&name](const MaterialShare& share) { return share.name == name; });
    };
    for (std::size_t i = 0; i < design.fabrics.size(); ++i) {
        const Fabric& fabric = design.fabrics[i];
        QString yarn = made_of(fabric.warp) ? "warp" : made_of(fabric.weft) ? "weft" : QString();
        for (std::size_t k = 0; k < fabric.extra_yarns.size() && yarn.isEmpty(); ++k) {
            yarn = made_of(fabric.extra_yarns[k]) ? QString("extra_yarns[%1]").arg(k) : QString();
        }
        if (!yarn.isEmpty()) {
            showIssue(QString("fabrics[%1].%2.material").arg(i).arg(yarn));
            break;
        }
    }
    statusBar()->showMessage(tr("The numbers of “%1” stand in the project file, under “materials”.").arg(QString::fromStdString(name)),
                             8000);
}

/// A field keeps what is typed to itself until the focus leaves it. Shortcuts and tool buttons, which leave the focus where it is, act on
/// what can be read.
void MainWindow::takeTypedValue()
{
    QWidget* focus = QApplication::focusWidget();
    const QPointer<QWidget> field = isPartOf(focus, this) ? focus : focusWidget();
    if (!qobject_cast<QLineEdit*>(field) && !qobject_cast<QAbstractSpinBox*>(field) && !qobject_cast<QComboBox*>(field)) { return; }
    field->clearFocus();
    if (field && field->isVisible()) { // the editor of a name in a list is gone by now
        field->setFocus();
    }
}

void MainWindow::startRun()
{
    takeTypedValue();
    if (!simulation_panel_->canRun()) { return; }
    setWorkspace(Workspace::simulate);
    experiment_panel_->endPlacing();
    RunOptions options;
    options.fidelity = simulation_panel_->fidelity();
    options.may_go_on_on_cpu = true;
    run_elapsed_ = 0;
    run_path_ = recordings_.filePath(QString("run-%1.hygrorec").arg(++runs_));
    options.recording = run_path_.toStdString();
    run_.start(document_.design(), document_.fabric()->name, document_.experiment()->name, options, simulation_panel_->backend());
    refreshActions();
}

void MainWindow::showRunEnd(SimulationRun::Outcome outcome, const QString& sentence)
{
    run_elapsed_ = run_clock_.isValid() ? 1e-3 * static_cast<double>(run_clock_.elapsed()) : 0;
    run_clock_.invalidate();
    playback_.end();
    refreshActions();
    const bool goes_on = !next_.isEmpty();
    if (goes_on) { playback_.open(std::exchange(next_, {})); }
    if (!goes_on && outcome == SimulationRun::Outcome::device_failed && simulation_panel_->backend() != "cpu") {
        QMessageBox box(QMessageBox::Question, tr("The device failed"), tr("%1\n\nRun on the CPU instead?").arg(sentence),
                        QMessageBox::Yes | QMessageBox::No, this);
        box.setTextFormat(Qt::PlainText);
        if (box.exec() == QMessageBox::Yes) {
            simulation_panel_->setBackend("cpu");
            startRun();
        }
    } else if (!sentence.isEmpty()) {
        tellProblem(sentence);
    }
}

void MainWindow::tellProblem(const QString& sentence)
{
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Hygroloom"), sentence, QMessageBox::Ok, this);
    box->setTextFormat(Qt::PlainText); // names of files and fabrics
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->modifiers() & ~Qt::KeypadModifier) {
        QMainWindow::keyPressEvent(event);
        return;
    }
    if (event->key() == Qt::Key_Space) {
        timeline_->togglePlaying();
    } else if (!viewport_->pressKey(event->key())) {
        QMainWindow::keyPressEvent(event);
    }
}

} // namespace hygroloom
