// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/simulation_panel.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/plan/expectation.h"
#include "core/plan/frame_times.h"
#include "core/run/plan_run.h"
#include "gpu/backends.h"
#include "ui/basics/appearance.h"
#include "ui/basics/elided_combo.h"
#include "ui/basics/elided_label.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/quantity.h"
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

SimulationPanel::SimulationPanel(Document& document, SimulationRun& run, QWidget* parent)
    : QWidget(parent), document_(document), run_(run), fidelities_(new QButtonGroup(this)), device_(new ElidedCombo),
      start_(new QPushButton(themedIcon("run"), tr("Run"))), pause_(new QPushButton(themedIcon("pause"), tr("Pause"))),
      stop_(new QPushButton(themedIcon("stop"), tr("Stop"))),
      why_(new QPushButton(themedIcon("plan"), tr("What will be modelled, and why…"))), bar_(new QProgressBar), state_(new QLabel)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    addFidelities();
    addDevices();
    why_->setFlat(true);
    why_->setToolTip(tr("Which physics the next run models, and the reasons."));
    layout->addWidget(why_, 0, Qt::AlignLeft);
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
    layout->addLayout(buttons);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(8);
    bar_->setRange(0, 1000);
    // The panel must not change its height when a run begins.
    QSizePolicy policy = bar_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    bar_->setSizePolicy(policy);
    bar_->setAccessibleName(tr("Progress of the run"));
    layout->addWidget(bar_);
    state_->setWordWrap(true);
    state_->setTextFormat(Qt::PlainText); // names of files and fabrics
    state_->setMinimumHeight(4 * state_->fontMetrics().lineSpacing());
    state_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    state_->setAccessibleName(tr("State of the run"));
    layout->addWidget(state_);
    layout->addStretch();
    for (QPushButton* button : {start_, pause_, stop_, why_}) { button->setAccessibleName(button->text()); }

    connect(start_, &QPushButton::clicked, this, &SimulationPanel::runRequested);
    connect(pause_, &QPushButton::clicked, this, [this] { run_.setPaused(!run_.paused()); });
    connect(stop_, &QPushButton::clicked, this, &SimulationPanel::stopRequested);
    connect(why_, &QPushButton::clicked, this, &SimulationPanel::showPlan);
    connect(&run_, &SimulationRun::begun, this, [this] {
        bar_->setValue(0);
        showState();
        state_->setText(tr("Starting."));
    });
    connect(&run_, &SimulationRun::progressed, this, &SimulationPanel::showProgress);
    connect(&run_, &SimulationRun::ended, this, &SimulationPanel::showEnd);
    connect(&run_, &SimulationRun::pausedChanged, this, &SimulationPanel::showState);
    connect(&document_, &Document::designChanged, this, &SimulationPanel::refreshPlans);
    connect(&run_, &SimulationRun::ended, this, &SimulationPanel::refreshPlans);
    refreshPlans();
}

void SimulationPanel::addFidelities()
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
        // What is expected comes late, and must not widen the panel then: room for it is kept, also for longer numbers.
        const QString longest = tr("about 4 min, 38 MB, error ≈ 14 %") + QStringLiteral("000");
        expected_[i]->setMinimumWidth(expected_[i]->fontMetrics().horizontalAdvance(longest));
        expected_[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        grid->addWidget(button, static_cast<int>(i), 0);
        grid->addWidget(expected_[i], static_cast<int>(i), 1);
    }
    setFidelity(Fidelity::draft);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
    connect(fidelities_, &QButtonGroup::idClicked, this, [this] { Q_EMIT canRunChanged(); });
}

void SimulationPanel::addDevices()
{
    fillDevices(*device_);
    connect(device_, &QComboBox::currentIndexChanged, this, &SimulationPanel::refreshPlans);
    device_->setAccessibleName(tr("Device"));
    device_->setToolTip(tr("Processor that runs the simulation."));
    device_->setMinimumContentsLength(12);
    device_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    static_cast<QVBoxLayout*>(layout())->addWidget(device_);
}

Fidelity SimulationPanel::fidelity() const { return all_fidelities[static_cast<std::size_t>(std::max(0, fidelities_->checkedId()))]; }

void SimulationPanel::setFidelity(Fidelity fidelity)
{
    for (std::size_t i = 0; i < all_fidelities.size(); ++i) {
        if (all_fidelities[i] == fidelity) { fidelities_->button(static_cast<int>(i))->setChecked(true); }
    }
    Q_EMIT canRunChanged();
}

std::string SimulationPanel::backend() const { return device_->count() > 0 ? device_->currentData().toString().toStdString() : "auto"; }

void SimulationPanel::setBackend(const std::string& name)
{
    device_->setCurrentIndex(std::max(0, device_->findData(QString::fromStdString(name))));
}

