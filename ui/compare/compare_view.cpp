// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What is compared. The table and what is missing: compare_view_table.cpp.
#include "ui/compare/compare_view.h"

#include "ui/basics/core_words.h"
#include "ui/basics/preferences.h"
#include "ui/compare/candidate_table.h"
#include "ui/compare/card_columns.h"
#include "ui/compare/cloths_view.h"
#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_maps.h"
#include "ui/compare/curves_view.h"
#include "ui/compare/fingerprint_view.h"
#include "ui/compare/garment_maps.h"
#include "ui/compare/run_list.h"
#include "ui/compare/scatter_view.h"
#include "ui/compare/why_view.h"
#include "ui/document/document.h"

#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hygroloom {

CompareView::CompareView(Document& document, RunHistory& history, StudyRuns& runs, QWidget* parent)
    : QWidget(parent), document_(document), history_(history), runs_(runs), bar_(new CompareBar(runs)),
      cards_(new CardColumns(document, bar_->card(), this)), upper_(new QTabWidget), table_(new CandidateTable),
      list_(new RunList(history, [this](const KeptRun& run) { return whyNot(run); })), lower_(new QTabWidget), maps_(new CompareMaps),
      garment_maps_(new GarmentMaps), curves_(new CurvesView), fingerprint_(new FingerprintView), scatter_(new ScatterView),
      why_(new WhyView(runs)), cloths_(new ClothsView), note_(new QLabel)
{
    note_->setWordWrap(true);
    note_->setTextFormat(Qt::PlainText);
    note_->setForegroundRole(QPalette::PlaceholderText);
    note_->setContentsMargins(8, 0, 8, 2);
    auto* numbers = new QWidget;
    auto* column = new QVBoxLayout(numbers);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(table_, 1);
    column->addWidget(note_);
    for (QTabWidget* tabs : {upper_, lower_}) { tabs->setDocumentMode(true); }
    upper_->addTab(numbers, tr("Candidates"));
    upper_->addTab(list_, tr("All Runs"));
    lower_->addTab(maps_, tr("Maps"));
    lower_->addTab(garment_maps_, tr("Maps"));
    lower_->addTab(curves_, tr("Curves"));
    lower_->addTab(fingerprint_, tr("Fingerprint"));
    lower_->addTab(scatter_, tr("Scatter"));
    lower_->addTab(why_, tr("Why"));
    lower_->addTab(cloths_, tr("3D"));
    auto* parts = new QSplitter(Qt::Vertical);
    parts->setChildrenCollapsible(false);
    parts->addWidget(upper_);
    parts->addWidget(lower_);
    parts->setSizes({300, 420});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar_);
    layout->addWidget(parts, 1);
    lower_->setTabVisible(lower_->indexOf(garment_maps_), false);
    connectParts();
    refresh();
}

void CompareView::connectParts()
{
    connect(maps_, &CompareMaps::mapsChanged, this, &CompareView::mapsChanged);
    connect(maps_, &CompareMaps::timeChanged, cloths_, &ClothsView::setTime);
    connect(cloths_, &ClothsView::timeChosen, maps_, &CompareMaps::setTime); // one clock
    connect(list_, &RunList::tickRequested, this, &CompareView::choose);
    connect(list_, &RunList::openRequested, this, &CompareView::runRequested);
    connect(list_, &RunList::markRequested, this, &CompareView::markRequested);
    connect(list_, &RunList::forgetRequested, this, &CompareView::forgetRequested);
    connect(table_, &CandidateTable::tickRequested, this, &CompareView::choose);
    connect(table_, &CandidateTable::openRequested, this, &CompareView::runRequested);
    connect(table_, &CandidateTable::runRequested, this, &CompareView::start);
    connect(table_, &CandidateTable::rankingChanged, this, &CompareView::refreshTable);
    connect(table_, &CandidateTable::baselineRequested, this, [this](const std::string& name) {
        baseline_ = name;
        refreshTable();
        refreshLower();
    });
    connectBar();
    connect(cards_, &CardColumns::changed, this, [this] {
        refreshTable();
        refreshLower();
    });
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &CompareView::refresh);
    connect(&runs_, &StudyRuns::changed, this, [this] {
        if (!soon_.isActive()) { soon_.start(100); }
    });
    connect(&runs_, &StudyRuns::ended, this, [this] {
        expected_.clear(); // as they were estimated before these runs
        refresh();
    });
    connect(&runs_, &StudyRuns::failed, this, &CompareView::failed);
    connect(&history_, &RunHistory::changed, this, &CompareView::refresh);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, this, &CompareView::refresh);
    connect(&document_, &Document::replaced, this, [this] {
        proposing_ = selecting_ = fidelity_follows_ = replicates_follow_ = true;
        replicates_of_.clear();
        bar_->showReplicates(1);
        selected_ = -1;
        baseline_.clear();
        chosen_.clear();
        measured_.clear();
    });
    connect(&document_, &Document::designChanged, this, [this] {
        if (isVisible()) { refresh(); } // else once it is shown
    });
}

