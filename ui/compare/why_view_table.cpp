// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What WhyView shows: the parts that differ, what they make, and in which state the question is.
#include "ui/basics/core_words.h"
#include "ui/basics/words.h"
#include "ui/compare/candidate_grid.h"
#include "ui/compare/why_delegate.h"
#include "ui/compare/why_view.h"
#include "ui/results/plan_dialog.h"
#include "ui/results/report_file.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

enum Column { part_column, fabric_column, against_column, number_column, words_column };

QString capitalOf(const std::string& text) { return capital(QString::fromStdString(text)); }

} // namespace

void WhyView::refresh()
{
    why_.reset();
    table_->setRowCount(0);
    heading_->clear();
    note_->clear();
    const int metric = metric_->currentIndex();
    if (plan_ && whyNot().isEmpty() && metric >= 0) {
        const Candidate &fabric = *candidateOf(fabric_), &against = *candidateOf(against_);
        const OutcomeInfo& info = study_.comparison.criteria[static_cast<std::size_t>(metric)];
        const int replicates = study_.choice.replicates;
        Why first = why_of(*plan_, info, fabric, against, replicates);
        const QString heading = QString::fromStdString(heading_of(first, unitsOfReader())) + ".";
        const Known* own = known(keys());
        std::map<Mixture, Candidate> tried = own ? own->mixtures : std::map<Mixture, Candidate>();
        if (own) {
            for (const auto& [which, failure] : own->failed) { tried[which.first].failure = failure; }
        }
        if (!first.nothing.empty()) {
            why_ = std::make_shared<const Why>(std::move(first));
        } else if (missing().size() == (own ? own->failed.size() : 0)) { // all have been tried
            why_ = std::make_shared<const Why>(explain(*plan_, info, fabric, against, tried, replicates));
        }
        table_->setHorizontalHeaderLabels(
            {tr("Part"), fabric_->currentText(), against_->currentText(), tr("Contribution to the difference"), tr("In words")});
        if (why_) {
            showWhy();
        } else {
            heading_->setText(heading);
            showParts();
        }
    }
    heading_->setVisible(!heading_->text().isEmpty());
    note_->setVisible(!note_->text().isEmpty());
    table_->setVisible(table_->rowCount() > 0);
    shareWidth();
    showState();
    Q_EMIT found();
}

void WhyView::addRow(const QStringList& cells, bool strong)
{
    const int row = table_->rowCount();
    table_->insertRow(row);
    for (int column = 0; column < cells.size(); ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        item->setToolTip("<p>" + cells[column].toHtmlEscaped() + "</p>");
        if (strong) {
            QFont font = table_->font();
            font.setBold(true);
            item->setFont(font);
        }
        table_->setItem(row, column, item);
    }
}

/// To the last row.
void WhyView::addBar(const Compared& compared, double low, double high)
{
    if (!(high > low)) { return; }
    QTableWidgetItem& item = *table_->item(table_->rowCount() - 1, number_column);
    const auto share = [low, high](double value) { return (value - low) / (high - low); };
    item.setData(WhyDelegate::zero_role, share(0));
    item.setData(WhyDelegate::value_role, share(compared.difference));
    item.setData(WhyDelegate::low_role, share(compared.low));
    item.setData(WhyDelegate::high_role, share(compared.high));
    const bool none = compared.verdict == Verdict::no_difference;
    const bool good = compared.verdict == Verdict::better || compared.verdict == Verdict::probably_better;
    item.setData(WhyDelegate::tone_role, none ? WhyDelegate::none : good ? WhyDelegate::better : WhyDelegate::worse);
}

/// Before the mixtures have run.
void WhyView::showParts()
{
    for (const Exchange& part : plan_->parts) {
        addRow(
            {capital(coreWord(part.title)), QString::fromStdString(part.first), QString::fromStdString(part.second), QString(), QString()});
    }
    QStringList notes;
    for (const std::string& note : plan_->notes) { notes << capitalOf(note); }
    note_->setText(notes.join(' '));
}

void WhyView::showWhy()
{
    const Why& why = *why_;
    const ReaderUnits units = unitsOfReader();
    std::vector<std::string> sentences = sentences_of(why, units);
    if (!why.nothing.empty()) {
        heading_->setText(QString::fromStdString(nothing_of(why, units)));
        return;
    }
    heading_->setText(QString::fromStdString(heading_of(why, units)) + ".");
    double low = 0, high = 0;
    const std::vector<WhyLine> lines = lines_of(why);
    for (const WhyLine& line : lines) {
        low = std::min({low, line.compared->low, line.compared->difference});
        high = std::max({high, line.compared->high, line.compared->difference});
    }
    for (const WhyLine& line : lines) {
        const QString words =
            line.whole ? verdictText(line.compared->verdict) : QString::fromStdString(in_words(why, *line.compared, false, units));
        addRow({capital(coreWord(line.title)), QString::fromStdString(line.first), QString::fromStdString(line.second),
                QString::fromStdString(with_unit(why.metric, *line.compared, units)), capital(words)},
               line.whole);
        addBar(*line.compared, low, high);
    }
    QStringList notes;
    for (std::size_t i = why.parts.size(); i < sentences.size(); ++i) { notes << capitalOf(sentences[i]); } // the others stand in the table
    note_->setText(notes.join(' '));
}

void WhyView::shareWidth()
{
    table_->resizeColumnsToContents();
    for (const int column : {part_column, fabric_column, against_column}) {
        table_->setColumnWidth(column, std::clamp(table_->columnWidth(column), 80, 230));
    }
    table_->setColumnWidth(number_column, std::clamp(table_->columnWidth(number_column), 220, 320));
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->resizeRowsToContents();
}

/// Beside the button: what it takes, or how far it is.
void WhyView::showState()
{
    const QString why_not = whyNot();
    QString text = why_not;
    int count = 0;
    const Known* own = plan_ && why_not.isEmpty() ? known(keys()) : nullptr;
    const bool failed = own && !own->failed.empty();
    if (why_not.isEmpty() && !plan_) { text = tr("Looking for what differs…"); }
    if (why_not.isEmpty() && plan_ && (!why_ || failed)) {
        count = static_cast<int>(missing().size());
        const QString runs = count == 1 ? tr("1 run") : tr("%1 runs").arg(count);
        const double seconds = count * secondsOfRun();
        text = seconds > 0 ? tr("%1, %2").arg(runs, roughDuration(seconds)) : runs;
        if (failed) { text += tr(". Failed: %1").arg(QString::fromStdString(own->failed.begin()->second)); }
    }
    if (asking_) { text = runs_.stateText(); }
    find_->setText(asking_ ? tr("Ca&ncel Runs") : tr("Find &Out"));
    find_->setEnabled(asking_ || count > 0);
    state_->setText(text);
}

} // namespace hygroloom
