// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/run_list.h"

#include "core/base/text.h"
#include "ui/basics/quantity.h"
#include "ui/results/plan_dialog.h"
#include "ui/results/results_panel.h"
#include "ui/results/run_actions.h"

#include <QDir>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

/// What there is to say of where a run stands.
QString stateOf(const KeptRun& run, const Design& design)
{
    QStringList words;
    if (run.marked) { words << RunList::tr("kept"); }
    if (!run.current) {
        const QString differs = differencesOf(*run.run, design).join(", ");
        const bool same_design = differs == RunHistory::tr("program");
        const QString of = run.own ? RunList::tr("older design") : RunList::tr("other design");
        words << (same_design ? RunList::tr("older program") : differs.isEmpty() ? of : RunList::tr("%1: %2").arg(of, differs));
    }
    if (!isSaved(run)) { words << RunList::tr("not saved"); }
    return words.join(", ");
}

} // namespace

QString nameOfRun(const RunHistory& history, const KeptRun& run)
{
    const auto& runs = history.runs();
    const auto same = std::count_if(runs.begin(), runs.end(), [&run](const KeptRun& other) {
        return other.worn == run.worn && other.run->fabric == run.run->fabric && other.cloth() == run.cloth();
    });
    QString name = QString::fromStdString(run.run->fabric);
    if (const std::string cloth = run.cloth(); run.worn && !cloth.empty()) {
        name = RunList::tr("%1 of %2").arg(name, QString::fromStdString(cloth));
    }
    return same > 1 ? RunList::tr("%1: %2").arg(run.number).arg(name) : name;
}

RunList::RunList(RunHistory& history, std::function<QString(const KeptRun&)> why_not, QWidget* parent)
    : QWidget(parent), history_(history), why_not_(std::move(why_not)), list_(new QTreeWidget), actions_(new RunActions(history))
{
    build();
}

RunList::RunList(RunHistory& history, QWidget* parent)
    : QWidget(parent), history_(history), list_(new QTreeWidget), actions_(new RunActions(history))
{
    build();
    connect(&history_, &RunHistory::changed, this, [this] { refresh({}); });
    refresh({});
}

void RunList::build()
{
    list_->setAccessibleName(hasTicks() ? tr("Runs to compare") : tr("Runs of the project"));
    list_->setHeaderLabels({tr("Fabric or garment"), tr("Experiment"), tr("Fidelity"), tr("Took"), tr("Size"), tr("State")});
    list_->setRootIsDecorated(false);
    list_->setTextElideMode(Qt::ElideMiddle); // names often differ at their end
    list_->setFrameShape(QFrame::NoFrame);
    list_->setMinimumSize(240, 80);
    list_->setToolTip(hasTicks() ? tr("Tick two to four runs of the same experiment. Double-click one to open it.")
                                 : tr("Double-click a run, or press Enter, to show it."));
    connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        const QString path = item->data(0, Qt::UserRole).toString();
        const bool on = item->checkState(0) == Qt::Checked;
        // The list is rebuilt, but not while one of its items is being changed.
        QMetaObject::invokeMethod(
            this, [this, path, on] { Q_EMIT tickRequested(path, on); }, Qt::QueuedConnection);
    });
    connect(list_, &QTreeWidget::itemActivated, this,
            [this](QTreeWidgetItem* item) { Q_EMIT openRequested(item->data(0, Qt::UserRole).toString()); });
    connect(list_, &QTreeWidget::currentItemChanged, actions_,
            [this](QTreeWidgetItem* item) { actions_->setRun(item ? item->data(0, Qt::UserRole).toString() : QString()); });
    connect(actions_, &RunActions::markRequested, this, &RunList::markRequested);
    connect(actions_, &RunActions::forgetRequested, this, &RunList::forgetRequested);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(list_, 1);
    column->addWidget(actions_);
}

void RunList::refresh(const QStringList& ticked)
{
    const QSignalBlocker quiet(list_);
    const QTreeWidgetItem* current = list_->currentItem();
    const QString at = current ? current->data(0, Qt::UserRole).toString() : QString();
    list_->clear();
    for (const KeptRun& run : history_.runs()) {
        auto* item = new QTreeWidgetItem(list_);
        fill(item, run, ticked.contains(run.path));
        if (run.path == at) { list_->setCurrentItem(item); }
    }
    actions_->setRun(list_->currentItem() ? at : QString());
    for (int column = 0; column < list_->columnCount(); ++column) { list_->resizeColumnToContents(column); }
    list_->setColumnWidth(0, std::min(list_->columnWidth(0), 260));
    list_->setColumnWidth(1, std::min(list_->columnWidth(1), 200));
}

void RunList::fill(QTreeWidgetItem* item, const KeptRun& run, bool ticked)
{
    item->setData(0, Qt::UserRole, run.path);
    item->setText(0, nameOfRun(history_, run));
    item->setText(1, QString::fromStdString(run.run->experiment));
    item->setText(2, fidelityName(run.run->plan.fidelity));
    item->setText(3, run.complete() ? tr("%1 s").arg(shownNumber(run.run->wall, decimals_for(run.run->wall, 2))) : tr("stopped"));
    item->setText(4, bytesText(run.bytes));
    item->setText(5, stateOf(run, *history_.design()));
    const QString why = hasTicks() ? why_not_(run) : run.problem;
    const QString origin = run.worn ? QString::fromStdString(run.run->date + ", " + run.run->device) : originOf(*run.run, false);
    const QString name = item->text(0) + ", " + item->text(1);
    const QString tip = name + ". " + (why.isEmpty() ? origin : why) + ". " + QDir::toNativeSeparators(run.path);
    if (hasTicks()) { item->setCheckState(0, ticked ? Qt::Checked : Qt::Unchecked); }
    if (!why.isEmpty()) { item->setFlags(item->flags() & ~Qt::ItemIsUserCheckable); }
    for (int column = 0; column < list_->columnCount(); ++column) {
        item->setToolTip(column, "<p>" + tip.toHtmlEscaped() + "</p>");
        if (!why.isEmpty()) { item->setForeground(column, palette().color(QPalette::Disabled, QPalette::Text)); }
    }
}

} // namespace hygroloom
