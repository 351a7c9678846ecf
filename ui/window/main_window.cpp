// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/main_window.h"

#include "ui/basics/appearance.h"
#include "ui/basics/ask.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/wheel_guard.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/study_runs.h"
#include "ui/export/card_dialog.h"
#include "ui/garment/garment_view.h"
#include "ui/panels/experiment_panel.h"
#include "ui/panels/issues_panel.h"
#include "ui/picture/textile_canvas.h"
#include "ui/results/live_panel.h"
#include "ui/results/queue_list.h"
#include "ui/results/run_panel.h"
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
    run_->refreshActions();
    NewestJob::reportTo([this](const QString& sentence) { showProblem(sentence); });
}

MainWindow::~MainWindow()
{
    NewestJob::reportTo({});
    hide(); // the field that has the focus commits its value while there is a document
    // The parts report their end, when this window is half gone.
    run_->disconnect(this);
    study_->disconnect(this);
    card_->disconnect(this);
    delete study_; // their runs end before the queue does
    delete card_;
    document_.disconnect(this);
}

void MainWindow::buildPanels()
{
    viewport_ = new Viewport;
    design_ = std::make_unique<DesignWorkspace>(document_, *viewport_, *this);
    compare_ = std::make_unique<CompareWorkspace>(document_, recovery_, queue_);
    run_ = std::make_unique<RunWorkspace>(document_, compare_->runs(), compare_->project(), queue_, *viewport_, *this);
    design_->live().shareRanges(ranges_);
    compare_->view().shareRanges(ranges_);
    run_->sample().maps().shareRanges(ranges_);
    issues_ = new IssuesPanel(document_);
    issues_dock_ = makeDock(*this, "issues", tr("Issues"), issues_);

    auto* fabric = new QSplitter(Qt::Horizontal);
    fabric->setChildrenCollapsible(false);
    fabric->addWidget(viewport_);
    fabric->addWidget(&run_->sample().maps());
    fabric->setStretchFactor(0, 3);
    fabric->setStretchFactor(1, 2);
    fabric->setSizes({600, 400});
    middle_ = new QStackedWidget;
    middle_->addWidget(fabric);
    middle_->addWidget(&compare_->view());
    middle_->addWidget(&run_->garment().view());
    study_ = new StudyPage(document_, queue_);
    middle_->addWidget(study_);
    setCentralWidget(new Scrolled(middle_));
    showPage(*middle_, 0);

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
    arrange(workspace_);
    QSettings settings;
    restoreGeometry(settings.value("window/geometry").toByteArray());
    for (std::size_t i = 0; i < std::size(states_); ++i) { states_[i] = settings.value(stateName(i)).toByteArray(); }
    run_->garment().view().restoreSteps(settings);
    if (!states_[0].isEmpty()) { restoreState(states_[0], layout_version); }
    run_->sample().maps().setVisible(false);
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
    const auto& r = run_->docks();
    return {d.candidates, d.weave, d.draft, d.fabric,  d.live, r.garment,   r.fit,
            r.experiment, r.run,   r.time,  r.results, r.runs, issues_dock_};
}

void MainWindow::arrange(Workspace workspace)
{
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    const auto& d = design_->docks();
    const auto& r = run_->docks();
    for (QDockWidget* dock : docks()) { dock->setFloating(false); }
    addDockWidget(Qt::LeftDockWidgetArea, d.candidates);
    addDockWidget(Qt::LeftDockWidgetArea, d.weave);
    splitDockWidget(d.candidates, d.weave, Qt::Vertical);
    addDockWidget(Qt::LeftDockWidgetArea, r.garment);
    addDockWidget(Qt::LeftDockWidgetArea, r.fit);
    tabifyDockWidget(r.garment, r.fit);
    addDockWidget(Qt::RightDockWidgetArea, d.fabric);
    addDockWidget(Qt::RightDockWidgetArea, d.live);
    splitDockWidget(d.fabric, d.live, Qt::Vertical);
    addDockWidget(Qt::RightDockWidgetArea, r.experiment);
    splitDockWidget(d.live, r.experiment, Qt::Vertical);
    splitDockWidget(r.experiment, r.run, Qt::Vertical);
    addDockWidget(Qt::BottomDockWidgetArea, r.time);
    addDockWidget(Qt::BottomDockWidgetArea, d.draft);
    splitDockWidget(r.time, d.draft, Qt::Vertical);
    addDockWidget(Qt::BottomDockWidgetArea, issues_dock_);
    splitDockWidget(d.draft, issues_dock_, Qt::Vertical);
    splitDockWidget(r.time, r.results, Qt::Horizontal);
    tabifyDockWidget(r.results, r.runs);
    showDocks(workspace);
}

