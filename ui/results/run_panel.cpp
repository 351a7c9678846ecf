// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/run_panel.h"

#include "gpu/backends.h"
#include "ui/basics/appearance.h"
#include "ui/basics/elided_combo.h"
#include "ui/basics/elided_label.h"
#include "ui/results/device_choice.h"
#include "ui/results/plan_dialog.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

namespace hygroloom {

namespace {

/// What a button needs to show another text.
int widthOf(QPushButton* button, const QString& text)
{
    const QString own = button->text();
    int width = button->sizeHint().width();
    button->setText(text);
    width = std::max(width, button->sizeHint().width());
    button->setText(own);
    return width;
}

} // namespace

RunPanel::RunPanel(QueuedRun& run, RunSubject& subject, QWidget* parent)
    : QWidget(parent), run_(run), fidelities_(new QButtonGroup(this)), device_(new ElidedCombo),
      start_(new QPushButton(themedIcon("run"), tr("Run"))), pause_(new QPushButton(themedIcon("pause"), tr("Pause"))),
      stop_(new QPushButton(themedIcon("stop"), tr("Stop"))),
      why_(new QPushButton(themedIcon("plan"), tr("What will be modelled, and why…"))), bar_(new QProgressBar), state_(new QLabel)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    addFidelities();
    addDevices();
    addButtons();
    addProgress();
    layout->addStretch();
    connect(&run_, &QueuedRun::begun, this, [this] {
        running_ = subject_;
        idle_ = false;
        bar_->setValue(0);
        showState();
        state_->setText(tr("Starting."));
    });
    connect(&run_, &QueuedRun::progressed, this, &RunPanel::showProgress);
    connect(&run_, &QueuedRun::ended, this, &RunPanel::showEnd);
    connect(&run_, &QueuedRun::pausedChanged, this, [this](bool paused) {
        showState();
        if (run_.running()) { state_->setText(paused ? tr("Paused.") : tr("Resuming.")); }
    });
    setSubject(subject);
}

void RunPanel::addFidelities()
{
    auto* grid = new QGridLayout;
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < all_fidelities.size(); ++i) {
        auto* button = new QRadioButton(fidelityName(all_fidelities[i]));
        button->setAccessibleName(tr("Fidelity: %1").arg(button->text()));
        fidelities_->addButton(button, static_cast<int>(i));
        auto* expected = new ElidedLabel;
        expected->setElideMode(Qt::ElideRight);
        expected_[i] = expected;
        expected_[i]->setForegroundRole(QPalette::PlaceholderText);
        expected_[i]->setAccessibleName(tr("Expected for %1").arg(button->text()));
        expected_[i]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        expected_[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        grid->addWidget(button, static_cast<int>(i), 0);
        grid->addWidget(expected_[i], static_cast<int>(i), 1);
    }
    fidelities_->button(static_cast<int>(Fidelity::draft))->setChecked(true);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
    connect(fidelities_, &QButtonGroup::idClicked, this, [this] { setFidelity(fidelity()); });
}

void RunPanel::addDevices()
{
    fillDevices(*device_);
    connect(device_, &QComboBox::currentIndexChanged, this, &RunPanel::refreshForecasts);
    device_->setAccessibleName(tr("Device"));
    device_->setToolTip(tr("Processor that runs the simulation."));
    device_->setMinimumContentsLength(12);
    device_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    layout()->addWidget(device_);
    why_->setFlat(true);
    why_->setToolTip(tr("Which physics the next run models, and the reasons."));
    static_cast<QVBoxLayout*>(layout())->addWidget(why_, 0, Qt::AlignLeft);
    connect(why_, &QPushButton::clicked, this, &RunPanel::showPlan);
}

void RunPanel::addButtons()
{
    QFont font = start_->font();
    font.setBold(true);
    start_->setFont(font);
    auto* buttons = new QHBoxLayout; // each keeps its place: a click meant as Pause starts no run
    buttons->setSpacing(6);
    pause_->setMinimumWidth(widthOf(pause_, tr("Resume")));
    for (QPushButton* button : {start_, pause_, stop_}) {
        button->setMinimumHeight(36);
        buttons->addWidget(button, button == start_ ? 1 : 0);
    }
    static_cast<QVBoxLayout*>(layout())->addLayout(buttons);
    for (QPushButton* button : {start_, pause_, stop_, why_}) { button->setAccessibleName(button->text()); }
    connect(start_, &QPushButton::clicked, this, &RunPanel::runRequested);
    connect(pause_, &QPushButton::clicked, this, [this] { run_.setPaused(!run_.paused()); });
    connect(stop_, &QPushButton::clicked, this, &RunPanel::stopRequested);
}

/// The panel must not change its height when a run begins.
void RunPanel::addProgress()
{
    bar_->setTextVisible(false);
    bar_->setFixedHeight(8);
    bar_->setRange(0, 1000);
    QSizePolicy policy = bar_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    bar_->setSizePolicy(policy);
    bar_->setAccessibleName(tr("Progress of the run"));
    layout()->addWidget(bar_);
    state_->setWordWrap(true);
    state_->setTextFormat(Qt::PlainText); // names of files and fabrics
    state_->setMinimumHeight(4 * state_->fontMetrics().lineSpacing());
    state_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    state_->setAccessibleName(tr("State of the run"));
    layout()->addWidget(state_);
}

