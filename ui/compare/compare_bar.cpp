// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/compare_bar.h"

#include "ui/basics/appearance.h"
#include "ui/compare/study_runs.h"
#include "ui/results/plan_dialog.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace hygroloom {

namespace {

void keepRoom(QWidget* widget)
{
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
}

void fillBox(QComboBox& box, const QStringList& texts, int chosen)
{
    const QSignalBlocker quiet(&box);
    QStringList old;
    for (int i = 0; i < box.count(); ++i) { old << box.itemText(i); }
    if (old != texts) {
        box.clear();
        box.addItems(texts);
    }
    box.setCurrentIndex(chosen);
    box.setToolTip(box.currentText());
}

void addField(QHBoxLayout* row, const QString& name, QWidget* field)
{
    auto* label = new QLabel(name);
    label->setBuddy(field);
    field->setAccessibleName(QString(name).remove('&').remove(':'));
    row->addWidget(label);
    row->addWidget(field);
    row->addSpacing(6);
}

} // namespace

CompareBar::CompareBar(const StudyRuns& runs, QWidget* parent)
    : QWidget(parent), experiment_(new QComboBox), fidelity_(new QComboBox), part_(new QComboBox), replicates_(new QComboBox),
      run_(new QPushButton(themedIcon("run"), tr("&Run All Missing"))), state_(new QLabel), progress_(new QProgressBar),
      cancel_(new QPushButton(themedIcon("stop"), tr("&Cancel"))), filter_(new QLineEdit), card_(new QPushButton(tr("Card &Numbers"))),
      measured_(new QPushButton(tr("&Measured…"))), save_(new QPushButton(tr("Save &Table…"))),
      report_(new QPushButton(tr("Save Re&port…"))), runs_(runs)
{
    experiment_->setMinimumContentsLength(16);
    experiment_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const Fidelity each : all_fidelities) { fidelity_->addItem(fidelityName(each), static_cast<int>(each)); }
    fidelity_->setPlaceholderText(tr("reading…"));
    setFidelity(Fidelity::draft); // as Simulate does
    for (const int count : {1, 4, 8, 16}) { replicates_->addItem(QString::number(count), count); }
    replicates_->setToolTip("<p>" +
                            tr("Runs of each fabric. With more than one, all but the first have inputs drawn "
                               "within what is not known of the cloth; intervals then hold this scatter.") +
                            "</p>");
    progress_->setFixedWidth(120);
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress of the runs"));
    for (QWidget* widget : {static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)}) { keepRoom(widget); }
    state_->setForegroundRole(QPalette::PlaceholderText);
    state_->setAccessibleName(tr("Missing runs"));
    state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(8, 6, 8, 2);
    rows->setSpacing(6);
    auto* first = new QHBoxLayout;
    addField(first, tr("E&xperiment:"), experiment_);
    addField(first, tr("F&idelity:"), fidelity_);
    addField(first, tr("R&eplicates:"), replicates_);
    first->addWidget(run_);
    first->addWidget(state_, 1);
    first->addWidget(progress_);
    first->addWidget(cancel_);
    rows->addLayout(first);
    rows->addLayout(toolRow());

    connect(experiment_, &QComboBox::activated, this, &CompareBar::experimentChosen);
    connect(fidelity_, &QComboBox::activated, this, &CompareBar::fidelityChosen);
    connect(part_, &QComboBox::activated, this, &CompareBar::partChosen);
    connect(replicates_, &QComboBox::currentIndexChanged, this, &CompareBar::replicatesChosen);
    connect(run_, &QPushButton::clicked, this, &CompareBar::runAllRequested);
    connect(cancel_, &QPushButton::clicked, this, &CompareBar::cancelRequested);
    connect(filter_, &QLineEdit::textChanged, this, &CompareBar::filterChanged);
    connect(save_, &QPushButton::clicked, this, &CompareBar::saveRequested);
    connect(measured_, &QPushButton::clicked, this, &CompareBar::measuredRequested);
    connect(report_, &QPushButton::clicked, this, &CompareBar::reportRequested);
    showProgress();
}

/// The filter, and what can be done with the table.
QHBoxLayout* CompareBar::toolRow()
{
    filter_->setPlaceholderText(tr("Filter fabrics"));
    filter_->setAccessibleName(tr("Filter fabrics"));
    filter_->setClearButtonEnabled(true);
    filter_->setMaximumWidth(220);
    offerFiles(0);
    auto* tools = new QHBoxLayout;
    part_->setAccessibleName(tr("Part of the garment"));
    part_->setMinimumContentsLength(14);
    part_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    part_->setVisible(false);
    tools->addWidget(filter_, 1);
    tools->addWidget(part_);
    tools->addStretch(1);
    card_->setToolTip("<p>" + tr("Numbers of the technical card as columns: air, heat and vapour, water held, cost. They need no run.") +
                      "</p>");
    for (QPushButton* button : {card_, measured_, save_, report_}) { tools->addWidget(button); }
    return tools;
}