bool SimulationPanel::canRun(QString* reason) const
{
    QString why;
    if (!document_.fabric()) {
        why = tr("Add a fabric to run an experiment on.");
    } else if (!document_.experiment()) {
        why = tr("Add an experiment to run.");
    } else if (document_.hasError()) {
        for (const Issue& issue : document_.issues()) {
            if (issue.severity == Severity::error) {
                why = issueText(issue);
                break;
            }
        }
    } else {
        why = plans_[static_cast<std::size_t>(std::max(0, fidelities_->checkedId()))].problem;
    }
    if (reason) { *reason = why; }
    return why.isEmpty() && !run_.running();
}

void SimulationPanel::refreshPlans()
{
    plans_ = {};
    showState();
    if (document_.hasError() || !document_.fabric() || !document_.experiment()) {
        planner_.drop();
        showExpectations();
        return;
    }
    planner_.run([this, design = document_.design(), fabric = document_.fabricIndex(), experiment = document_.experimentIndex(),
                  fitted = document_.fitted(), machine = expected_backend(backend())](const NewestJob::Turn& turn) {
        std::array<Expectation, all_fidelities.size()> plans;
        const Experiment& test = design->experiments[static_cast<std::size_t>(experiment)];
        std::optional<Textile> textile;
        for (std::size_t i = 0; i < plans.size() && !turn.outdated(); ++i) {
            try {
                if (!textile) { textile = textile_of_run(*design, design->fabrics[static_cast<std::size_t>(fabric)], test, fitted.get()); }
                plans[i].plan = plan_run(*design, *textile, test, all_fidelities[i], {}, {}, machine);
                plans[i].plan->expected_seconds = seconds_to_wait(*plans[i].plan, true); // the window records each run
            } catch (const Error& error) {
                plans[i].problem = QString::fromStdString(error.what());
            }
        }
        turn.deliver([this, design, plans] {
            if (design == document_.design()) {
                plans_ = plans;
                showExpectations();
                showState();
            }
        });
    });
}

void SimulationPanel::showExpectations()
{
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        const auto& plan = plans_[i].plan;
        expected_[i]->setText(plan ? shortExpectation(*plan) : QString());
        expected_[i]->setToolTip(plan ? "<p>" + tr("Expected: %1").arg(expectation(*plan)) + "</p>" : QString());
    }
}

void SimulationPanel::showState()
{
    QString reason;
    const bool can = canRun(&reason);
    const bool running = run_.running();
    pause_->setEnabled(running);
    stop_->setEnabled(running);
    start_->setEnabled(can);
    start_->setToolTip(can ? tr("Run the experiment on the selected fabric (Ctrl+R).") : "<p>" + reason.toHtmlEscaped() + "</p>");
    bar_->setVisible(running);
    pause_->setText(run_.paused() ? tr("Resume") : tr("Pause"));
    pause_->setIcon(themedIcon(run_.paused() ? "run" : "pause"));
    pause_->setAccessibleName(pause_->text());
    why_->setEnabled(plans_[static_cast<std::size_t>(std::max(0, fidelities_->checkedId()))].plan.has_value());
    if (!running && !reason.isEmpty()) {
        state_->setText(tr("Cannot run: %1").arg(reason));
        state_->setToolTip("<p>" + reason.toHtmlEscaped() + "</p>");
    } else if (!running && state_->text().startsWith(tr("Cannot run: %1").arg(QString()))) {
        state_->clear();
        state_->setToolTip({});
    }
    Q_EMIT canRunChanged();
}

void SimulationPanel::showProgress(const RunProgress& progress)
{
    if (!run_.running()) { return; }
    const double share = progress.duration > 0 ? progress.simulated / progress.duration : 0;
    bar_->setValue(static_cast<int>(1000 * share));
    QString text = progressText(progress, run_.paused());
    if (progress.particles > 0) { text += " " + tr("%1 particles of free liquid.").arg(progress.particles); }
    state_->setText(text);
}

void SimulationPanel::showEnd(SimulationRun::Outcome outcome, const QString& sentence)
{
    switch (outcome) {
    case SimulationRun::Outcome::finished: state_->setText(tr("Finished.")); break;
    case SimulationRun::Outcome::cancelled: state_->setText(tr("Stopped.")); break;
    case SimulationRun::Outcome::memory_short:
    case SimulationRun::Outcome::device_failed:
    case SimulationRun::Outcome::failed: state_->setText(sentence); break;
    }
    showState();
}

void SimulationPanel::showPlan()
{
    const auto& plan = plans_[static_cast<std::size_t>(std::max(0, fidelities_->checkedId()))].plan;
    if (!plan || !document_.fabric() || !document_.experiment()) { return; }
    auto* dialog =
        new PlanDialog(*plan, QString::fromStdString(document_.fabric()->name), QString::fromStdString(document_.experiment()->name), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

} // namespace hygroloom
