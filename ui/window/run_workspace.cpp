// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Panels, commands, and runs from their start to their end. Recordings and what is saved of them: run_workspace_files.cpp.
#include "ui/window/run_workspace.h"

#include "core/base/error.h"
#include "ui/basics/ask.h"
#include "ui/basics/elided_combo.h"
#include "ui/basics/preferences.h"
#include "ui/basics/typed_value.h"
#include "ui/compare/run_list.h"
#include "ui/garment/fit_form.h"
#include "ui/garment/garment_panel.h"
#include "ui/results/calibrate_dialog.h"
#include "ui/results/chart.h"
#include "ui/results/project_runs.h"
#include "ui/results/run_panel.h"
#include "ui/results/run_questions.h"
#include "ui/results/timeline.h"
#include "ui/window/command.h"
#include "ui/window/docks.h"

#include <QEventLoop>
#include <QFormLayout>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace hygroloom {

namespace {

constexpr Subject both_subjects[] = {Subject::sample, Subject::garment};

} // namespace

RunWorkspace::RunWorkspace(Document& document, RunHistory& history, ProjectRuns& runs, WindowQueue& queue, Viewport& viewport,
                           QMainWindow& window)
    : document_(document), history_(history), runs_(runs), window_(window), queue_(queue), sample_(document, history, viewport, window),
      garment_(document, history, window), run_(queue), panel_(new RunPanel(run_, sample_)), list_(new RunList(history))
{
    buildPanels();
    connectParts();
    for (const Subject subject : both_subjects) { connectSubject(subject); }
    setSubject(Subject::sample);
}

RunWorkspace::~RunWorkspace()
{
    // The parts report their end, when the panels are half gone.
    run_.disconnect();
    for (const Subject subject : both_subjects) {
        of(subject).disconnect();
        of(subject).shown().disconnect();
    }
    run_.cancel();
}

void RunWorkspace::buildPanels()
{
    time_ = new QStackedWidget;
    results_ = new QStackedWidget;
    for (const Subject subject : both_subjects) {
        Time& time = times_[static_cast<std::size_t>(subject)] = makeTime(of(subject).shown());
        time_->addWidget(time.page);
        results_->addWidget(of(subject).results());
    }
    docks_.experiment = makeDock(window_, "experiment", tr("Experiment"), makeForm());
    docks_.run = makeDock(window_, "simulation", tr("Simulation"), panel_);
    docks_.time = makeDock(window_, "time", tr("Time"), time_);
    docks_.results = makeDock(window_, "results", tr("Results"), results_);
    docks_.runs = makeDock(window_, "runs", tr("Runs"), list_);
    docks_.garment = makeDock(window_, "garment", tr("Garment"), &garment_.panel());
    docks_.fit = makeDock(window_, "garment fit", tr("Gaps and Seams"), &garment_.fit());
}

/// What the experiment is run on, above its fields.
QWidget* RunWorkspace::makeForm()
{
    choice_ = new ElidedCombo;
    choice_->setAccessibleName(tr("Subject"));
    choice_->setToolTip(tr("What the experiment is run on: a sample of a fabric, or a garment."));
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice_->setMinimumContentsLength(12);
    connect(choice_, &QComboBox::activated, this, &RunWorkspace::choose);
    forms_ = new QStackedWidget;
    for (const Subject subject : both_subjects) { forms_->addWidget(of(subject).form()); }
    auto* form = new QWidget;
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* head = new QFormLayout;
    head->setContentsMargins(8, 8, 8, 0);
    head->setHorizontalSpacing(8);
    head->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    head->addRow(tr("Subject"), choice_);
    column->addLayout(head);
    column->addWidget(forms_, 1);
    return form;
}

