// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which fabrics, and running their mixtures. The table: why_view_table.cpp.
#include "ui/compare/why_view.h"

#include "ui/basics/appearance.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity.h"
#include "ui/compare/chart_style.h"
#include "ui/compare/why_delegate.h"
#include "ui/results/plan_dialog.h"
#include "ui/results/report_file.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

void addField(QHBoxLayout* row, const QString& name, QComboBox* box)
{
    auto* label = new QLabel(name);
    label->setBuddy(box);
    box->setAccessibleName(QString(name).remove('&').remove(':'));
    box->setMinimumContentsLength(10);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    row->addWidget(label);
    row->addWidget(box, 1);
    row->addSpacing(6);
}

} // namespace

WhyView::WhyView(StudyRuns& runs, QWidget* parent)
    : QWidget(parent), runs_(runs), fabric_(new QComboBox), against_(new QComboBox), metric_(new QComboBox),
      find_(new QPushButton(tr("Find &Out"))), state_(makeNote(tr("State of the question"))), heading_(new QLabel),
      table_(new QTableWidget), note_(makeNote(tr("What the contributions rest on")))
{
    heading_->setAccessibleName(tr("Answer"));
    heading_->setWordWrap(true);
    heading_->setTextFormat(Qt::PlainText);
    heading_->setContentsMargins(8, 0, 8, 2);
    state_->setContentsMargins(0, 0, 0, 0);
    table_->setAccessibleName(tr("Parts that differ and what they make"));
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setTabKeyNavigation(false); // Tab leaves it
    table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->setWordWrap(true);
    table_->setMinimumSize(200, 80);
    table_->verticalHeader()->hide();
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->setColumnCount(5);
    table_->setItemDelegateForColumn(3, new WhyDelegate(table_));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(head());
    layout->addWidget(heading_);
    layout->addWidget(table_, 1);
    layout->addWidget(note_);
    layout->addStretch(); // without a table, the choices stay at the top
    connectParts();
}

QWidget* WhyView::head()
{
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(8, 6, 8, 2);
    addField(row, tr("&Why is:"), fabric_);
    addField(row, tr("a&gainst:"), against_);
    addField(row, tr("&by:"), metric_);
    row->addWidget(find_);
    row->addSpacing(6);
    row->addWidget(state_, 2);
    find_->setToolTip("<p>" +
                      tr("Run fabrics that have some parts of the one and some of the other, and see what each part makes of the "
                         "difference. The runs go on in the background.") +
                      "</p>");
    return head;
}

void WhyView::connectParts()
{
    for (QComboBox* box : {fabric_, against_}) {
        connect(box, &QComboBox::activated, this, [this] { proposing_ = false; });
        connect(box, &QComboBox::currentIndexChanged, this, &WhyView::plan);
    }
    connect(metric_, &QComboBox::activated, this, [this] { ranking_ = false; });
    connect(metric_, &QComboBox::currentIndexChanged, this, &WhyView::refresh);
    connect(find_, &QPushButton::clicked, this, &WhyView::findOut);
    connect(&runs_, &StudyRuns::mixtureEnded, this, &WhyView::take);
    connect(&runs_, &StudyRuns::changed, this, [this] { showState(); });
    connect(&runs_, &StudyRuns::ended, this, &WhyView::end);
    connect(&runs_, &StudyRuns::progressed, this, [this] { showState(); });
}

void WhyView::setStudy(WhyStudy study)
{
    const bool other = study.comparison.experiment != study_.comparison.experiment;
    study_ = std::move(study);
    if (other) { proposing_ = ranking_ = true; }
    fillBoxes();
    plan();
}

/// Of the project's fabrics those that have been run; by default the best against the baseline.
void WhyView::fillBoxes()
{
    const QSignalBlocker quiet_fabric(fabric_), quiet_against(against_), quiet_metric(metric_);
    const QString fabric = fabric_->currentText(), against = against_->currentText(), metric = metric_->currentText();
    const Comparison& comparison = study_.comparison;
    QStringList names, titles;
    for (const Candidate& each : comparison.candidates) {
        if (study_.own && find_fabric(*study_.design, each.fabric)) { names << QString::fromStdString(each.fabric); }
    }
    for (const OutcomeInfo& each : comparison.criteria) { titles << coreTitle(each.title, each.part); }
    const QString base = QString::fromStdString(comparison.baseline);
    QStringList others = names;
    others.removeAll(base);
    const auto fill = [](QComboBox* box, const QStringList& texts, const QString& wished) {
        box->clear();
        box->addItems(texts);
        box->setCurrentIndex(std::max(texts.isEmpty() ? -1 : 0, static_cast<int>(texts.indexOf(wished))));
        box->setEnabled(texts.size() > 1);
        box->setToolTip(box->currentText());
    };
    fill(fabric_, names, proposing_ || !names.contains(fabric) ? others.value(0) : fabric);
    fill(against_, names, proposing_ || !names.contains(against) ? base : against);
    fill(metric_, titles, ranking_ ? coreTitle(comparison.ranked_by.title, comparison.ranked_by.part) : metric);
}

void WhyView::choose(const QString& fabric, const QString& against, int metric)
{
    proposing_ = ranking_ = false;
    {
        const QSignalBlocker quiet_fabric(fabric_), quiet_against(against_), quiet_metric(metric_);
        fabric_->setCurrentText(fabric);
        against_->setCurrentText(against);
        metric_->setCurrentIndex(metric);
    }
    plan();
}