void CompareBar::setExperiments(const QStringList& names, int chosen) { fillBox(*experiment_, names, chosen); }

void CompareBar::setParts(const QStringList& titles, int chosen)
{
    fillBox(*part_, titles, chosen);
    part_->setVisible(!titles.isEmpty());
}

int CompareBar::part() const { return part_->currentIndex(); }

int CompareBar::experiment() const { return experiment_->currentIndex(); }

void CompareBar::setFidelity(Fidelity fidelity) { fidelity_->setCurrentIndex(fidelity_->findData(static_cast<int>(fidelity))); }

Fidelity CompareBar::fidelity() const
{
    const int named = fidelity_->currentIndex();
    return static_cast<Fidelity>(fidelity_->itemData(named < 0 ? unnamed_ : named).toInt());
}

void CompareBar::setReading(bool reading)
{
    const int named = fidelity_->currentIndex();
    if (reading && named >= 0) {
        unnamed_ = named;
        fidelity_->setCurrentIndex(-1);
    } else if (!reading && named < 0) {
        fidelity_->setCurrentIndex(unnamed_);
    }
}

int CompareBar::replicates() const { return replicates_->currentData().toInt(); }

void CompareBar::setReplicates(int count) { replicates_->setCurrentIndex(std::max(0, replicates_->findData(count))); }

void CompareBar::showReplicates(int count)
{
    const QSignalBlocker quiet(replicates_);
    setReplicates(count);
}

std::vector<int> CompareBar::replicateChoices() const
{
    std::vector<int> counts;
    counts.reserve(static_cast<std::size_t>(replicates_->count()));
    for (int i = 0; i < replicates_->count(); ++i) { counts.push_back(replicates_->itemData(i).toInt()); }
    return counts;
}

void CompareBar::offerFiles(std::size_t fabrics)
{
    const auto offer = [](QPushButton* button, bool can, const QString& tip, const QString& why_not) {
        button->setEnabled(can);
        button->setToolTip("<p>" + tip.toHtmlEscaped() + "</p>" + (can ? QString() : "<p>" + why_not.toHtmlEscaped() + "</p>"));
    };
    const QString several = tr("Choose one experiment, and run it on two fabrics at least.");
    offer(measured_, fabrics > 0,
          tr("Put a laboratory's numbers beside the simulated ones, from a CSV file with the columns fabric, metric, "
             "value, unit and, if known, spread."),
          tr("Choose one experiment, and run it on a fabric."));
    offer(save_, fabrics > 1, tr("Write the numbers as a CSV file for spreadsheets."), several);
    offer(report_, fabrics > 1, tr("Write verdicts, intervals, maps, curves, and what is not known, as PDF or web page."), several);
}

void CompareBar::setMissing(std::optional<int> runs, double seconds, const QString& why_not)
{
    run_->setEnabled(runs.value_or(0) > 0 && why_not.isEmpty());
    if (!why_not.isEmpty()) {
        missing_ = tr("Cannot run: %1").arg(why_not);
    } else if (!runs) {
        missing_ = tr("reading…");
    } else if (runs == 0) {
        missing_ = tr("Nothing is missing.");
    } else {
        const QString count = runs == 1 ? tr("1 run") : tr("%1 runs").arg(*runs);
        missing_ = seconds <= 0 ? count : tr("%1, %2").arg(count, roughDuration(seconds));
    }
    run_->setToolTip("<p>" + (why_not.isEmpty() ? tr("Run each fabric that has no run of this experiment yet.") : why_not).toHtmlEscaped() +
                     "</p>");
    showProgress();
}

void CompareBar::showProgress()
{
    const bool running = runs_.running();
    progress_->setVisible(running);
    cancel_->setVisible(running);
    QString text = missing_;
    if (running) {
        progress_->setValue(static_cast<int>(1000 * runs_.share()));
        text = runs_.stateText();
    }
    said_ = text;
    state_->setToolTip("<p>" + text.toHtmlEscaped() + "</p>");
    state_->setAccessibleDescription(text);
    elide();
}

/// A sentence that is too long ends in dots, and stands in the tool tip.
void CompareBar::elide() { state_->setText(state_->fontMetrics().elidedText(said_, Qt::ElideRight, state_->width())); }

void CompareBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    layout()->activate();
    elide();
}

} // namespace hygroloom
