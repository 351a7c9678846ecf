// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/main_window.h"

#include "ui/basics/appearance.h"
#include "ui/basics/ask.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/wheel_guard.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/study_runs.h"
#include "ui/garment/garment_view.h"
#include "ui/panels/issues_panel.h"
#include "ui/picture/textile_canvas.h"
#include "ui/results/live_panel.h"
#include "ui/results/queue_list.h"
#include "ui/results/simulation_panel.h"
#include "ui/results/timeline.h"
#include "ui/results/water_map_view.h"
#include "ui/study/study_page.h"
#include "ui/window/design_workspace.h"
#include "ui/window/docks.h"
#include "ui/window/recent_files.h"

#include <QActionGroup>
#include <QApplication>
#include <QKeyEvent>
#include <QLayout>
#include <QScreen>
#include <QSessionManager>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolButton>

namespace hygroloom {

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
    restoreLayout();
    refreshTitle();
    refreshPicture();
    refreshIssueCount();
    simulate_->refreshActions();
    NewestJob::reportTo([this](const QString& sentence) { showProblem(sentence); });
}

MainWindow::~MainWindow()
{
    NewestJob::reportTo({});
    hide(); // the field that has the focus commits its value while there is a document
    // The parts report their end, when this window is half gone.
    simulate_->disconnect(this);
    garment_->disconnect(this);
    study_->disconnect(this);
    delete study_; // its runs end before the queue does
    document_.disconnect(this);
}

void MainWindow::buildPanels()
{
    viewport_ = new Viewport;
    design_ = std::make_unique<DesignWorkspace>(document_, *viewport_, *this);
    compare_ = std::make_unique<CompareWorkspace>(document_, recovery_, queue_);
    simulate_ = std::make_unique<SimulateWorkspace>(document_, compare_->runs(), compare_->project(), queue_, *viewport_, *this);
    garment_ = std::make_unique<GarmentWorkspace>(document_, compare_->runs(), compare_->project(), queue_, *this);
    design_->live().shareRanges(ranges_);
    compare_->view().shareRanges(ranges_);
    simulate_->maps().shareRanges(ranges_);
    issues_ = new IssuesPanel(document_);
    issues_dock_ = makeDock(*this, "issues", tr("Issues"), issues_);

    auto* fabric = new QSplitter(Qt::Horizontal);
    fabric->setChildrenCollapsible(false);
    fabric->addWidget(viewport_);
    fabric->addWidget(&simulate_->maps());
    fabric->setStretchFactor(0, 3);
    fabric->setStretchFactor(1, 2);
    fabric->setSizes({600, 400});
    middle_ = new QStackedWidget;
    middle_->addWidget(fabric);
    middle_->addWidget(&compare_->view());
    middle_->addWidget(&garment_->view());
    study_ = new StudyPage(document_, queue_);
    middle_->addWidget(study_);
    setCentralWidget(new Scrolled(middle_));
    showPage(0);

    statusBar()->addPermanentWidget(queue_button_ = new QueueButton(queue_));
    issue_count_ = new QToolButton;
    issue_count_->setAutoRaise(true);
    issue_count_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    statusBar()->addPermanentWidget(issue_count_);
    connect(issue_count_, &QToolButton::clicked, this, [this] {
        issues_dock_->setVisible(!issues_dock_->isVisible());
        issues_dock_->raise();
    });
}

/// The others ask for no room: one that is not seen would push the panels together.
void MainWindow::showPage(int shown)
{
    for (int page = 0; page < middle_->count(); ++page) {
        const QSizePolicy::Policy policy = page == shown ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        middle_->widget(page)->setSizePolicy(policy, policy);
    }
    middle_->setCurrentIndex(shown);
}

/// Panels ask for all of their content where the window has room for it, else for an equal share of it, and scroll. The window itself never
/// grows for them, also while panels of two workspaces are there for a moment, and so stays within the screen and maximised. Of one size
/// and the same panels shares only fall: a panel whose height follows from its width would let them swing.
void MainWindow::fitPanels()
{
    constexpr int all = 100, least = 10, step = 5; // %
    const auto panels = findChildren<Scrolled*>();
    const auto ask = [&] {
        for (Scrolled* panel : panels) { panel->setShares(0.01 * wide_, 0.01 * high_); }
        layout()->invalidate();
    };
    QList<QSize> fitted{size()};
    for (const Scrolled* panel : panels) { fitted << QSize(panel->isVisibleTo(this) ? 1 : 0, 0); }
    if (std::exchange(fitted_, fitted) != fitted) {
        wide_ = high_ = all;
        ask();
    }
    for (; wide_ > least && layout()->totalMinimumSize().width() > width(); ask()) { wide_ -= step; }
    for (; high_ > least && layout()->totalMinimumSize().height() > height(); ask()) { high_ -= step; }
}