void CompareView::connectBar()
{
    connect(bar_, &CompareBar::experimentChosen, this, [this] {
        selected_ = bar_->experiment() - 1;
        selecting_ = false;
        proposing_ = true;
        refresh();
    });
    connect(bar_, &CompareBar::fidelityChosen, this, [this] {
        fidelity_follows_ = false;
        refresh();
    });
    connect(bar_, &CompareBar::replicatesChosen, this, [this] {
        replicates_follow_ = false;
        refresh();
    });
    connect(bar_, &CompareBar::partChosen, this, [this] {
        for (const StudyRow& row : rows_) {
            const auto parts = row.candidate ? parts_in(row.candidate->outcomes) : std::vector<WearPartName>();
            if (const auto at = static_cast<std::size_t>(bar_->part()); at < parts.size()) { part_ = parts[at]; }
            if (!parts.empty()) { break; }
        }
        refresh();
    });
    connect(bar_, &CompareBar::filterChanged, table_, &CandidateTable::setFilter);
    connect(bar_, &CompareBar::saveRequested, this, &CompareView::saveTable);
    connect(bar_, &CompareBar::reportRequested, this, &CompareView::saveReport);
    connect(bar_, &CompareBar::measuredRequested, this, &CompareView::chooseMeasured);
    connect(bar_, &CompareBar::runAllRequested, this, [this] { start(missing()); });
    connect(bar_, &CompareBar::cancelRequested, &runs_, &StudyRuns::cancel);
    connect(&runs_, &StudyRuns::progressed, bar_, &CompareBar::showProgress);
}

void CompareView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

QString CompareView::nameOf(const KeptRun& run) const
{
    for (const StudyRow& row : rows_) {
        if (row.path == run.path) { return QString::fromStdString(row.fabric); }
    }
    return nameOfRun(history_, run);
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
        if (const int of = entryOf(*run); of >= 0 && !isOnScreen(*run)) { selected_ = of; }
    } else if (!on) {
        chosen_.removeAll(path);
    }
    refresh();
}

void CompareView::setBaseline(const QString& path)
{
    for (const StudyRow& row : rows_) {
        if (row.path == path) { baseline_ = row.fabric; }
    }
    refreshTable();
    refreshLower();
}

void CompareView::showExperiment(const std::string& name)
{
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&name](const Entry& each) { return each.own && each.name == name; });
    selected_ = name.empty() || found == entries_.end() ? -1 : static_cast<int>(found - entries_.begin());
    selecting_ = false;
    proposing_ = true;
    refresh();
}

void CompareView::setWaterColors(WaterColors colors)
{
    maps_->setWaterColors(colors);
    cloths_->setWaterColors(colors);
}

void CompareView::shareRanges(ColorRanges& ranges) { maps_->shareRanges(ranges); }

const std::vector<WaterMap*>& CompareView::maps() const { return maps_->maps(); }

QImage CompareView::picture() const
{
    if (maps_->maps().empty() && garment_maps_->panes().empty()) { return {}; }
    return lower_->currentWidget() == garment_maps_ ? garment_maps_->picture() : lower_->currentWidget()->grab().toImage();
}