RunWorkspace::Time RunWorkspace::makeTime(ShownRun& shown)
{
    Time time{new QWidget, new Timeline(shown), new Chart(shown)};
    auto* layout = new QVBoxLayout(time.page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(time.timeline);
    layout->addWidget(time.chart, 1);
    return time;
}

void RunWorkspace::connectParts()
{
    connect(&run_, &QueuedRun::memoryIsShort, this, [this] { Q_EMIT messageShown(memoryWarning(), 10000); });
    connect(&run_, &QueuedRun::deviceFailed, this, [this](const QString& sentence) { Q_EMIT messageShown(sentence, 10000); });
    connect(&run_, &QueuedRun::pausedChanged, this, &RunWorkspace::refreshActions);
    connect(&run_, &QueuedRun::ended, this, &RunWorkspace::finish);
    connect(panel_, &RunPanel::runRequested, this, [this] { start(); });
    connect(panel_, &RunPanel::stopRequested, this, &RunWorkspace::stopByHand);
    connect(panel_, &RunPanel::canRunChanged, this, &RunWorkspace::refreshActions);
    connect(list_, &RunList::openRequested, this, &RunWorkspace::showEarlierRun);
    connect(list_, &RunList::markRequested, &runs_, &ProjectRuns::setMarked);
    connect(list_, &RunList::forgetRequested, &runs_, &ProjectRuns::forget);
    connect(&runs_, &ProjectRuns::copied, this, [this](double share) {
        Q_EMIT messageShown(tr("Copying runs to the project: %1 %").arg(static_cast<int>(100 * share)), 4000);
    });
    connect(&runs_, &ProjectRuns::failed, this, &RunWorkspace::problemFound);
    connect(&runs_, &ProjectRuns::messageShown, this, &RunWorkspace::messageShown);
    connect(&document_, &Document::designChanged, this, &RunWorkspace::refreshChoice);
    connect(&garment_.choice(), &GarmentChoice::changed, this, [this] {
        refreshChoice();
        refreshActions();
    });
    connect(&document_, &Document::replaced, this, &RunWorkspace::clearResults);
    connect(&garment_.playback(), &WearPlayback::framesChanged, this, &RunWorkspace::refreshActions);
    connect(&garment_, &GarmentSubject::saveOfAWanted, this, &RunWorkspace::askToSaveRecording);
}

void RunWorkspace::connectSubject(Subject which)
{
    RunSubject& subject = of(which);
    connect(&subject, &RunSubject::problemFound, this, &RunWorkspace::problemFound);
    connect(&subject, &RunSubject::messageShown, this, &RunWorkspace::messageShown);
    connect(&subject, &RunSubject::designRequested, this, &RunWorkspace::designRequested);
    connect(&subject, &RunSubject::runWanted, this, &RunWorkspace::showEarlierRun);
    connect(&subject, &RunSubject::wanted, this, [this, which] { Q_EMIT wanted(which); });
    ShownRun& shown = subject.shown();
    connect(&shown, &ShownRun::runChanged, this, &RunWorkspace::refreshActions);
    connect(&shown, &ShownRun::measured, this, &RunWorkspace::refreshActions);
    connect(&shown, &ShownRun::measured, this, [this, &subject] { keepRun(subject); });
    connect(&shown, &ShownRun::opened, this, [this, which](const QString& path) { takeOpened(which, path); });
    connect(&shown, &ShownRun::failed, this, &RunWorkspace::problemFound);
    connect(&runs_, &ProjectRuns::moved, &shown, &ShownRun::move);
}

/// Fabrics, then garments.
void RunWorkspace::refreshChoice()
{
    const Design& design = *document_.design();
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    for (const Fabric& fabric : design.fabrics) { choice_->addItem(tr("Sample of %1").arg(QString::fromStdString(fabric.name))); }
    for (const Garment& garment : design.garments) { choice_->addItem(tr("Garment: %1").arg(QString::fromStdString(garment.name))); }
    if (design.garments.empty()) { choice_->addItem(tr("A garment, yet to be added")); }
    choice_->setCurrentIndex(subject_ == Subject::sample
                                 ? document_.fabricIndex()
                                 : static_cast<int>(design.fabrics.size()) + std::max(0, garment_.choice().garmentIndex()));
}

void RunWorkspace::choose(int index)
{
    const int fabrics = static_cast<int>(document_.design()->fabrics.size());
    if (index < fabrics) {
        document_.setFabricIndex(index);
    } else if (!document_.design()->garments.empty()) {
        garment_.choice().setGarmentIndex(index - fabrics);
    }
    Q_EMIT wanted(index < fabrics ? Subject::sample : Subject::garment);
}

void RunWorkspace::setSubject(Subject subject)
{
    subject_ = subject;
    for (QStackedWidget* pages : {forms_, time_, results_}) { showPage(*pages, static_cast<int>(subject)); }
    panel_->setSubject(current());
    refreshChoice();
    setShown(shown_);
}

void RunWorkspace::setShown(bool shown)
{
    shown_ = shown;
    sample_.setOnScreen(shown && subject_ == Subject::sample);
    refreshActions();
}

void RunWorkspace::revealForm(bool of_garment) { reveal(of_garment ? docks_.garment : docks_.experiment); }

bool RunWorkspace::pressKey(int key)
{
    switch (key) {
    case Qt::Key_Space: timeline().togglePlaying(); return true;
    case Qt::Key_Comma: timeline().step(-1); return true;
    case Qt::Key_Period: timeline().step(1); return true;
    default: break;
    }
    if (subject_ == Subject::sample) { return false; }
    if (key == Qt::Key_Left || key == Qt::Key_Right) {
        timeline().step(key == Qt::Key_Left ? -1 : 1);
        return true;
    }
    return garment_.pressKey(key);
}

void RunWorkspace::fillExperimentMenu(QMenu* menu)
{
    Actions& a = actions_;
    menu->setToolTipsVisible(true); // why a command cannot be chosen
    a.start = addCommand(menu, "run", tr("&Run"), QKeySequence("Ctrl+R"), {});
    connect(a.start, &QAction::triggered, this, [this] { start(); });
    a.pause = addCommand(menu, "pause", tr("&Pause"), {}, tr("Pause or resume the run."));
    connect(a.pause, &QAction::triggered, this, [this] { run_.setPaused(!run_.paused()); });
    a.stop = addCommand(menu, "stop", tr("S&top"), {}, tr("Stop the run, and say whether to keep what it recorded."));
    connect(a.stop, &QAction::triggered, this, &RunWorkspace::stopByHand);
    a.plan =
        addCommand(menu, "plan", tr("&What Will Be Modelled, and Why…"), {}, tr("Which physics the next run models, and the reasons."));
    connect(a.plan, &QAction::triggered, panel_, &RunPanel::showPlan);
    connect(addCommand(menu, {}, tr("&Calibrate…"), {}, tr("Fit what is not known of the selected fabric to a measurement.")),
            &QAction::triggered, this, [this] {
                commitTypedValue(window_);
                CalibrateDialog(document_, queue_, panel_->fidelity(), panel_->backend(), &window_).exec();
            });
    menu->addSeparator();
    a.play = addCommand(menu, {}, tr("P&lay or Pause the Recording") + "\t" + tr("Space"), {}, tr("Play back the run."));
    connect(a.play, &QAction::triggered, this, [this] { timeline().togglePlaying(); });
    a.take_design =
        addCommand(menu, {}, tr("Open the &Design of the Recording"), {}, tr("Edit the design from which the run on screen was made."));
    connect(a.take_design, &QAction::triggered, this, &RunWorkspace::designRequested);
    menu->addSeparator();
    sample_.fillExperimentMenu(menu);
}

void RunWorkspace::refreshActions()
{
    const Actions& a = actions_;
    if (!a.start) { return; }
    const ShownRun& shown = current().shown();
    const bool running = run_.running(), any = shown.design(), rests = any && !shown.live();
    QString why_not;
    const bool can = panel_->canRun(&why_not);
    offerCommand(a.start, can, tr("Run the experiment on the chosen sample or garment."), why_not);
    a.pause->setEnabled(running);
    a.pause->setText(run_.paused() ? tr("&Resume") : tr("&Pause"));
    a.pause->setIcon(themedIcon(run_.paused() ? "run" : "pause"));
    a.stop->setEnabled(running);
    a.plan->setEnabled(current().hasPlan());
    a.play->setEnabled(any);
    a.take_design->setEnabled(any);
    a.save_recording->setEnabled(rests && !shown.path().isEmpty());
    a.save_report->setEnabled(rests || (any && subject_ == Subject::sample));
    for (const Subject subject : both_subjects) { of(subject).refreshActions(running, shown_ && subject == subject_); }
}

void RunWorkspace::start(bool beyond_memory)
{
    commitTypedValue(window_);
    if (!panel_->canRun()) { return; }
    Q_EMIT wanted(subject_);
    RunOptions options;
    options.fidelity = panel_->fidelity();
    options.may_go_on_on_cpu = true;
    options.memory.force = beyond_memory;
    options.threads = preferences().threads;
    try {
        run_path_ = runs_.reserve();
    } catch (const Error& error) {
        Q_EMIT problemFound(QString::fromStdString(error.what()));
        return;
    }
    opening_.clear();
    running_ = &current();
    running_->shown().stopOpening();
    options.recording = run_path_.toStdString();
    running_->start(run_, options, panel_->backend());
    refreshActions();
}

void RunWorkspace::finish(QueuedRun::Outcome outcome, const QString& sentence)
{
    const QString path = runs_.settle(run_path_);
    ShownRun& shown = running_->shown();
    shown.move(run_path_, path);
    shown.end();
    refreshActions();
    const bool by_hand = std::exchange(stopped_by_hand_, false) || run_.stoppedInList(outcome);
    const bool asks = by_hand && outcome == QueuedRun::Outcome::cancelled && !path.isEmpty();
    if (asks && !wantsStoppedRun(&window_, path)) {
        shown.discard();
        runs_.forget(path);
        return;
    }
    if (!stopping_) { offerInstead(outcome, sentence); }
}

/// The subject that ran last, however the page has changed meanwhile.
void RunWorkspace::runAgain(bool beyond_memory)
{
    for (const Subject subject : both_subjects) {
        if (&of(subject) == running_) { Q_EMIT wanted(subject); }
    }
    start(beyond_memory);
}

/// Of a run that came to no end.
void RunWorkspace::offerInstead(QueuedRun::Outcome outcome, const QString& sentence)
{
    if (outcome == QueuedRun::Outcome::device_failed && panel_->backend() != "cpu") {
        const Question question{tr("The device failed"),
                                tr("%1\n\nRun on the CPU instead?").arg(sentence),
                                {},
                                {{Reply::act, tr("&Run on the CPU")}, {Reply::cancel, tr("&Do Not Run")}},
                                Reply::act};
        if (ask(&window_, question) == Reply::act) {
            panel_->setBackend("cpu");
            runAgain(false);
        }
    } else if (outcome == QueuedRun::Outcome::memory_short) {
        if (wantsBeyondMemory(&window_, sentence)) { runAgain(true); }
    } else if (!sentence.isEmpty()) {
        Q_EMIT problemFound(sentence);
    }
}

void RunWorkspace::stopByHand()
{
    stopped_by_hand_ = run_.running();
    run_.cancel();
}

bool RunWorkspace::agreesToStopRun()
{
    if (!run_.running()) { return true; }
    const ShownRun& shown = running_->shown();
    const QString what = shown.live() ? shown.title() : tr("the experiment");
    const Question question{tr("A run is in progress"),
                            tr("Stop the run of “%1”?").arg(what),
                            tr("What is recorded up to now is kept with the project's runs."),
                            {{Reply::act, tr("&Stop and Keep What Is Recorded")}, {Reply::cancel, tr("&Let It Run")}}};
    return ask(&window_, question) == Reply::act;
}

/// Until the run has ended, 0.2 s or so, the window is drawn, but takes no input.
void RunWorkspace::stopRun()
{
    if (!run_.running()) { return; } // it may have ended while questions were open
    const QScopedValueRollback stopping(stopping_, true);
    QEventLoop end;
    connect(&run_, &QueuedRun::ended, &end, &QEventLoop::quit);
    run_.cancel();
    if (run_.running()) { end.exec(QEventLoop::ExcludeUserInputEvents); }
}

} // namespace hygroloom