bool MainWindow::event(QEvent* event)
{
    if (event->type() == QEvent::LayoutRequest) { fitPanels(); }
    return QMainWindow::event(event);
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    fitPanels();
    QMainWindow::resizeEvent(event);
}

void MainWindow::restoreLayout()
{
    layout()->setSizeConstraint(QLayout::SetNoConstraint); // see fitPanels()
    // With its frame the window fits the screen it opens on.
    const QSize room = screen()->availableSize() - QSize(16, 48);
    setMinimumSize(QSize(800, 520).boundedTo(room));
    resize(QSize(1360, 860).boundedTo(room));
    for (const Workspace workspace : {Workspace::study, Workspace::garment, Workspace::compare, Workspace::simulate, Workspace::design}) {
        arrange(workspace);
        first_states_[static_cast<int>(workspace)] = saveState(layout_version);
    }
    QSettings settings;
    restoreGeometry(settings.value("window/geometry").toByteArray());
    states_[0] = settings.value("window/design").toByteArray();
    states_[1] = settings.value("window/simulate").toByteArray();
    states_[2] = settings.value("window/compare").toByteArray();
    states_[3] = settings.value("window/garment").toByteArray();
    states_[4] = settings.value("window/study").toByteArray();
    garment_->view().restoreSteps(settings);
    if (!states_[0].isEmpty()) { restoreState(states_[0], layout_version); }
    simulate_->maps().setVisible(false);
    showRunCommands();
    layout()->activate();
    if (!settings.contains("window/geometry")) { resize(QSize(1360, 860).boundedTo(room)); }
    stayOnScreen();
}

/// The screen may be another one, or smaller, than when the window was closed.
void MainWindow::stayOnScreen()
{
    if (isMaximized() || isFullScreen()) { return; }
    const QRect room = screen()->availableGeometry();
    QRect place = geometry();
    place.setSize(place.size().boundedTo(room.size()));
    place.moveRight(std::min(place.right(), room.right()));
    place.moveBottom(std::min(place.bottom(), room.bottom()));
    place.moveTopLeft({std::max(place.left(), room.left()), std::max(place.top(), room.top())});
    if (place != geometry()) { setGeometry(place); }
}

std::vector<QDockWidget*> MainWindow::docks() const
{
    const auto& d = design_->docks();
    const auto& s = simulate_->docks();
    const auto& g = garment_->docks();
    return {d.candidates, d.weave, d.draft, d.fabric, d.live, s.experiment, s.simulation, s.timeline,  s.results,
            g.garment,    g.fit,   g.wear,  g.run,    g.time, g.parts,      g.runs,       issues_dock_};
}

void MainWindow::arrange(Workspace workspace)
{
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    const auto& d = design_->docks();
    const auto& s = simulate_->docks();
    const auto& g = garment_->docks();
    for (QDockWidget* dock : docks()) { dock->setFloating(false); }
    addDockWidget(Qt::LeftDockWidgetArea, d.candidates);
    addDockWidget(Qt::LeftDockWidgetArea, d.weave);
    splitDockWidget(d.candidates, d.weave, Qt::Vertical);
    addDockWidget(Qt::RightDockWidgetArea, d.fabric);
    addDockWidget(Qt::RightDockWidgetArea, d.live);
    splitDockWidget(d.fabric, d.live, Qt::Vertical);
    addDockWidget(Qt::RightDockWidgetArea, s.experiment);
    splitDockWidget(d.live, s.experiment, Qt::Vertical);
    splitDockWidget(s.experiment, s.simulation, Qt::Vertical);
    addDockWidget(Qt::LeftDockWidgetArea, g.garment);
    addDockWidget(Qt::LeftDockWidgetArea, g.fit);
    tabifyDockWidget(g.garment, g.fit);
    addDockWidget(Qt::RightDockWidgetArea, g.wear);
    splitDockWidget(g.wear, g.run, Qt::Vertical);
    addDockWidget(Qt::BottomDockWidgetArea, g.time);
    splitDockWidget(g.time, g.parts, Qt::Horizontal);
    tabifyDockWidget(g.parts, g.runs);
    addDockWidget(Qt::BottomDockWidgetArea, s.timeline);
    addDockWidget(Qt::BottomDockWidgetArea, d.draft);
    splitDockWidget(s.timeline, d.draft, Qt::Vertical);
    addDockWidget(Qt::BottomDockWidgetArea, issues_dock_);
    splitDockWidget(d.draft, issues_dock_, Qt::Vertical);
    splitDockWidget(s.timeline, s.results, Qt::Horizontal);
    showDocks(workspace);
}

