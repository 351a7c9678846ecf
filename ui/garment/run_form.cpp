// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/run_form.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "gpu/backends.h"
#include "ui/basics/appearance.h"
#include "ui/basics/elided_combo.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/garment/worn_run.h"
#include "ui/results/device_choice.h"
#include "ui/results/plan_dialog.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace hygroloom {

RunForm::RunForm(GarmentChoice& choice, GarmentRun& run, QWidget* parent)
    : QWidget(parent), choice_(choice), run_(run), fidelities_(new QButtonGroup(this)), expected_(new QLabel), device_(new ElidedCombo),
      start_(new QPushButton(themedIcon("run"), tr("Run"))), pause_(new QPushButton(themedIcon("pause"), tr("Pause"))),
      stop_(new QPushButton(themedIcon("stop"), tr("Stop"))), bar_(new QProgressBar), state_(new QLabel)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    addFidelities();
    addDevices();
    auto* buttons = new QHBoxLayout; // each keeps its place
    buttons->setSpacing(6);
    QFont bold = start_->font();
    bold.setBold(true);
    start_->setFont(bold);
    pause_->setMinimumWidth(std::max(pause_->sizeHint().width(), QPushButton(themedIcon("run"), tr("Resume")).sizeHint().width()));
    for (QPushButton* button : {start_, pause_, stop_}) {
        button->setMinimumHeight(36);
        button->setAccessibleName(button->text());
        buttons->addWidget(button, button == start_ ? 1 : 0);
    }
    layout->addLayout(buttons);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(8);
    bar_->setRange(0, 1000);
    QSizePolicy policy = bar_->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // nothing moves when a run begins
    bar_->setSizePolicy(policy);
    bar_->setAccessibleName(tr("Progress of the run"));
    layout->addWidget(bar_);
    state_->setWordWrap(true);
    state_->setTextFormat(Qt::PlainText);
    state_->setMinimumHeight(4 * state_->fontMetrics().lineSpacing());
    state_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    state_->setAccessibleName(tr("State of the run"));
    layout->addWidget(state_);
    layout->addStretch();
    connect(start_, &QPushButton::clicked, this, [this] { start(); });
    connect(pause_, &QPushButton::clicked, this, [this] { run_.setPaused(!run_.paused()); });
    connect(stop_, &QPushButton::clicked, this, &RunForm::stopRequested);
    connect(&run_, &GarmentRun::pausedChanged, this, [this](bool paused) {
        showState();
        if (run_.running()) { state_->setText(paused ? tr("Paused.") : tr("Resuming.")); }
    });
    connect(&run_, &GarmentRun::progressed, this, &RunForm::showProgress);
    connect(&run_, &GarmentRun::ended, this, &RunForm::showEnd);
    connect(&choice_, &GarmentChoice::changed, this, &RunForm::estimate);
    connect(&choice_, &GarmentChoice::drawingChanged, this, &RunForm::estimate);
    estimate();
}

void RunForm::addFidelities()
{
    auto* row = new QHBoxLayout;
    const QString tips[] = {tr("Cells about 12 mm wide."), tr("Cells about 6 mm wide."), tr("Cells about 3 mm wide."),
                            tr("Cells about 1.5 mm wide.")};
    for (std::size_t i = 0; i < all_fidelities.size(); ++i) {
        auto* button = new QRadioButton(fidelityName(all_fidelities[i]));
        button->setAccessibleName(tr("Fidelity: %1").arg(button->text()));
        button->setToolTip(tips[i]);
        fidelities_->addButton(button, static_cast<int>(i));
        row->addWidget(button);
    }
    row->addStretch();
    setFidelity(Fidelity::draft);
    connect(fidelities_, &QButtonGroup::idClicked, this, &RunForm::estimate);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    expected_->setForegroundRole(QPalette::PlaceholderText);
    expected_->setAccessibleName(tr("Expected"));
    expected_->setWordWrap(true);
    expected_->setMinimumHeight(2 * expected_->fontMetrics().lineSpacing());
    expected_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    layout()->addWidget(expected_);
}

void RunForm::addDevices()
{
    fillDevices(*device_);
    device_->setAccessibleName(tr("Device"));
    device_->setToolTip(tr("Processor that runs the experiment."));
    device_->setMinimumContentsLength(8);
    device_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    layout()->addWidget(device_);
}

Fidelity RunForm::fidelity() const { return all_fidelities[static_cast<std::size_t>(std::max(0, fidelities_->checkedId()))]; }

void RunForm::setFidelity(Fidelity fidelity)
{
    for (std::size_t i = 0; i < all_fidelities.size(); ++i) {
        if (all_fidelities[i] == fidelity) { fidelities_->button(static_cast<int>(i))->setChecked(true); }
    }
    estimate();
}

std::string RunForm::backend() const { return device_->count() > 0 ? device_->currentData().toString().toStdString() : "auto"; }

