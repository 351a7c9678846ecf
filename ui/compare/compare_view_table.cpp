// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The table of candidates, and running what is missing in it.
#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/quantity.h"
#include "ui/compare/candidate_table.h"
#include "ui/compare/card_columns.h"
#include "ui/compare/cloths_view.h"
#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_maps.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/curves_view.h"
#include "ui/compare/fingerprint_view.h"
#include "ui/compare/garment_maps.h"
#include "ui/compare/scatter_view.h"
#include "ui/compare/study_report.h"
#include "ui/compare/why_view.h"
#include "ui/document/document.h"
#include "ui/results/plan_dialog.h"
#include "ui/results/report_file.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>

#include <algorithm>

namespace hygroloom {

std::vector<GridEntry> CompareView::gridEntries(const std::vector<StudyRow>& rows) const
{
    std::vector<GridEntry> entries;
    entries.reserve(rows.size());
    for (const StudyRow& row : rows) { entries.push_back({row.fabric, row.path, row.reading, row.runs, row.missing}); }
    return entries;
}

void CompareView::refreshTable()
{
    numbers_ = {};
    all_rows_.clear();
    Grid grid;
    if (const Entry* shown = entry()) {
        numbers_ = comparisonOf(criteriaOf(*shown), choiceOf(*shown), rows_, baseline_);
        const auto ranked = static_cast<std::size_t>(table_->rankedBy()); // less than 0: none, beyond all
        if (ranked < numbers_.criteria.size()) { numbers_.ranked_by = numbers_.criteria[ranked]; }
        judge(numbers_);
        if (!measured_.contains(numbers_.experiment)) { recallMeasured(); }
        numbers_.measured = measured_[numbers_.experiment];
        if (!shown->worn()) { cards_->addTo(numbers_); }
        grid = gridOf(with_card_numbers(numbers_), gridEntries(rows_));
        const std::size_t own = shown->own ? document_.design()->fabrics.size() : 0;
        for (std::size_t i = 0; i < grid.rows.size(); ++i) {
            grid.rows[i].candidate = i < own;
            if (i >= own) { grid.rows[i].note = noteOf(rows_[i].path); }
        }
    } else {
        grid = overview();
    }
    markMissing(grid);
    table_->setGrid(grid, QSet<QString>(chosen_.begin(), chosen_.end()), !entry());
    bar_->offerFiles(numbers_.candidates.size());
    bar_->card()->setEnabled(entry() && !entry()->worn());
    refreshHint();
}

/// What makes a run another than that of a fabric of the project.
QString CompareView::noteOf(const QString& path) const
{
    const KeptRun* run = history_.find(path);
    if (!run) { return {}; }
    QStringList differs = differencesOf(*run->run, *document_.design());
    if (run->run->plan.fidelity != bar_->fidelity()) { differs << tr("fidelity %1").arg(fidelityName(run->run->plan.fidelity)); }
    return differs.isEmpty() ? tr("earlier run") : tr("other run: %1").arg(differs.join(", "));
}

Grid CompareView::overview()
{
    std::vector<ExperimentPart> parts;
    for (const Entry& each : entries_) {
        if (!each.own) { continue; }
        all_rows_.push_back(ownRowsOf(each));
        parts.push_back({comparisonOf(criteriaOf(each), choiceOf(each), all_rows_.back(), baseline_), gridEntries(all_rows_.back())});
        judge(parts.back().comparison);
    }
    return overviewOf(parts);
}

/// What runs, waits or failed.
void CompareView::markMissing(Grid& grid) const
{
    for (GridRow& row : grid.rows) {
        for (GridCell& cell : row.cells) {
            if (cell.missing.empty()) { continue; }
            const auto any = [&](StudyRuns::State state) {
                return std::any_of(cell.missing.begin(), cell.missing.end(),
                                   [&](const StudyJob& job) { return runs_.stateOf(job) == state; });
            };
            const QString failure = runs_.failureOf(cell.missing.front());
            if (cell.state != GridCell::State::missing) { continue; }
            cell.tip = tr("Enter or the button runs it.");
            const KeptRun* older = outdatedRun(cell.missing.front().fabric, cell.missing.front().experiment);
            cell.outdated = older != nullptr;
            const QStringList differs = older ? differencesOf(*older->run, *document_.design()) : QStringList();
            if (!differs.isEmpty()) {
                cell.tip = tr("Since this was run, these have changed: %1.").arg(differs.join(", ")) + "\n" + cell.tip;
            }
            if (any(StudyRuns::State::running)) {
                cell.verdict = tr("running…");
            } else if (any(StudyRuns::State::waiting)) {
                cell.verdict = tr("waiting");
            } else if (!failure.isEmpty()) {
                cell.failed = true;
                cell.tip = failure;
            }
        }
    }
}

const KeptRun* CompareView::outdatedRun(const std::string& fabric, const std::string& experiment) const
{
    const auto& runs = history_.runs();
    const auto found = std::find_if(runs.rbegin(), runs.rend(), [&](const KeptRun& run) {
        return run.own && run.problem.isEmpty() && run.complete() && !run.current && run.cloth() == fabric &&
               run.run->experiment == experiment;
    });
    return found == runs.rend() ? nullptr : &*found;
}

void CompareView::refreshLower()
{
    std::vector<KeptRun> runs;
    QStringList titles;
    for (const KeptRun& run : compared()) {
        if (!entry() || conditionsOf(*run.run) != entry()->conditions) { continue; }
        runs.push_back(run);
        titles << nameOf(run);
    }
    QString hint = tr("Tick two to four fabrics above to see them side by side.");
    if (history_.listing()) {
        hint = tr("The runs of this project are being read.");
    } else if (history_.runs().empty()) {
        hint = tr("Nothing has been run yet. “Run All Missing” above runs the experiment on every fabric. Recordings that are opened stand "
                  "under All Runs.");
    } else if (!entry()) {
        hint = tr("Choose one experiment above to see its maps and curves.");
    } else if (const QString outdated = outdatedText(); runs.empty() && !outdated.isEmpty()) {
        hint = outdated;
    }
    std::optional<KeptRun> baseline;
    const std::string& base = numbers_.baseline;
    for (const StudyRow& row : rows_) {
        const KeptRun* run = row.fabric == base ? history_.find(row.path) : nullptr;
        if (run) { baseline = *run; }
    }
    const bool worn = entry() && entry()->worn();
    const std::vector<KeptRun> none;
    maps_->setRuns(worn ? none : runs, worn ? QStringList() : titles, hint, worn ? std::nullopt : baseline, QString::fromStdString(base),
                   numbers_);
    cloths_->setRuns(worn ? none : runs, worn ? QStringList() : titles, hint);
    garment_maps_->setRuns(worn ? runs : none, worn ? titles : QStringList(), hint, worn ? baseline : std::nullopt);
    curves_->setRuns(runs, titles, numbers_, part_);
    std::vector<std::string> names;
    for (const QString& title : titles) { names.push_back(title.toStdString()); }
    fingerprint_->setCandidates(numbers_, names);
    scatter_->setComparison(with_card_numbers(numbers_));
    const Entry* shown = entry();
    why_->setStudy({numbers_, document_.design(), shown ? choiceOf(*shown) : StudyChoice(), shown && shown->own, whyNoRun()});
}

std::vector<StudyJob> CompareView::missing() const
{
    std::vector<StudyJob> jobs;
    std::vector<std::vector<StudyRow>> all = all_rows_;
    if (entry()) { all = {rows_}; }
    for (const auto& rows : all) {
        for (const StudyRow& row : rows) { jobs.insert(jobs.end(), row.missing.begin(), row.missing.end()); }
    }
    // All fabrics have their first run before one has its second.
    std::stable_sort(jobs.begin(), jobs.end(), [](const StudyJob& a, const StudyJob& b) {
        return std::pair(!a.recorded, a.number) < std::pair(!b.recorded, b.number);
    });
    return jobs;
}

QString CompareView::whyNoRun() const { return firstError(document_.issues()); }

std::optional<double> CompareView::secondsOf(const StudyJob& job) const
{
    std::vector<std::vector<StudyRow>> all = all_rows_;
    if (entry()) { all = {rows_}; }
    for (const auto& rows : all) { // as long as the fabric's own run took
        for (const StudyRow& row : rows) {
            if (row.fabric == job.fabric && row.wall > 0 && !row.missing.empty() && row.missing.front().experiment == job.experiment) {
                return row.wall;
            }
        }
    }
    const auto found = planned_ == document_.design() ? expected_.find(kindOf(job)) : expected_.end();
    return found == expected_.end() ? std::nullopt : std::optional(found->second);
}

void CompareView::refreshMissing()
{
    double seconds = 0;
    int count = 0;
    std::vector<StudyJob> unknown;
    for (const StudyJob& job : missing()) {
        if (runs_.stateOf(job) != StudyRuns::State::none) { continue; }
        ++count;
        const std::optional<double> own = secondsOf(job);
        seconds += own.value_or(0);
        if (!own && (unknown.empty() || unknown.back().fabric != job.fabric || unknown.back().experiment != job.experiment)) {
            unknown.push_back(job);
        }
    }
    bar_->setMissing(history_.listing() ? std::nullopt : std::optional(count), unknown.empty() ? seconds : 0, whyNoRun());
    if (!unknown.empty() && isVisible() && whyNoRun().isEmpty()) { plan(unknown); }
}

/// What each takes, in the background.
void CompareView::plan(const std::vector<StudyJob>& jobs)
{
    if (planned_ == document_.design() && planner_.busy()) { return; }
    if (planned_ != document_.design()) { expected_.clear(); }
    planned_ = document_.design();
    planner_.run([this, jobs, design = document_.design(), base = document_.folder().toStdString()](const NewestJob::Turn& turn) {
        std::map<KindOfJob, double> found;
        for (const StudyJob& job : jobs) {
            const KindOfJob key = kindOf(job);
            if (turn.outdated()) { return; }
            if (found.contains(key)) { continue; }
            found[key] = secondsToRun(*design, base, job);
        }
        turn.deliver([this, design, found] {
            if (design != document_.design()) { return; }
            expected_.insert(found.begin(), found.end());
            refreshMissing();
        });
    });
}

void CompareView::start(const std::vector<StudyJob>& jobs)
{
    if (const QString why = whyNoRun(); !why.isEmpty()) {
        Q_EMIT failed(tr("Nothing can be run: %1").arg(why));
        return;
    }
    std::vector<StudyRuns::Expected> expected;
    expected.reserve(jobs.size());
    for (const StudyJob& job : jobs) { expected.push_back({job, secondsOf(job).value_or(0)}); }
    runs_.start(expected);
}

std::string CompareView::tableCsv() const { return comparison_csv(numbers_); }

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

/// The recordings are read in the background.
void CompareView::saveReport()
{
    if (reporter_.busy()) {
        Q_EMIT failed(tr("Another report is still being written. Save this one when that is done."));
        return;
    }
    const QString folder = document_.path().isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                                      : QFileInfo(document_.path()).absolutePath();
    const QString file = askForReportFile(this, folder, QString::fromStdString(numbers_.experiment));
    if (file.isEmpty()) { return; }
    std::map<std::string, QString> recordings;
    for (const StudyRow& row : rows_) {
        if (!row.path.isEmpty()) { recordings[row.fabric] = row.path; }
    }
    Comparison numbers = numbers_;
    numbers.why = why_->why();
    reporter_.run([this, file, recordings, comparison = std::move(numbers)](const NewestJob::Turn& turn) {
        ReportPage page;
        QString why;
        try {
            page = studyReport(comparison, recordings);
        } catch (const std::exception& error) {
            why = QString::fromStdString(error.what());
        }
        turn.deliver([this, file, page, why] {
            try {
                if (!why.isEmpty()) { throw Error(why.toStdString()); }
                writeReport(page, file);
                Q_EMIT saved(file);
            } catch (const Error& error) {
                Q_EMIT failed(QString::fromStdString(error.what()));
            }
        });
    });
}

LaboratoryTable CompareView::measuredIn(const QString& file) const
{
    std::vector<std::string> fabrics;
    for (const StudyRow& row : rows_) { fabrics.push_back(row.fabric); }
    return readMeasured(numbers_.criteria, fabrics, file);
}

void CompareView::chooseMeasured()
{
    const QString file = QFileDialog::getOpenFileName(this, tr("Measured Numbers"), measuredFile(document_.path(), numbers_.experiment),
                                                      tr("Tables (*.csv);;All files (*)"));
    if (file.isEmpty()) { return; }
    try {
        measured_[numbers_.experiment] = measuredIn(file);
        rememberMeasured(document_.path(), numbers_.experiment, file);
        refreshTable();
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

void CompareView::recallMeasured()
{
    LaboratoryTable& table = measured_[numbers_.experiment];
    const QString file = document_.path().isEmpty() ? QString() : measuredFile(document_.path(), numbers_.experiment);
    if (file.isEmpty()) { return; }
    try {
        table = measuredIn(file);
    } catch (const Error& error) {
        const QString why = QString::fromStdString(error.what());
        QTimer::singleShot(0, this, [this, why] { Q_EMIT failed(why); }); // the table is being filled
    }
}

} // namespace hygroloom