/// The project's experiments, and those of completed runs that are of none of them.
void CompareView::findEntries()
{
    const bool own = selected_ >= 0 && entries_[static_cast<std::size_t>(selected_)].own;
    const std::string name = selected_ >= 0 ? entries_[static_cast<std::size_t>(selected_)].name : "";
    const Design conditions = selected_ >= 0 ? entries_[static_cast<std::size_t>(selected_)].conditions : Design();
    const bool overview = selected_ < 0;
    entries_.clear();
    const Design& design = *document_.design();
    RunRecord as_it_is;
    as_it_is.design.experiments = design.experiments;
    as_it_is.design.wears = design.wears;
    as_it_is.design.garments = design.garments;
    as_it_is.design.liquids = design.liquids;
    const auto add = [&](const std::string& experiment) {
        as_it_is.experiment = experiment;
        entries_.push_back({experiment, true, conditionsOf(as_it_is)});
    };
    for (const Experiment& experiment : design.experiments) { add(experiment.name); }
    for (const WearExperiment& wear : design.wears) { add(wear.name); }
    for (const KeptRun& run : history_.runs()) {
        if (run.problem.isEmpty() && run.complete() && entryOf(run) < 0) {
            entries_.push_back({run.run->experiment, false, conditionsOf(*run.run)});
        }
    }
    selected_ = -1;
    if (overview) { return; }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& each = entries_[i];
        if (own ? each.own && each.name == name : each.conditions == conditions) { selected_ = static_cast<int>(i); }
    }
    for (std::size_t i = 0; i < entries_.size() && selected_ < 0; ++i) { // it was renamed
        if (own && entries_[i].own && entries_[i].conditions == conditions) { selected_ = static_cast<int>(i); }
    }
}

int CompareView::entryOf(const KeptRun& run) const
{
    const Design conditions = conditionsOf(*run.run);
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& each) { return each.conditions == conditions; });
    return found == entries_.end() ? -1 : static_cast<int>(found - entries_.begin());
}

/// Whether it is of the experiment that is shown, as that is now.
bool CompareView::isOnScreen(const KeptRun& run) const { return entry() && conditionsOf(*run.run) == entry()->conditions; }

/// Where a run is looked for: with the project's experiment of that name, though that has changed since; a run of the project whose
/// experiment it no longer has moves nobody from another of its experiments.
int CompareView::homeOf(const KeptRun& run) const
{
    const auto named = [&run](const Entry& each) { return run.own && each.own && each.name == run.run->experiment; };
    const auto found = std::find_if(entries_.begin(), entries_.end(), named);
    if (found != entries_.end()) { return static_cast<int>(found - entries_.begin()); }
    const int of = entryOf(run);
    const bool is_older = run.own && of >= 0 && !entries_[static_cast<std::size_t>(of)].own;
    return is_older && entry() && entry()->own ? selected_ : of;
}

/// The newest run of each fabric on the experiment of the newest of all, or on that which the user has chosen.
void CompareView::propose()
{
    chosen_.clear();
    const auto& runs = history_.runs();
    const auto newest = std::find_if(runs.rbegin(), runs.rend(), [](const KeptRun& run) { // though its numbers are still being read
        return run.problem.isEmpty() && run.complete();
    });
    if (selecting_ && newest != runs.rend()) {
        selected_ = homeOf(*newest);
    } else if (selecting_ && document_.experiment()) {
        selected_ = document_.experimentIndex();
    }
    QStringList fabrics;
    const KeptRun* first = nullptr;
    for (auto run = runs.rbegin(); run != runs.rend() && chosen_.size() < most_runs; ++run) {
        if (!whyNotCompared(*run, first ? *first : *run).isEmpty() || !isOnScreen(*run)) { continue; }
        const QString fabric = QString::fromStdString(run->cloth());
        if (fabrics.contains(fabric)) { continue; }
        if (!first) { first = &*run; }
        chosen_ << run->path;
        fabrics << fabric;
    }
    if (!fidelity_follows_) { return; }
    const KeptRun* shown = !selecting_ && first ? first : newest != runs.rend() ? &*newest : nullptr;
    if (shown) { bar_->setFidelity(shown->run->plan.fidelity); }
}

/// Without those that are gone or no more of the experiment as it is; where none is left, others are proposed.
void CompareView::dropOutdated()
{
    const auto before = chosen_.size();
    chosen_.removeIf([this](const QString& path) {
        const KeptRun* run = history_.find(path);
        return !run || (entry() && !isOnScreen(*run));
    });
    if (chosen_.isEmpty() && before > 0 && entry()) { proposing_ = true; }
}

/// As many as the kept results have, until the user chooses: an edit takes none away.
void CompareView::followReplicates()
{
    const Entry* shown = entry();
    if (!shown || !shown->own || document_.hasError()) { return; }
    const int kept = keptReplicates(*document_.design(), history_.runs(), runs_.store().sets(), choiceOf(*shown), bar_->replicateChoices());
    const bool another = std::exchange(replicates_of_, shown->name) != shown->name;
    if (another || kept > bar_->replicates()) { bar_->showReplicates(kept); }
}