const Candidate* WhyView::candidateOf(const QComboBox* box) const
{
    const std::string name = box->currentText().toStdString();
    const auto& all = study_.comparison.candidates;
    const auto found = std::find_if(all.begin(), all.end(), [&name](const Candidate& each) { return each.fabric == name; });
    return found == all.end() || box->currentIndex() < 0 ? nullptr : &*found;
}

/// Whether all of its replicates are there.
bool WhyView::complete(const Candidate& candidate) const
{
    const auto& replicates = candidate.replicates;
    return static_cast<int>(replicates.size()) >= study_.choice.replicates &&
           std::all_of(replicates.begin(), replicates.end(), [](const auto& each) { return each.has_value(); });
}

/// What keeps the question from being asked, in a sentence.
QString WhyView::whyNot() const
{
    if (study_.comparison.criteria.empty() || !study_.own) { return tr("Choose an experiment of the project above."); }
    if (find_wear(*study_.design, study_.choice.experiment)) {
        return tr("Mixtures of fabrics are run on samples alone. Choose an experiment on a sample above.");
    }
    const Candidate *fabric = candidateOf(fabric_), *against = candidateOf(against_);
    if (!fabric || fabric_->count() < 2) { return tr("Run the experiment on two fabrics of the project first (Run All Missing)."); }
    if (!against || fabric == against) { return tr("Choose two different fabrics."); }
    if (!complete(*fabric) || !complete(*against)) { return tr("Replicates of these fabrics are missing: Run All Missing runs them."); }
    return study_.cannot_run;
}

/// Which parts differ, in the background: mixtures are checked as fabrics are.
void WhyView::plan()
{
    const bool replicates = study_.choice.replicates > 1;
    Planned wanted{study_.design, study_.choice.experiment, fabric_->currentText().toStdString(), against_->currentText().toStdString(),
                   replicates};
    for (const char* unit : {"mm", "tex", "/cm"}) { wanted.units << userUnit(unit).unit; }
    const bool possible = whyNot().isEmpty();
    const bool known = possible && wanted == planned_;
    if (!known) {
        plan_.reset();
        planner_.drop();
        planned_ = possible ? wanted : Planned();
    }
    refresh();
    if (known || !possible) { return; }
    planner_.run([this, design = study_.design, choice = study_.choice, fabric = wanted.fabric,
                  against = wanted.against](const NewestJob::Turn& turn) {
        WhyPlan made = plan_why(*design, fabric, against, choice.experiment, choice.replicates > 1, unitsOfReader());
        turn.deliver([this, made = std::move(made)] {
            plan_ = made;
            refresh();
        });
    });
}

std::pair<ReplicateKey, ReplicateKey> WhyView::keys() const
{
    const auto key = [this](const QComboBox* box) {
        const StudyChoice& choice = study_.choice;
        return keyOf(*study_.design,
                     {box->currentText().toStdString(), choice.experiment, choice.fidelity, false, 0, choice.replicates, {}, 0});
    };
    return {key(fabric_), key(against_)};
}

/// nullptr: nothing was found out of them.
const WhyView::Known* WhyView::known(const std::pair<ReplicateKey, ReplicateKey>& keys) const
{
    const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& each) { return each.keys == keys; });
    return found == known_.end() ? nullptr : &*found;
}

/// The runs that the question still needs.
std::vector<StudyJob> WhyView::missing() const
{
    std::vector<StudyJob> jobs;
    const Known* own = known(keys());
    const StudyChoice& choice = study_.choice;
    for (int number = 0; number < choice.replicates; ++number) {
        for (const Mixture mixture : plan_->mixtures) {
            if (own && own->ended.contains({mixture, number})) { continue; }
            jobs.push_back({plan_->fabric, choice.experiment, choice.fidelity, false, number, choice.replicates, plan_->against, mixture});
        }
    }
    return jobs;
}

/// s, of a mixture: as long as the two fabrics' own took.
double WhyView::secondsOfRun() const { return 0.5 * (candidateOf(fabric_)->wall + candidateOf(against_)->wall); }

void WhyView::findOut()
{
    if (asking_) {
        runs_.cancel();
        return;
    }
    if (!plan_ || !whyNot().isEmpty()) { return; }
    std::vector<StudyRuns::Expected> expected;
    for (const StudyJob& job : missing()) {
        expected.push_back({job, secondsOfRun(), std::make_shared<const Design>(mixed(*study_.design, *plan_, job.mixture))});
    }
    if (expected.empty()) { return; }
    asked_ = keys();
    if (!known(asked_)) { known_.push_back({asked_, {}, {}, {}}); }
    asking_ = runs_.start(expected) && runs_.running();
    if (asking_) {
        for (Known& each : known_) {
            if (each.keys == asked_) { each.failed.clear(); }
        }
        refresh();
    }
    showState();
}

void WhyView::take(const StudyJob& job, const Candidate& candidate)
{
    const auto found = std::find_if(known_.begin(), known_.end(), [this](const Known& each) { return each.keys == asked_; });
    if (found == known_.end()) { return; }
    if (!candidate.failure.empty()) {
        found->failed[{job.mixture, job.number}] = candidate.failure;
        return;
    }
    add_replicate(found->mixtures[job.mixture], candidate, job.number);
    found->ended.insert({job.mixture, job.number});
}

void WhyView::end()
{
    asking_ = false;
    refresh();
}

} // namespace hygroloom