/// Those of a workspace, in their usual sizes.
void MainWindow::showDocks(Workspace workspace)
{
    const auto& d = design_->docks();
    const auto& r = run_->docks();
    const bool design = workspace == Workspace::design, worn = workspace == Workspace::garment;
    const bool run = worn || workspace == Workspace::simulate;
    for (QDockWidget* dock : {d.candidates, d.weave, d.fabric, d.live}) { dock->setVisible(design); }
    for (QDockWidget* dock : {r.experiment, r.run, r.time, r.results, r.runs}) { dock->setVisible(run); }
    for (QDockWidget* dock : {r.garment, r.fit}) { dock->setVisible(worn); }
    d.draft->setVisible(false);
    issues_dock_->setVisible(false);
    if (design) {
        resizeDocks({d.candidates, d.weave}, {130, 470}, Qt::Vertical);
        resizeDocks({d.fabric, d.live}, {400, 310}, Qt::Vertical);
        resizeDocks({d.candidates, d.fabric}, {230, 320}, Qt::Horizontal);
    } else if (run) {
        r.garment->raise();
        r.results->raise();
        resizeDocks({r.experiment, r.run}, {480, 240}, Qt::Vertical);
        resizeDocks({r.garment, r.experiment}, {330, worn ? 250 : 310}, Qt::Horizontal);
        resizeDocks({r.time, r.results}, {530, 420}, Qt::Horizontal); // so that results fit without scrolling sideways
        resizeDocks({r.time}, {200}, Qt::Vertical);
    }
}

std::pair<int, int> MainWindow::placeOf(Workspace workspace)
{
    constexpr int design = 0, run = 1, compare = 2;
    constexpr std::pair<int, int> places[] = {{design, -1}, {run, 0}, {compare, 2}, {run, 1}, {compare, 3}};
    return places[static_cast<std::size_t>(workspace)];
}

std::size_t MainWindow::stateOf(Workspace workspace)
{
    constexpr std::size_t states[] = {0, 1, 3, 2, 3};
    return states[static_cast<std::size_t>(workspace)];
}

QString MainWindow::stateName(std::size_t state)
{
    const char* names[] = {"window/design", "window/sample", "window/garment", "window/compare"};
    return names[state];
}

void MainWindow::setWorkspace(Workspace workspace)
{
    if (workspace == workspace_) { return; }
    const std::size_t now = stateOf(workspace);
    const bool runs = workspace == Workspace::simulate || workspace == Workspace::garment;
    states_[stateOf(workspace_)] = saveState(layout_version);
    workspace_ = workspace;
    constexpr int pages[] = {0, 0, 1, 2, 3};
    showPage(*middle_, pages[static_cast<std::size_t>(workspace)]);
    run_->sample().maps().setVisible(workspace == Workspace::simulate);
    if (runs) { run_->setSubject(workspace == Workspace::garment ? Subject::garment : Subject::sample); }
    run_->setShown(runs);
    if (states_[now].isEmpty() || !restoreState(states_[now], layout_version)) { arrange(workspace); }
    fitted_.clear(); // the same panels may show something else
    fitPanels();
    compare_->project().setCompared(workspace == Workspace::compare);
    showModes();
    refreshPicture();
}

void MainWindow::resetLayout()
{
    for (QByteArray& state : states_) { state.clear(); }
    arrange(workspace_);
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
    connect(run_.get(), &RunWorkspace::problemFound, this, &MainWindow::showProblem);
    connect(run_.get(), &RunWorkspace::messageShown, this, &MainWindow::showMessage);
    connect(run_.get(), &RunWorkspace::wanted, this,
            [this](Subject subject) { setWorkspace(subject == Subject::garment ? Workspace::garment : Workspace::simulate); });
    connect(run_.get(), &RunWorkspace::recordingUsed, recent_, &RecentFiles::add);
    connect(run_.get(), &RunWorkspace::designRequested, this, [this] {
        if (mayLeave()) { run_->takeDesign(); }
    });
    connect(&run_->sample(), &SampleSubject::pictureChanged, this, &MainWindow::refreshPicture);
    connect(&compare_->view(), &CompareView::runRequested, run_.get(), &RunWorkspace::showEarlierRun);
    connect(&compare_->study(), &StudyRuns::ended, &run_->panel(), &RunPanel::refreshForecasts);
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
    SampleSubject& sample = run_->sample();
    sample.refreshDrops();
    if (simulate && sample.drawRun()) { return; }
    if (!document_.fabric()) {
        viewport_->showNothing(tr("This project has no fabric. Add one with Fabric ▸ Add Fabric."));
        return;
    }
    if (document_.fabricHasError()) {
        viewport_->setNotice(tr("Out of date: %1").arg(firstError(document_.issues())));
        return;
    }
    if (simulate && sample.drawSample()) { return; }
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
        run_->garment().chooseIssue(list == "garments", list == "garments" ? index : index - before);
        run_->revealForm(list == "garments");
    } else {
        if (list == "experiments") { document_.setExperimentIndex(index); }
        setWorkspace(Workspace::simulate);
        run_->revealForm(false);
        run_->sample().experiment().showField(where);
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
    const bool worn = workspace_ == Workspace::garment, runs = worn || workspace_ == Workspace::simulate;
    if (runs && run_->pressKey(event->key())) { return; }
    if (worn || !viewport_->pressKey(event->key())) { QMainWindow::keyPressEvent(event); }
}

} // namespace hygroloom