/// Those of a workspace, in their usual sizes.
void MainWindow::showDocks(Workspace workspace)
{
    const auto& d = design_->docks();
    const auto& s = simulate_->docks();
    const auto& g = garment_->docks();
    const bool design = workspace == Workspace::design, simulate = workspace == Workspace::simulate;
    d.candidates->setVisible(design);
    d.weave->setVisible(design);
    d.fabric->setVisible(design);
    d.live->setVisible(design);
    s.experiment->setVisible(simulate);
    s.simulation->setVisible(simulate);
    s.timeline->setVisible(simulate);
    s.results->setVisible(simulate);
    for (QDockWidget* dock : {g.garment, g.fit, g.wear, g.run, g.time, g.parts, g.runs}) {
        dock->setVisible(workspace == Workspace::garment);
    }
    d.draft->setVisible(false);
    issues_dock_->setVisible(false);
    if (design) {
        resizeDocks({d.candidates, d.weave}, {130, 470}, Qt::Vertical);
        resizeDocks({d.fabric, d.live}, {400, 310}, Qt::Vertical);
        resizeDocks({d.candidates, d.fabric}, {230, 320}, Qt::Horizontal);
    } else if (simulate) {
        resizeDocks({s.experiment, s.simulation}, {480, 240}, Qt::Vertical);
        resizeDocks({s.experiment}, {310}, Qt::Horizontal);
        resizeDocks({s.timeline, s.results}, {530, 420}, Qt::Horizontal); // so that results fit without scrolling sideways
        resizeDocks({s.timeline}, {200}, Qt::Vertical);
    } else if (workspace == Workspace::garment) {
        g.garment->raise();
        g.parts->raise();
        resizeDocks({g.wear, g.run}, {330, 270}, Qt::Vertical);
        resizeDocks({g.garment, g.wear}, {330, 250}, Qt::Horizontal);
        resizeDocks({g.time, g.parts}, {560, 640}, Qt::Horizontal);
        resizeDocks({g.time}, {190}, Qt::Vertical);
    }
}

void MainWindow::setWorkspace(Workspace workspace)
{
    if (workspace == workspace_) { return; }
    states_[static_cast<int>(workspace_)] = saveState(layout_version);
    workspace_ = workspace;
    constexpr int pages[] = {0, 0, 1, 2, 3};
    const auto at = static_cast<std::size_t>(workspace);
    showPage(pages[at]);
    simulate_->maps().setVisible(workspace == Workspace::simulate);
    restoreState(states_[at].isEmpty() ? first_states_[at] : states_[at], layout_version);
    fitPanels();
    simulate_->setShown(workspace == Workspace::simulate);
    showRunCommands();
    compare_->project().setCompared(workspace == Workspace::compare);
    showModes();
    refreshPicture();
}

