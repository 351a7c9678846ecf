// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The page of studies while one runs, and its results.
#include "core/base/error.h"
#include "ui/basics/ask.h"
#include "ui/document/document.h"
#include "ui/study/effects_view.h"
#include "ui/study/indices_view.h"
#include "ui/study/pairs_view.h"
#include "ui/study/parallel_view.h"
#include "ui/study/study_candidate.h"
#include "ui/study/study_page.h"
#include "ui/study/study_setup.h"
#include "ui/study/study_table.h"

#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QTableView>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr std::size_t most_followed = 20000; // rows; more are read at the end
constexpr std::size_t most_named = 200;      // failures

} // namespace

void StudyPage::run(bool retry_failed)
{
    if (job_.running()) { return; }
    // Failed rows are of the study that is shown, which need not be the one that is set up.
    const bool shown = retry_failed && data_ && data_->of;
    if (!shown && !setup_->problems().isEmpty()) { return; }
    const QString into = shown ? data_->path : folder();
    followed_ = 0;
    if (shown) {
        job_.start(std::make_shared<const Design>(data_->of->design), data_->of->study, into, true);
    } else {
        job_.start(design(), setup_->study(), into, retry_failed);
    }
    remember(into);
    following_.start();
    refreshRun();
    refreshSetup();
}

void StudyPage::refreshRun()
{
    const bool running = job_.running();
    stop_->setEnabled(running);
    bar_->setVisible(running);
    retry_->setVisible(data_ && data_->of && data_->failed > 0);
    retry_->setEnabled(!running);
    failures_->setVisible(data_ && data_->failed > 0);
    if (!running) { return; }
    bar_->setValue(static_cast<int>(1000 * job_.progress().share));
    status_->setText(tr("%1.").arg(job_.progressText()));
}

void StudyPage::endRun()
{
    following_.stop();
    if (!job_.failure().isEmpty()) {
        status_->setText(tr("The study could not run."));
        Q_EMIT failed(job_.failure());
    } else {
        const StudyProgress& progress = job_.outcome().progress;
        const QString text =
            tr("%1 of %2 runs done, %3 failed").arg(progress.ended - progress.failed).arg(progress.rows).arg(progress.failed);
        status_->setText(job_.outcome().cancelled ? tr("Stopped. %1. Run goes on with those that are missing.").arg(text)
                                                  : tr("%1.").arg(text));
        asks_indices_ = !job_.outcome().cancelled;
        openResults(job_.folder());
    }
    refreshRun();
    refreshSetup();
}

/// A brush of the user would be lost with a new table.
void StudyPage::followRun()
{
    const std::size_t ended = job_.progress().ended;
    if (ended == followed_ || ended > most_followed || reader_.busy() || !parallel_->chart().brushes().empty()) { return; }
    followed_ = ended;
    openResults(job_.folder());
}

void StudyPage::openResults(const QString& path)
{
    QElapsedTimer clock;
    clock.start();
    reader_.run([this, path, clock](const NewestJob::Turn& turn) {
        std::shared_ptr<const StudyData> study;
        QString why;
        try {
            study = readStudyData(QDir::cleanPath(path));
        } catch (const std::bad_alloc&) {
            why = tr("%1: The memory does not suffice for these results.").arg(path);
        } catch (const std::exception& error) {
            why = QString::fromStdString(error.what());
        }
        turn.deliver([this, study, why, clock] {
            if (study) {
                showResults(study);
                opening_time_ = 1e-3 * static_cast<double>(clock.elapsed());
                const bool wanted = std::exchange(asks_indices_, false) && data_->of && data_->of->study.sensitivity != Sensitivity::none;
                if (wanted && !data_->has_indices) { computeIndices(); }
                Q_EMIT shown();
            } else {
                Q_EMIT failed(why);
            }
        });
    });
}