void RunPanel::setSubject(RunSubject& subject)
{
    if (subject_) { subject_->disconnect(this); }
    subject_ = &subject;
    connect(subject_, &RunSubject::changed, this, &RunPanel::refreshForecasts);
    for (std::size_t i = 0; i < all_fidelities.size(); ++i) {
        fidelities_->button(static_cast<int>(i))->setToolTip(subject_->aboutFidelity(all_fidelities[i]));
        // What is expected comes late, and must not widen the panel then: room for it is kept, also for longer numbers.
        const QString longest = subject_->longForecast() + QStringLiteral("000");
        expected_[i]->setMinimumWidth(expected_[i]->fontMetrics().horizontalAdvance(longest));
        expected_[i]->clear();
    }
    why_->setVisible(subject_->hasPlan());
    idle_ = !run_.running();
    refreshForecasts();
}

std::size_t RunPanel::chosen() const { return static_cast<std::size_t>(std::max(0, fidelities_->checkedId())); }

void RunPanel::setFidelity(Fidelity fidelity)
{
    for (std::size_t i = 0; i < all_fidelities.size(); ++i) {
        if (all_fidelities[i] == fidelity) { fidelities_->button(static_cast<int>(i))->setChecked(true); }
    }
    idle_ = !run_.running();
    if (forecasts_[chosen()].tip.isEmpty()) {
        refreshForecasts();
    } else {
        showState();
    }
}

std::string RunPanel::backend() const { return device_->count() > 0 ? device_->currentData().toString().toStdString() : "auto"; }

void RunPanel::setBackend(const std::string& name)
{
    device_->setCurrentIndex(std::max(0, device_->findData(QString::fromStdString(name))));
}

bool RunPanel::canRun(QString* reason) const
{
    QString why = subject_->whyNot();
    if (why.isEmpty()) { why = forecasts_[chosen()].problem; }
    if (reason) { *reason = why; }
    return why.isEmpty() && !run_.running();
}

void RunPanel::refreshForecasts()
{
    ++asked_;
    forecasts_ = {};
    showState();
    if (!subject_->whyNot().isEmpty()) {
        forecaster_.drop();
        showForecasts();
        return;
    }
    forecaster_.run(
        [this, asked = asked_, find = subject_->forecast(fidelity(), expected_backend(backend()))](const NewestJob::Turn& turn) {
            const RunForecasts found = find(turn);
            turn.deliver([this, asked, found] {
                if (asked != asked_) { return; }
                forecasts_ = found;
                showForecasts();
                showState();
            });
        });
}

void RunPanel::showForecasts()
{
    for (std::size_t i = 0; i < forecasts_.size(); ++i) {
        expected_[i]->setText(forecasts_[i].text);
        expected_[i]->setToolTip(forecasts_[i].tip);
    }
}

void RunPanel::showState()
{
    QString reason;
    const bool can = canRun(&reason);
    const bool running = run_.running();
    pause_->setEnabled(running);
    stop_->setEnabled(running);
    start_->setEnabled(can);
    start_->setToolTip(can ? tr("Run the experiment on what is chosen (Ctrl+R).") : "<p>" + reason.toHtmlEscaped() + "</p>");
    bar_->setVisible(running);
    pause_->setText(run_.paused() ? tr("Resume") : tr("Pause"));
    pause_->setIcon(themedIcon(run_.paused() ? "run" : "pause"));
    pause_->setAccessibleName(pause_->text());
    pause_->setToolTip(run_.paused() ? tr("Resume the run.") : tr("Pause the run; its frames so far can be looked at."));
    why_->setEnabled(forecasts_[chosen()].plan.has_value());
    if (!running && !reason.isEmpty()) {
        state_->setText(tr("Cannot run: %1").arg(reason));
        state_->setToolTip("<p>" + reason.toHtmlEscaped() + "</p>");
        idle_ = true;
    } else if (idle_) {
        state_->setText(forecasts_[chosen()].about);
        state_->setToolTip({});
    }
    Q_EMIT canRunChanged();
}

void RunPanel::showProgress(const RunProgress& progress)
{
    if (!run_.running()) { return; }
    const double share = progress.duration > 0 ? progress.simulated / progress.duration : 0;
    bar_->setValue(static_cast<int>(1000 * share));
    QString text = progressText(progress, run_.paused());
    if (progress.particles > 0) { text += " " + tr("%1 particles of free liquid.").arg(progress.particles); }
    const bool of_other = running_ != subject_ && running_->shown().live();
    state_->setText(of_other ? tr("%1: %2").arg(running_->shown().title(), text) : text);
}

void RunPanel::showEnd(QueuedRun::Outcome outcome, const QString& sentence)
{
    switch (outcome) {
    case QueuedRun::Outcome::finished: state_->setText(tr("Finished.")); break;
    case QueuedRun::Outcome::cancelled: state_->setText(tr("Stopped.")); break;
    case QueuedRun::Outcome::memory_short:
    case QueuedRun::Outcome::device_failed:
    case QueuedRun::Outcome::failed: state_->setText(sentence); break;
    }
    refreshForecasts(); // which have learned from it
}

void RunPanel::showPlan()
{
    const auto& plan = forecasts_[chosen()].plan;
    if (!plan) { return; }
    const auto [what, experiment] = subject_->chosen();
    auto* dialog = new PlanDialog(*plan, what, experiment, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

} // namespace hygroloom
