// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/results_panel.h"

#include "core/analysis/cell_map.h"
#include "core/analysis/map_picture.h"
#include "core/analysis/outcomes.h"
#include "core/analysis/report.h"
#include "core/base/text.h"
#include "ui/basics/core_words.h"
#include "ui/basics/language.h"
#include "ui/basics/preferences.h"
#include "ui/basics/quantity.h"
#include "ui/results/plan_dialog.h"
#include "ui/results/report_file.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDateTime>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QTextDocumentFragment>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hygroloom {

namespace {

/// With a capital.
QString sentence(const QString& words) { return words.left(1).toUpper() + words.mid(1); }

/// "12.3 mm, grade 4", or why there is no value.
QString textOf(const Outcome& outcome)
{
    if (!outcome.text.empty()) { return coreWord(outcome.text); }
    QString text = coreWord(outcome.missing);
    if (outcome.value) {
        const ShownValue value = shown(outcome, *outcome.value);
        text = valueText(value.value, QString::fromStdString(value.unit));
    }
    if (outcome.grade) { text = QStringLiteral("%1 (%2)").arg(text).arg(*outcome.grade); }
    return outcome.remark.empty() ? text : text + ", " + coreWord(outcome.remark);
}

QString fullOf(const Outcome& outcome)
{
    if (!outcome.value || !outcome.text.empty()) { return {}; }
    const ShownValue value = shown(outcome, *outcome.value);
    return valueText(value.value, QString::fromStdString(value.unit), true);
}

/// The stain's sizes by which nobody should take one for the other; empty: its name says it.
QString aboutOf(const Outcome& outcome)
{
    if (outcome.in_rings) { return {}; }
    if (outcome.key.starts_with("maximum_wetted_radius")) {
        return ResultsPanel::tr("Radius of the smallest circle around all wet crossings of the face: it reaches the outermost.");
    }
    if (outcome.key.starts_with("wetted_area_ellipse")) {
        return ResultsPanel::tr(
            "Half length of the filled ellipse that spreads as widely as the wet crossings on top (equal second moments). "
            "Single fingers count little in it.");
    }
    return {};
}

/// The numbers by which fabrics are compared come first; top and bottom stand on one line.
void addOutcomes(std::vector<Result>& results, const std::vector<Outcome>& outcomes)
{
    struct Line {
        Result result;
        int rank;
    };
    constexpr int last = 1000;
    std::vector<Line> lines;
    for (const Outcome& outcome : outcomes) {
        if (!is_shown(outcome)) { continue; }
        const QString name = sentence(outcomeTitle(outcome));
        const int rank = outcome.rank > 0 ? outcome.rank : last;
        if (outcome.part == "bottom" && !lines.empty() && lines.back().result.name == name) {
            lines.back().result.bottom = textOf(outcome);
            lines.back().result.full_bottom = fullOf(outcome);
            lines.back().rank = std::min(lines.back().rank, rank);
        } else {
            lines.push_back({{name, textOf(outcome), {}, fullOf(outcome), {}, aboutOf(outcome)}, rank});
        }
    }
    std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.rank < b.rank; });
    for (const Line& line : lines) { results.push_back(line.result); }
}

/// Of a run with metrics.
QStringList notesOf(const Playback& playback)
{
    QStringList notes;
    if (!playback.live() && !playback.whole()) { notes << ResultsPanel::tr("The recording is being read: these are the numbers so far."); }
    for (const std::string& note : playback.metrics()->notes) { notes << QString::fromStdString(note); }
    return notes;
}

/// Empty for a recording of an older version.
QString begunAt(const RunRecord& run)
{
    const QDateTime begun = QDateTime::fromString(QString::fromStdString(run.date), Qt::ISODate);
    return begun.isValid() ? shortMoment(begun.toLocalTime()) : QString();
}

QString timeTaken(const RunRecord& run, bool live)
{
    if (run.wall > 0) { return ResultsPanel::tr("took %1 s").arg(shownNumber(run.wall, decimals_for(run.wall, 2))); }
    return live ? ResultsPanel::tr("running") : ResultsPanel::tr("stopped");
}

} // namespace

QString outcomeTitle(const OutcomeInfo& info)
{
    const bool largest = info.key.starts_with("maximum_wetted_radius") && !info.in_rings;
    return largest ? ResultsPanel::tr("largest wetted radius") : coreWord(info.title);
}

std::vector<Result> resultsOf(const RunRecord& run, const Metrics& m, bool part)
{
    std::vector<Result> results;
    std::vector<Outcome> outcomes = outcomes_of(run, m, part);
    if (part) {
        std::erase_if(outcomes, [](const Outcome& outcome) { return outcome.of_whole_test; });
    }
    addOutcomes(results, outcomes);
    for (const BalanceRow& row : water_balance(m.ledger)) {
        if (row.value == 0) { continue; }
        const QString unit = QString::fromStdString(row.unit);
        results.push_back({sentence(coreWord(row.title)), valueText(row.value, unit), {}, valueText(row.value, unit, true)});
    }
    return results;
}