/// Run and Stop are those of the workspace.
void MainWindow::showRunCommands()
{
    const bool worn = workspace_ == Workspace::garment;
    for (QAction* action : {simulate_->actions().start, simulate_->actions().pause, simulate_->actions().stop}) {
        action->setVisible(!worn);
    }
    garment_->setShown(worn);
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
        refreshPicture();
        refreshIssueCount();
    });
    connect(&document_, &Document::replaced, &ranges_, &ColorRanges::clear);
    connect(&document_, &Document::pathChanged, this, &MainWindow::refreshTitle);
    connect(&document_, &Document::modifiedChanged, this, &MainWindow::refreshTitle);
    connect(&document_, &Document::failed, this, &MainWindow::showProblem);
    connect(&recovery_, &Recovery::failed, this, &MainWindow::showProblem);
    connect(design_.get(), &DesignWorkspace::problemFound, this, &MainWindow::showProblem);
    connect(design_.get(), &DesignWorkspace::messageShown, this, &MainWindow::showMessage);
    connect(simulate_.get(), &SimulateWorkspace::problemFound, this, &MainWindow::showProblem);
    connect(simulate_.get(), &SimulateWorkspace::messageShown, this, &MainWindow::showMessage);
    connect(garment_.get(), &GarmentWorkspace::problemFound, this, &MainWindow::showProblem);
    connect(garment_.get(), &GarmentWorkspace::messageShown, this, &MainWindow::showMessage);
    connect(garment_.get(), &GarmentWorkspace::wanted, this, [this] { setWorkspace(Workspace::garment); });
    connect(simulate_.get(), &SimulateWorkspace::pictureChanged, this, &MainWindow::refreshPicture);
    connect(simulate_.get(), &SimulateWorkspace::wanted, this, [this] { setWorkspace(Workspace::simulate); });
    connect(simulate_.get(), &SimulateWorkspace::recordingUsed, recent_, &RecentFiles::add);
    connect(garment_.get(), &GarmentWorkspace::recordingUsed, recent_, &RecentFiles::add);
    connect(simulate_.get(), &SimulateWorkspace::designRequested, this, [this] {
        if (simulate_->playback().run() && mayLeave()) { simulate_->takeDesign(); }
    });
    connect(garment_.get(), &GarmentWorkspace::designRequested, this, [this] {
        if (garment_->playback().run() && mayLeave()) { garment_->takeDesign(); }
    });
    connect(&compare_->view(), &CompareView::runRequested, this, [this](const QString& path) {
        const KeptRun* run = compare_->runs().find(path);
        if (run && run->worn) {
            garment_->showEarlierRun(path);
        } else {
            simulate_->showEarlierRun(path);
        }
    });
    connect(&compare_->study(), &StudyRuns::ended, &simulate_->panel(), &SimulationPanel::refreshPlans);
    connect(&compare_->view(), &CompareView::failed, this, &MainWindow::showProblem);
    connect(&compare_->view(), &CompareView::saved, this,
            [this](const QString& file) { statusBar()->showMessage(tr("Saved %1").arg(file), 4000); });
    // Where the end of the session leaves no time for a question, changes and runs are on the disk and are offered at the next start.
    connect(qApp, &QGuiApplication::commitDataRequest, this, [this](auto& session) {
        if (session.allowsInteraction() && !close()) { session.cancel(); }
    });
    // After what else the end of a run shows.
    connect(&compare_->project(), &ProjectRuns::grown, this, &MainWindow::offerRoom, Qt::QueuedConnection);
    connect(study_, &StudyPage::failed, this, &MainWindow::showProblem);
    connect(study_, &StudyPage::messageShown, this, [this](const QString& sentence) { showMessage(sentence, 8000); });
    connect(issues_, &IssuesPanel::issueActivated, this, &MainWindow::showIssue);
}

void MainWindow::refreshTitle()
{
    const QString title = document_.title().isEmpty() ? tr("Untitled") : document_.title();
    setWindowTitle(tr("%1[*] – Hygroloom").arg(title));
    setWindowModified(document_.modified());
    setWindowFilePath(document_.path());
}

void MainWindow::refreshPicture()
{
    const bool simulate = workspace_ == Workspace::simulate;
    simulate_->refreshDrops();
    if (simulate && simulate_->drawRun()) { return; }
    if (!document_.fabric()) {
        viewport_->showNothing(tr("This project has no fabric. Add one with Fabric ▸ Add Fabric."));
        return;
    }
    if (document_.fabricHasError()) {
        QString why;
        for (const Issue& issue : document_.issues()) {
            if (issue.severity == Severity::error) {
                why = issueText(issue);
                break;
            }
        }
        viewport_->setNotice(tr("Out of date: %1").arg(why));
        return;
    }
    if (simulate && simulate_->drawSample()) { return; }
    viewport_->showFabric(document_.design(), document_.fabricIndex(), document_.fitted());
}

void MainWindow::refreshIssueCount()
{
    int counts[3] = {};
    for (const Issue* issue : shownIssues(document_)) { ++counts[static_cast<int>(issue->severity)]; }
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

/// Selects the fabric or experiment of the issue, and focuses its field.
void MainWindow::showIssue(const Place& where)
{
    const std::string list = where.key(0);
    const int index = static_cast<int>(where.number(0).value_or(0)), before = static_cast<int>(document_.design()->experiments.size());
    if (list == "fabrics") {
        document_.setFabricIndex(index);
        design_->showFabricIssue(where);
    } else if (list == "materials") {
        design_->showMaterialIssue(where);
    } else if (list == "garments" || (list == "experiments" && index >= before)) {
        setWorkspace(Workspace::garment);
        garment_->showIssue(list == "garments", list == "garments" ? index : index - before);
    } else {
        if (list == "experiments") { document_.setExperimentIndex(index); }
        simulate_->showIssue(where);
    }
}

void MainWindow::showProblem(const QString& sentence) { tell(this, sentence); }

void MainWindow::showMessage(const QString& sentence, int ms) { statusBar()->showMessage(sentence, ms); }

void MainWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->modifiers() & ~Qt::KeypadModifier) {
        QMainWindow::keyPressEvent(event);
        return;
    }
    if (workspace_ == Workspace::garment) {
        if (!garment_->pressKey(event->key())) { QMainWindow::keyPressEvent(event); }
    } else if (event->key() == Qt::Key_Space) {
        simulate_->timeline().togglePlaying();
    } else if (!viewport_->pressKey(event->key())) {
        QMainWindow::keyPressEvent(event);
    }
}

} // namespace hygroloom