void StudyPage::showResults(const std::shared_ptr<const StudyData>& study)
{
    const bool same = study && data_ && study->path == data_->path; // what has come meanwhile
    const std::optional<std::size_t> point = same ? chosen_ : std::nullopt;
    data_ = study;
    chosen_.reset();
    model_->setStudy(study);
    if (study && !same) {
        view_->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
        view_->resizeColumnsToContents();
    }
    effects_->setStudy(study);
    pairs_->setStudy(study);
    parallel_->setStudy(study);
    indices_->setStudy(study);
    if (study) {
        QString text = study->rows == study->table.rows()
                           ? tr("%1: %2 rows").arg(study->path).arg(study->rows)
                           : tr("%1: %2 of %3 rows").arg(study->path).arg(study->table.rows()).arg(study->rows);
        if (study->failed > 0) { text += tr(", %1 failed").arg(study->failed); }
        heading_->setText(text);
        heading_->setToolTip("<p>" + text.toHtmlEscaped() + "</p>");
    } else {
        heading_->setText(tr("No results are open."));
    }
    choose(point && *point < study->table.rows() && !job_.running() ? point : std::nullopt);
    refreshRun();
}

void StudyPage::takeBrush()
{
    const KeptPoints kept = keptBy(*data_, parallel_->chart().brushes());
    const std::optional<std::size_t> before = chosen_;
    {
        const QSignalBlocker quiet(view_->selectionModel());
        model_->setKept(kept);
    }
    parallel_->chart().setKept(kept);
    pairs_->chart().setKept(kept);
    choose(before && (kept.empty() || kept[*before]) ? before : std::nullopt);
    if (!job_.running()) {
        status_->setText(kept.empty() ? QString()
                                      : tr("%1 of %2 rows are in the ranges.").arg(model_->rowCount()).arg(data_->table.rows()));
    }
}

void StudyPage::choose(std::optional<std::size_t> row)
{
    chosen_ = row;
    pairs_->chart().setChosen(row);
    parallel_->chart().setChosen(row);
    candidate_->setEnabled(row.has_value());
    const QString words = row ? rowInWords(*data_, *row) : QString();
    row_->setText(words);
    row_->setToolTip("<p>" + words.toHtmlEscaped() + "</p>");
    const int shown = row ? model_->shownAt(*row) : -1;
    if (shown >= 0 && view_->currentIndex().row() != shown) {
        view_->selectRow(shown);
        view_->scrollTo(model_->index(shown, 0));
    }
}

void StudyPage::makeCandidate()
{
    if (!chosen_ || !data_) { return; }
    try {
        Q_EMIT messageShown(hygroloom::makeCandidate(document_, *data_, *chosen_));
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
    }
}

void StudyPage::computeIndices()
{
    if (!data_ || !data_->of) { return; }
    indices_->say(tr("The indices are being computed."), true);
    analyst_.run([this, path = data_->path](const NewestJob::Turn& turn) {
        QString why = QString::fromStdString(why_no_analysis());
        try {
            if (why.isEmpty()) { analyse_study(path.toStdString()); }
        } catch (const std::exception& error) {
            why = QString::fromStdString(error.what());
        }
        turn.deliver([this, path, why] {
            indices_->say(why, false);
            if (why.isEmpty() && data_ && data_->path == path) { openResults(path); }
        });
    });
}

void StudyPage::showFailures()
{
    const StudyColumn* status = data_->table.find(StudyColumnRole::status);
    const StudyColumn* reason = data_->table.find(StudyColumnRole::reason);
    const StudyColumn* point = data_->table.find(StudyColumnRole::point);
    QStringList lines;
    for (std::size_t row = 0; row < data_->table.rows() && lines.size() < static_cast<qsizetype>(most_named); ++row) {
        if (status->word(row) != row_failed) { continue; }
        lines << tr("Point %1: %2").arg(static_cast<qulonglong>(point->numbers[row])).arg(QString::fromStdString(reason->word(row)));
    }
    if (data_->failed > most_named) { lines << tr("%1 more failed.").arg(data_->failed - most_named); }
    tellInFull(this, tr("Runs that failed"), data_->failed == 1 ? tr("1 run failed.") : tr("%1 runs failed.").arg(data_->failed),
               lines.mid(0, 3).join('\n'), lines.size() > 3 ? lines.join('\n') : QString());
}

} // namespace hygroloom