QString originOf(const RunRecord& run, bool live)
{
    QStringList parts{fidelityName(run.plan.fidelity)};
    const std::size_t set = changed_knobs(knobs_of(run.plan.fidelity), run.plan.knobs).size();
    if (set > 0) { parts << (set == 1 ? ResultsPanel::tr("1 knob set") : ResultsPanel::tr("%1 knobs set").arg(set)); }
    parts << expectedError(run.plan) << (run.backend == "cpu" ? ResultsPanel::tr("on the CPU") : ResultsPanel::tr("on a GPU"));
    if (const QString begun = begunAt(run); !begun.isEmpty()) { parts << begun; }
    return (parts << timeTaken(run, live)).join(", ");
}

QString knobValue(const KnobInfo& knob, const Knobs& knobs)
{
    const double value = knobs.*knob.value;
    return knob.words.empty() ? QLocale().toString(value) : QString::fromStdString(text_of(knob, value));
}

QStringList originInFull(const RunRecord& run, bool live)
{
    const Knobs usual = knobs_of(run.plan.fidelity);
    QStringList lines{ResultsPanel::tr("Fidelity: %1").arg(fidelityName(run.plan.fidelity))};
    for (const KnobInfo* knob : changed_knobs(usual, run.plan.knobs)) {
        lines << ResultsPanel::tr("%1 set to %2 (%3 has %4)")
                     .arg(coreWord(QString(knob->name).replace('_', ' ')), knobValue(*knob, run.plan.knobs),
                          withinSentence(fidelityName(run.plan.fidelity)), knobValue(*knob, usual));
    }
    const QString source = QString::fromStdString(run.plan.expectation_source);
    lines << sentence(expectedError(run.plan)) + (source.isEmpty() ? "" : ". " + source);
    for (const PlannedPart& part : run.plan.parts) {
        if (part.forced) {
            lines << (part.on ? ResultsPanel::tr("%1 switched on by the user") : ResultsPanel::tr("%1 switched off by the user"))
                         .arg(coreWord(part.name));
        }
    }
    lines << ResultsPanel::tr("Device: %1").arg(QString::fromStdString(run.device));
    if (const QString begun = begunAt(run); !begun.isEmpty()) { lines << ResultsPanel::tr("Started: %1").arg(begun); }
    lines << sentence(timeTaken(run, live));
    for (const std::string& note : notes_of(run.plan)) { lines << QString::fromStdString(note); }
    return lines;
}

ResultsPanel::ResultsPanel(Playback& playback, QWidget* parent)
    : QScrollArea(parent), playback_(playback), table_(new QWidget), grid_(new QGridLayout(table_)), notes_(new QLabel), kept_(new QLabel),
      origin_(new QLabel)
{
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(8);
    grid_->setVerticalSpacing(2);
    grid_->setColumnStretch(2, 1);
    notes_->setWordWrap(true);
    notes_->setTextFormat(Qt::PlainText);
    notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    notes_->setAccessibleName(tr("About the results"));
    kept_->setWordWrap(true);
    kept_->setTextFormat(Qt::RichText);
    kept_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    kept_->setAccessibleName(tr("Runs that are kept"));
    connect(kept_, &QLabel::linkActivated, this, [this](const QString& link) {
        if (link == "chosen") {
            Q_EMIT chosenRequested();
        } else {
            Q_EMIT newestRequested();
        }
    });
    origin_->setWordWrap(true);
    origin_->setForegroundRole(QPalette::PlaceholderText);
    origin_->setTextFormat(Qt::RichText);
    origin_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(origin_, &QLabel::linkActivated, this, &ResultsPanel::showPlan);
    origin_->setAccessibleName(tr("How the results were computed"));
    setMinimumWidth(220); // names and numbers of both faces, mostly
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(8, 4, 8, 8);
    layout->addWidget(origin_);
    layout->addWidget(notes_);
    layout->addWidget(kept_);
    layout->addWidget(table_);
    layout->addStretch();
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Results"));
    auto* copy = new QAction(tr("Copy the Results"), this);
    connect(copy, &QAction::triggered, this, [this] { QApplication::clipboard()->setText(text()); });
    addAction(copy);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(&playback_, &Playback::metricsChanged, this, &ResultsPanel::refresh);
    connect(&playback_, &Playback::runChanged, this, &ResultsPanel::refresh);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &ResultsPanel::refresh);
    refresh();
}