bool RunForm::canRun(QString* reason) const
{
    QString why;
    if (!choice_.garment()) {
        why = tr("Add a garment.");
    } else if (!choice_.wear()) {
        why = tr("Add an experiment on this garment.");
    } else if (!choice_.problem().isEmpty()) {
        why = choice_.problem();
    } else {
        for (const Issue& issue : choice_.document().issues()) {
            if (issue.severity == Severity::error) {
                why = issueText(issue);
                break;
            }
        }
    }
    if (reason) { *reason = why; }
    return why.isEmpty() && !run_.running() && choice_.drawing();
}

void RunForm::start(bool beyond_memory)
{
    if (!canRun()) { return; }
    RunOptions options;
    options.fidelity = fidelity();
    options.memory.force = beyond_memory;
    options.threads = preferences().threads;
    options.may_go_on_on_cpu = true;
    if (place_) {
        const QString file = place_();
        if (file.isEmpty()) { return; }
        options.recording = file.toStdString();
    }
    run_.start(choice_.document().design(), choice_.wear()->name, choice_.base(), options, backend());
    bar_->setValue(0);
    state_->setText(tr("Cutting the garment into cells."));
    showState();
}

/// What the run is expected to take: the garment is cut into cells for it, beside the window.
void RunForm::estimate()
{
    expected_->clear();
    showState();
    QString reason;
    canRun(&reason);
    if (!reason.isEmpty() || !choice_.drawing()) {
        planner_.drop();
        return;
    }
    planner_.run([this, design = choice_.document().design(), wear = choice_.wear()->name, base = choice_.base(), fidelity = fidelity(),
                  backend = backend()](const NewestJob::Turn& turn) {
        QString text;
        try {
            const GarmentParts parts = garment_parts(*design, *find_wear(*design, wear), base, [&turn] { return turn.outdated(); });
            RunOptions options;
            options.fidelity = fidelity;
            if (turn.outdated()) { return; }
            const GarmentScene scene = garment_scene(parts, resolution_of(options));
            const WearPlan plan = plan_wear(scene, *parts.wear, fidelity, expected_backend(backend));
            const QString form = plan.time.learned.empty() ? tr("%1 %2, %3; %4 on two cores.") : tr("%1 %2, %3; %4 on this machine.");
            text = form.arg(plan.cells)
                       .arg(cellsText(wear_layout(parts, scene).cells_in_words), bytesText(plan.bytes), roughDuration(plan.time.seconds));
        } catch (const Cancelled&) {
            return;
        } catch (const NotEnoughMemory& error) {
            text = tr("This run takes about %1 of memory; %2 are free.").arg(bytesText(error.needed), bytesText(error.available));
        } catch (const std::exception& error) {
            text = QString::fromUtf8(error.what());
        }
        turn.deliver([this, design, text] {
            if (design == choice_.document().design()) { expected_->setText(text); }
        });
    });
}

void RunForm::showState()
{
    QString reason;
    const bool can = canRun(&reason);
    start_->setEnabled(can);
    pause_->setEnabled(run_.computing());
    pause_->setText(run_.paused() ? tr("Resume") : tr("Pause"));
    pause_->setIcon(themedIcon(run_.paused() ? "run" : "pause"));
    pause_->setAccessibleName(pause_->text());
    pause_->setToolTip(run_.paused() ? tr("Resume the run.") : tr("Pause the run; its frames so far can be looked at."));
    stop_->setEnabled(run_.running());
    bar_->setVisible(run_.running());
    start_->setToolTip(can ? tr("Run the experiment on this garment (Ctrl+R).") : "<p>" + reason.toHtmlEscaped() + "</p>");
    if (!run_.running() && !reason.isEmpty()) {
        state_->setText(tr("Cannot run: %1").arg(reason));
        blocked_ = true;
    } else if (blocked_) {
        state_->clear();
        blocked_ = false;
    }
    Q_EMIT canRunChanged();
}

void RunForm::showProgress(const RunProgress& progress)
{
    if (!run_.running()) { return; }
    const double share = progress.duration > 0 ? progress.simulated / progress.duration : 0;
    bar_->setValue(static_cast<int>(1000 * share));
    state_->setText(progressText(progress, run_.paused()));
}

void RunForm::showEnd(GarmentRun::Outcome outcome, const QString& sentence)
{
    switch (outcome) {
    case GarmentRun::Outcome::finished:
        state_->setText(tr("Finished."));
        estimate(); // which has learned from it
        break;
    case GarmentRun::Outcome::cancelled: state_->setText(tr("Stopped.")); break;
    case GarmentRun::Outcome::device_failed:
    case GarmentRun::Outcome::memory_short:
    case GarmentRun::Outcome::failed: state_->setText(sentence); break;
    }
    showState();
}

} // namespace hygroloom