void CompareView::refresh()
{
    soon_.stop();
    findEntries();
    dropOutdated();
    const bool finding = history_.listing(); // which runs there are is not known: nothing follows from those that were found so far
    bar_->setReading(finding && proposing_ && fidelity_follows_);
    if (proposing_ && !finding) { propose(); }
    if (replicates_follow_ && !finding) { followReplicates(); }
    QStringList names{tr("All experiments")};
    for (const Entry& each : entries_) {
        const QString name = QString::fromStdString(each.name);
        names << (each.own ? name : tr("%1, of other runs").arg(name));
    }
    bar_->setExperiments(names, selected_ + 1);
    rows_.clear();
    if (const Entry* shown = entry()) { rows_ = rowsOf(*shown); }
    refreshParts();
    refreshTabs();
    refreshTable();
    list_->refresh(chosen_);
    refreshLower();
    refreshMissing();
}

/// Panels and zones of the garment, once a run has named them.
void CompareView::refreshParts()
{
    std::vector<WearPartName> parts;
    for (const StudyRow& row : rows_) {
        if (parts.empty() && entry()->worn() && row.candidate) { parts = parts_in(row.candidate->outcomes); }
    }
    const auto at = std::find(parts.begin(), parts.end(), part_);
    if (at == parts.end()) { part_ = {}; }
    QStringList titles;
    for (const WearPartName& part : parts) { titles << (part.title.empty() ? tr("whole garment") : coreWord(part.title)); }
    bar_->setParts(titles, at == parts.end() ? 0 : static_cast<int>(at - parts.begin()));
}

/// Maps of garments have their 3D in them; where nothing is chosen, the maps of samples say what to do.
void CompareView::refreshTabs()
{
    const bool worn = entry() && entry()->worn(), was = lower_->isTabVisible(lower_->indexOf(garment_maps_));
    if (worn == was) { return; }
    const QWidget* shown = lower_->currentWidget();
    for (QWidget* tab : {static_cast<QWidget*>(maps_), static_cast<QWidget*>(cloths_)}) {
        lower_->setTabVisible(lower_->indexOf(tab), !worn);
    }
    lower_->setTabVisible(lower_->indexOf(garment_maps_), worn);
    if (shown == maps_ || shown == cloths_ || shown == garment_maps_) {
        lower_->setCurrentWidget(worn ? static_cast<QWidget*>(garment_maps_) : maps_);
    }
}

std::vector<OutcomeInfo> CompareView::criteriaOf(const Entry& entry) const
{
    return entry.worn() ? compared_by_wear(part_) : compared_by(entry.conditions.experiments.front().type);
}

StudyChoice CompareView::choiceOf(const Entry& entry) const
{
    // Without a sound design nothing can be drawn.
    return {entry.name, bar_->fidelity(), document_.hasError() || !entry.own ? 1 : bar_->replicates()};
}

/// The project's fabrics. What is missing is known once its runs are found.
std::vector<StudyRow> CompareView::ownRowsOf(const Entry& entry) const
{
    static const std::vector<ReplicateSet> none; // what replicates of an unsound design are of cannot be said
    const std::vector<ReplicateSet>& sets = document_.hasError() ? none : runs_.store().sets();
    std::vector<StudyRow> rows = studyRows(*document_.design(), history_.runs(), sets, choiceOf(entry));
    for (StudyRow& row : rows) {
        if (!history_.listing()) { continue; }
        row.reading = row.path.isEmpty();
        row.missing.clear();
    }
    return rows;
}

/// The project's fabrics, then what else is ticked.
std::vector<StudyRow> CompareView::rowsOf(const Entry& entry) const
{
    std::vector<StudyRow> rows;
    if (entry.own) { rows = ownRowsOf(entry); }
    for (const KeptRun& run : compared()) {
        const bool known = std::any_of(rows.begin(), rows.end(), [&run](const StudyRow& row) { return row.path == run.path; });
        if (known || conditionsOf(*run.run) != entry.conditions || !run.measured()) { continue; }
        StudyRow row;
        row.fabric = nameOfRun(history_, run).toStdString();
        const auto is_taken = [&row](const StudyRow& other) { return other.fabric == row.fabric; };
        if (std::any_of(rows.begin(), rows.end(), is_taken)) {
            row.fabric = tr("%1: %2").arg(run.number).arg(QString::fromStdString(row.fabric)).toStdString();
        }
        row.path = run.path;
        row.runs = 1;
        row.candidate = candidateOf(run);
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace hygroloom
