// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/compare_view.h"

#include "core/analysis/comparison.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/atomic_file.h"
#include "ui/basics/quantity.h"
#include "ui/results/compare_maps.h"
#include "ui/results/results_panel.h"
#include "ui/results/run_actions.h"

#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>

namespace hygroloom {

namespace {

QString fabricOf(const KeptRun& run) { return QString::fromStdString(run.run->fabric); }

/// What there is to say of where a run stands.
QString stateOf(const KeptRun& run)
{
    QStringList words;
    if (run.marked) { words << CompareView::tr("kept"); }
    if (!run.current) { words << (run.own ? CompareView::tr("older design") : CompareView::tr("other design")); }
    if (!isSaved(run)) { words << CompareView::tr("not saved"); }
    return words.join(", ");
}

QString verdictText(Verdict verdict)
{
    switch (verdict) {
    case Verdict::better: return CompareView::tr("better");
    case Verdict::probably_better: return CompareView::tr("probably better");
    case Verdict::no_difference: return CompareView::tr("no difference shown");
    case Verdict::probably_worse: return CompareView::tr("probably worse");
    case Verdict::worse: return CompareView::tr("worse");
    }
    return {};
}

/// A number with its interval, and a line with the verdict against the baseline.
QTableWidgetItem* cellOf(const Comparison& comparison, const Candidate& candidate, const OutcomeInfo& criterion)
{
    auto* item = new QTableWidgetItem;
    const auto found = candidate.intervals.find(criterion.key);
    if (found == candidate.intervals.end()) {
        item->setText(QStringLiteral("–"));
        item->setToolTip(CompareView::tr("This run does not give this number."));
        return item;
    }
    const ShownInterval seen = shown(criterion, found->second);
    QString text = shownNumber(seen.value, seen.decimals);
    if (seen.half > 0) { text += QStringLiteral(" ± ") + shownNumber(seen.half, seen.decimals); }
    if (!seen.unit.empty()) { text += QChar(0x00a0) + QString::fromStdString(seen.unit); }
    QString tip = found->second.numerical_known ? CompareView::tr("After ±: the numerical error, as measured on runs of this kind.")
                                                : CompareView::tr("The numerical error of this number is not known.");
    for (const Compared& verdict : comparison.verdicts) {
        if (verdict.fabric != candidate.fabric || verdict.metric != criterion.key) { continue; }
        text += "\n" + verdictText(verdict.verdict);
        tip += " " + (criterion.better == Better::less ? CompareView::tr("Smaller is better.") : CompareView::tr("Larger is better."));
    }
    item->setText(text);
    item->setToolTip("<p>" + tip.toHtmlEscaped() + "</p>");
    return item;
}

} // namespace

CompareView::CompareView(RunHistory& history, QWidget* parent)
    : QWidget(parent), history_(history), list_(new QTreeWidget), actions_(new RunActions(history)), table_(new QTableWidget),
      maps_(new CompareMaps), origin_(new QLabel), save_(new QPushButton(tr("Save &Table…")))
{
    auto* numbers = new QWidget;
    auto* column = new QVBoxLayout(numbers);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    table_->setAccessibleName(tr("Numbers of the compared runs"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setTabKeyNavigation(false); // Tab leaves it; arrow keys go through it
    table_->setMinimumSize(200, 120);
    column->addWidget(table_, 1);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(8, 0, 8, 4);
    origin_->setWordWrap(true);
    origin_->setForegroundRole(QPalette::PlaceholderText);
    foot->addWidget(origin_, 1);
    save_->setToolTip(tr("Write the numbers as a CSV file for spreadsheets."));
    foot->addWidget(save_);
    column->addLayout(foot);
    connect(save_, &QPushButton::clicked, this, &CompareView::saveTable);
    connect(table_->horizontalHeader(), &QHeaderView::sectionClicked, this, [this](int column) {
        const std::vector<KeptRun> runs = compared();
        if (static_cast<std::size_t>(column) < runs.size()) { setBaseline(runs[static_cast<std::size_t>(column)].path); }
    });

    auto* upper = new QSplitter(Qt::Horizontal);
    upper->setChildrenCollapsible(false);
    upper->addWidget(buildList());
    upper->addWidget(numbers);
    upper->setSizes({520, 640});
    auto* parts = new QSplitter(Qt::Vertical);
    parts->setChildrenCollapsible(false);
    parts->addWidget(upper);
    parts->addWidget(maps_);
    parts->setSizes({260, 440});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(parts);
    connect(maps_, &CompareMaps::mapsChanged, this, &CompareView::mapsChanged);
    connect(&history_, &RunHistory::changed, this, &CompareView::refresh);
    refresh();
}

QWidget* CompareView::buildList()
{
    list_->setAccessibleName(tr("Runs to compare"));
    list_->setHeaderLabels({tr("Fabric"), tr("Experiment"), tr("Fidelity"), tr("Took"), tr("Size"), tr("State")});
    list_->setRootIsDecorated(false);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setMinimumSize(240, 120);
    list_->header()->setStretchLastSection(false);
    list_->setToolTip(tr("Tick two to four runs of the same experiment. Double-click one to open it."));
    connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        const QString path = item->data(0, Qt::UserRole).toString();
        const bool on = item->checkState(0) == Qt::Checked;
        // The list is rebuilt, but not while one of its items is being changed.
        QMetaObject::invokeMethod(
            this, [this, path, on] { choose(path, on); }, Qt::QueuedConnection);
    });
    connect(list_, &QTreeWidget::itemActivated, this,
            [this](QTreeWidgetItem* item) { Q_EMIT runRequested(item->data(0, Qt::UserRole).toString()); });
    connect(list_, &QTreeWidget::currentItemChanged, actions_,
            [this](QTreeWidgetItem* item) { actions_->setRun(item ? item->data(0, Qt::UserRole).toString() : QString()); });
    connect(actions_, &RunActions::markRequested, this, &CompareView::markRequested);
    connect(actions_, &RunActions::forgetRequested, this, &CompareView::forgetRequested);
    auto* both = new QWidget;
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(list_, 1);
    column->addWidget(actions_);
    return both;
}

QString CompareView::nameOf(const KeptRun& run) const
{
    const auto& runs = history_.runs();
    const auto same =
        std::count_if(runs.begin(), runs.end(), [&run](const KeptRun& other) { return other.run->fabric == run.run->fabric; });
    return same > 1 ? tr("%1: %2").arg(run.number).arg(fabricOf(run)) : fabricOf(run);
}

std::vector<KeptRun> CompareView::compared() const
{
    std::vector<KeptRun> runs;
    for (const KeptRun& run : history_.runs()) {
        if (chosen_.contains(run.path)) { runs.push_back(run); }
    }
    return runs;
}

QString CompareView::whyNot(const KeptRun& run) const
{
    const std::vector<KeptRun> others = compared();
    const bool alone = others.empty() || (others.size() == 1 && others.front().path == run.path);
    const QString why = whyNotCompared(run, alone ? run : others.front());
    const bool full = others.size() >= most_runs && !chosen_.contains(run.path);
    return why.isEmpty() && full ? tr("At most four runs can be compared.") : why;
}

void CompareView::choose(const QString& path, bool on)
{
    const KeptRun* run = history_.find(path);
    proposing_ = false;
    if (on && run && !chosen_.contains(path) && whyNot(*run).isEmpty()) {
        chosen_ << path;
    } else if (!on) {
        chosen_.removeAll(path);
    }
    refresh();
}

void CompareView::setBaseline(const QString& path)
{
    baseline_ = path;
    refreshTable();
}

void CompareView::setWaterColors(WaterColors colors) { maps_->setWaterColors(colors); }

const std::vector<WaterMap*>& CompareView::maps() const { return maps_->maps(); }

QImage CompareView::picture() const { return maps_->maps().empty() ? QImage() : maps_->grab().toImage(); }

/// The newest run of each fabric that goes with the newest of all.
void CompareView::propose()
{
    chosen_.clear();
    QStringList fabrics;
    const auto& runs = history_.runs();
    for (auto run = runs.rbegin(); run != runs.rend() && chosen_.size() < most_runs; ++run) {
        if (whyNotCompared(*run, chosen_.isEmpty() ? *run : *history_.find(chosen_.front())).isEmpty() &&
            !fabrics.contains(fabricOf(*run))) {
            chosen_ << run->path;
            fabrics << fabricOf(*run);
        }
    }
}

void CompareView::refresh()
{
    if (proposing_) { propose(); }
    chosen_.removeIf([this](const QString& path) { return !history_.find(path); });
    refreshList();
    refreshTable();
    refreshMaps();
}

void CompareView::refreshList()
{
    const QSignalBlocker quiet(list_);
    const QTreeWidgetItem* current = list_->currentItem();
    const QString at = current ? current->data(0, Qt::UserRole).toString() : QString();
    list_->clear();
    for (const KeptRun& run : history_.runs()) {
        auto* item = new QTreeWidgetItem(list_);
        item->setData(0, Qt::UserRole, run.path);
        const QString fidelity = QString::fromLatin1(name_of(run.run->plan.fidelity));
        item->setText(0, nameOf(run));
        item->setText(1, QString::fromStdString(run.run->experiment));
        item->setText(2, fidelity.left(1).toUpper() + fidelity.mid(1));
        item->setText(3, run.complete() ? tr("%1 s").arg(shownNumber(run.run->wall, decimals_for(run.run->wall, 2))) : tr("stopped"));
        item->setText(4, bytesText(run.bytes));
        item->setText(5, stateOf(run));
        const QString why = whyNot(run);
        const QString tip = (why.isEmpty() ? originOf(*run.run, false) : why) + ". " + QDir::toNativeSeparators(run.path);
        item->setCheckState(0, chosen_.contains(run.path) ? Qt::Checked : Qt::Unchecked);
        if (!why.isEmpty()) { item->setFlags(item->flags() & ~Qt::ItemIsUserCheckable); }
        for (int column = 0; column < list_->columnCount(); ++column) {
            item->setToolTip(column, "<p>" + tip.toHtmlEscaped() + "</p>");
            if (!why.isEmpty()) { item->setForeground(column, palette().color(QPalette::Disabled, QPalette::Text)); }
        }
        if (run.path == at) { list_->setCurrentItem(item); }
    }
    actions_->setRun(list_->currentItem() ? at : QString());
    for (int column = 0; column < list_->columnCount(); ++column) { list_->resizeColumnToContents(column); }
    list_->setColumnWidth(0, std::min(list_->columnWidth(0), 220));
    list_->setColumnWidth(1, std::min(list_->columnWidth(1), 160));
}

Comparison CompareView::comparison() const
{
    const std::vector<KeptRun> runs = compared();
    Comparison made;
    if (runs.empty()) { return made; }
    const Experiment* experiment = find_experiment(runs.front().run->design, runs.front().run->experiment);
    made.experiment = runs.front().run->experiment;
    if (experiment) { made.criteria = compared_by(experiment->type); }
    if (made.criteria.empty()) { return made; }
    made.ranked_by = made.criteria.front();
    for (const KeptRun& run : runs) {
        made.candidates.push_back(candidate_of(run.run, run.metrics));
        made.candidates.back().fabric = nameOf(run).toStdString();
        if (made.baseline.empty() || run.path == baseline_) { made.baseline = made.candidates.back().fabric; }
    }
    made.complete = true;
    return made;
}

void CompareView::refreshTable()
{
    Comparison numbers = comparison();
    const std::vector<Candidate> columns = numbers.candidates; // as they stand in the list
    judge(numbers);
    table_->clear();
    table_->setRowCount(static_cast<int>(numbers.criteria.size()));
    table_->setColumnCount(static_cast<int>(numbers.candidates.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const OutcomeInfo& criterion = numbers.criteria[static_cast<std::size_t>(row)];
        const QString title = QString::fromStdString(full_title(criterion));
        table_->setVerticalHeaderItem(row, new QTableWidgetItem(title.left(1).toUpper() + title.mid(1)));
        for (int column = 0; column < table_->columnCount(); ++column) {
            table_->setItem(row, column, cellOf(numbers, columns[static_cast<std::size_t>(column)], criterion));
        }
    }
    bool one_fidelity = true;
    const std::vector<KeptRun> runs = compared();
    for (int column = 0; column < table_->columnCount(); ++column) {
        const KeptRun& run = runs[static_cast<std::size_t>(column)];
        const bool base = nameOf(run).toStdString() == numbers.baseline;
        auto* head = new QTableWidgetItem(base && runs.size() > 1 ? tr("%1\nbaseline").arg(nameOf(run)) : nameOf(run));
        const QString click = tr("Click to compare the others with this run.");
        head->setToolTip("<p>" + (nameOf(run) + ". " + originOf(*run.run, false) + ". " + click).toHtmlEscaped() + "</p>");
        table_->setHorizontalHeaderItem(column, head);
        one_fidelity = one_fidelity && run.run->plan.fidelity == runs.front().run->plan.fidelity;
    }
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->resizeRowsToContents();
    save_->setEnabled(runs.size() > 1);
    origin_->setText(one_fidelity ? QString() : tr("These runs have different fidelities, which is part of their difference."));
}

void CompareView::refreshMaps()
{
    const std::vector<KeptRun> runs = compared();
    QStringList titles;
    for (const KeptRun& run : runs) { titles << nameOf(run); }
    maps_->setRuns(runs, titles,
                   history_.runs().empty() ? tr("Nothing has been run yet. Run an experiment on two fabrics, or open recordings; they are "
                                                "listed above.")
                                           : tr("Tick the runs above to compare them."));
}

std::string CompareView::tableCsv() const
{
    Comparison ranked = comparison();
    judge(ranked);
    return comparison_csv(ranked);
}

void CompareView::saveTable()
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString chosen =
        QFileDialog::getSaveFileName(this, tr("Save Table"), QDir(folder).filePath("comparison.csv"), tr("Tables (*.csv)"));
    if (chosen.isEmpty()) { return; }
    try {
        write_file((chosen.endsWith(".csv", Qt::CaseInsensitive) ? chosen : chosen + ".csv").toStdString(), tableCsv());
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

} // namespace hygroloom