void ResultsPanel::refresh()
{
    std::vector<Result> results;
    QStringList notes;
    if (playback_.run() && playback_.metrics()) {
        results = resultsOf(*playback_.run(), *playback_.metrics());
        notes = notesOf(playback_);
        const bool faces = std::any_of(results.begin(), results.end(), [](const Result& r) { return !r.bottom.isEmpty(); });
        if (faces) {
            const bool grades = playback_.metrics()->management.has_value();
            results.insert(results.begin(),
                           {QString(), grades ? tr("top (grade)") : tr("top"), grades ? tr("bottom (grade)") : tr("bottom")});
        }
    } else if (playback_.run()) {
        notes << tr("No results yet.");
    } else if (kept_runs_ == 0) {
        notes << tr("Run the experiment to see its results here.");
    }
    showKept();
    while (rows_.size() < results.size()) {
        const int row = static_cast<int>(rows_.size());
        std::array<QLabel*, 3> labels{new QLabel, new QLabel, new QLabel};
        for (int column = 0; column < 3; ++column) {
            labels[static_cast<std::size_t>(column)]->setTextInteractionFlags(Qt::TextSelectableByMouse);
            labels[static_cast<std::size_t>(column)]->setAlignment(Qt::AlignLeft | Qt::AlignTop);
            grid_->addWidget(labels[static_cast<std::size_t>(column)], row, column);
        }
        labels[0]->setForegroundRole(QPalette::PlaceholderText);
        labels[0]->setWordWrap(true);
        rows_.push_back(labels);
    }
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        const Result result = row < results.size() ? results[row] : Result{};
        const QString texts[] = {result.name, result.value, result.bottom}, fulls[] = {result.about, result.full, result.full_bottom};
        for (std::size_t column = 0; column < 3; ++column) {
            rows_[row][column]->setText(texts[column]);
            rows_[row][column]->setToolTip(fulls[column].isEmpty() ? QString() : "<p>" + fulls[column].toHtmlEscaped() + "</p>");
            rows_[row][column]->setAccessibleName(column == 0 ? QString() : result.name);
            rows_[row][column]->setVisible(row < results.size() && !(column == 2 && texts[2].isEmpty()));
        }
        // A value of both faces takes both columns; words wrap.
        grid_->removeWidget(rows_[row][1]);
        grid_->addWidget(rows_[row][1], static_cast<int>(row), 1, 1, result.bottom.isEmpty() ? 2 : 1);
        rows_[row][1]->setWordWrap(result.bottom.isEmpty());
    }
    const RunRecord* run = playback_.run().get();
    origin_->setVisible(run != nullptr);
    origin_->setText(run ? tr("%1. <a href='plan'>What was modelled…</a>").arg(originOf(*run, playback_.live()).toHtmlEscaped())
                         : QString());
    origin_->setToolTip(run ? "<p style='white-space:pre-wrap'>" + originInFull(*run, playback_.live()).join('\n').toHtmlEscaped() + "</p>"
                            : QString());
    QStringList assumed;
    if (playback_.metrics()) {
        for (const std::string& sentence : playback_.metrics()->assumed) { assumed << QString::fromStdString(sentence); }
    }
    table_->setToolTip(assumed.isEmpty() ? QString() : "<p style='white-space:pre-wrap'>" + assumed.join('\n').toHtmlEscaped() + "</p>");
    table_->setVisible(!results.empty());
    notes_->setText(notes.join('\n'));
    notes_->setVisible(!notes.isEmpty());
}

void ResultsPanel::setKept(int runs)
{
    if (std::exchange(kept_runs_, runs) != runs) { refresh(); }
}

void ResultsPanel::setChosenKept(bool kept)
{
    if (std::exchange(chosen_is_kept_, kept) != kept) { showKept(); }
}

void ResultsPanel::showKept()
{
    if (playback_.run()) {
        kept_->setVisible(chosen_is_kept_);
        kept_->setText(chosen_is_kept_ ? tr("A run of the selected fabric and experiment is kept. <a href='chosen'>Open it</a>.")
                                       : QString());
        return;
    }
    const bool any_kept = kept_runs_ > 0;
    kept_->setVisible(any_kept);
    kept_->setText(!any_kept ? QString()
                   : kept_runs_ == 1
                       ? tr("1 run is kept. <a href='newest'>Open it</a>, or run the experiment.")
                       : tr("%1 runs are kept. <a href='newest'>Open the newest</a>, choose one in Compare under All Runs, or "
                            "run the experiment.")
                             .arg(kept_runs_));
}

ReportPage ResultsPanel::report() const
{
    const auto run = playback_.run();
    const auto frame = playback_.frame(), first = playback_.firstFrame();
    const auto metrics = playback_.metrics();
    if (!run || !frame || !first || !metrics) { return {}; }
    constexpr int crossings_per_cell = 2;
    const auto pictures = pictures_of_faces(*run, *frame, start_of_maps(*run, *first), crossings_per_cell, unitsOfReader());
    return report_of(*run, *metrics, pictures, playback_.whole() && run->wall > 0, unitsOfReader());
}

void ResultsPanel::showPlan()
{
    if (playback_.run()) {
        auto* dialog = new PlanDialog(*playback_.run(), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    }
}

QString ResultsPanel::text() const
{
    QStringList lines;
    for (const auto& row : rows_) {
        if (!row[1]->text().isEmpty()) {
            QStringList cells;
            for (const QLabel* label : row) { cells << label->text(); }
            lines << cells.join('\t').trimmed();
        }
    }
    if (playback_.run()) { lines << originInFull(*playback_.run(), playback_.live()); }
    return (lines << notes_->text() << QTextDocumentFragment::fromHtml(kept_->text()).toPlainText()).join('\n').trimmed();
}

} // namespace hygroloom
