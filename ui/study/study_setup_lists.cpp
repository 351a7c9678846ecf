// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the form of a study shows of the project, and what it makes of the fields.
#include "ui/study/study_setup.h"

#include "core/analysis/card.h"
#include "core/base/error.h"
#include "core/garment/pattern.h"
#include "core/wear/wear_outcomes.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/quantity.h"
#include "ui/document/document.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <QTreeWidget>

#include <algorithm>
#include <cstdio>

namespace hygroloom {

namespace {

std::vector<std::string> ticked(const QListWidget& list)
{
    std::vector<std::string> names;
    for (int i = 0; i < list.count(); ++i) {
        if (list.item(i)->checkState() == Qt::Checked) { names.push_back(list.item(i)->data(Qt::UserRole).toString().toStdString()); }
    }
    return names;
}

void addItem(QListWidget& list, const QString& key, const QString& text, bool on)
{
    auto* item = new QListWidgetItem(text, &list);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setData(Qt::UserRole, key);
    item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    item->setToolTip("<p>" + text.toHtmlEscaped() + "</p>");
}

template <typename Member> std::vector<std::string> namesOf(const std::vector<Member>& members)
{
    std::vector<std::string> names;
    for (const Member& member : members) { names.push_back(member.name); }
    return names;
}

std::vector<std::string> experimentsOf(const Design& design)
{
    std::vector<std::string> names = namesOf(design.experiments);
    for (const std::string& worn : namesOf(design.wears)) { names.push_back(worn); }
    return names;
}

/// The project's members, and of those ticked also the ones that it does not have. otherwise: which is ticked where none is; none: none.
void fillNames(QListWidget& list, const std::vector<std::string>& members, std::vector<std::string> on, std::optional<int> otherwise,
               bool keep_others)
{
    const auto is_there = [&members](const std::string& name) { return std::find(members.begin(), members.end(), name) != members.end(); };
    if (!keep_others) {
        std::erase_if(on, [&](const std::string& name) { return !is_there(name); });
    }
    if (on.empty() && otherwise && !members.empty()) {
        on.push_back(members[std::min(static_cast<std::size_t>(*otherwise), members.size() - 1)]);
    }
    list.clear();
    for (const std::string& member : members) {
        const auto found = std::find(on.begin(), on.end(), member);
        addItem(list, QString::fromStdString(member), QString::fromStdString(member), found != on.end());
        if (found != on.end()) { on.erase(found); }
    }
    for (const std::string& name : on) {
        const QString text = QString::fromStdString(name);
        addItem(list, text, StudySetup::tr("%1 (not in this project)").arg(text), true);
    }
}

/// Of a built-in one all; of one from a file those that the project names.
std::vector<std::string> panelsOf(const Garment& garment)
{
    std::vector<std::string> names;
    if (!garment.is_built_in()) {
        for (const auto& [panel, cut] : garment.panels) {
            if (panel != "*") { names.push_back(panel); }
        }
        return names;
    }
    try {
        for (const PatternPanel& panel : read_pattern(garment, {}).panels) { names.push_back(panel.name); }
    } catch (const Error&) { // the project's issues say it
    }
    return names;
}

} // namespace

void StudySetup::refreshLists()
{
    const QScopedValueRollback filling(filling_, true);
    const Design& design = *document_.design();
    const bool fresh = fabrics_->count() == 0 && experiments_->count() == 0;
    const bool is_one = !drafts_.empty() || !kept_.fabrics.empty(); // until then it follows the project
    fillNames(*experiments_, experimentsOf(design), fresh ? kept_.experiments : ticked(*experiments_), document_.experimentIndex(), is_one);
    fillNames(*fabrics_, namesOf(design.fabrics), fresh ? kept_.fabrics : ticked(*fabrics_),
              ofGarments() ? std::nullopt : std::optional(document_.fabricIndex()), is_one);
    refreshMetrics();
    refreshFactors();
    refreshProblems();
}

/// Whether a garment is worn in what is ticked.
bool StudySetup::ofGarments() const
{
    const std::vector<std::string> on = ticked(*experiments_);
    return std::any_of(on.begin(), on.end(), [this](const std::string& name) { return find_wear(*document_.design(), name); });
}

/// Of a garment also those of its panels, where they are known without reading a file; others can stand in the file of a study.
void StudySetup::addMetricsOf(const std::string& experiment, std::vector<std::string>& known, std::vector<std::string>& compared) const
{
    const auto add = [](const std::vector<OutcomeInfo>& infos, std::vector<std::string>& into) {
        for (const OutcomeInfo& info : infos) {
            if (std::find(into.begin(), into.end(), info.key) == into.end()) { into.push_back(info.key); }
        }
    };
    const Design& design = *document_.design();
    if (const Experiment* sample = find_experiment(design, experiment)) {
        add(compared_by(sample->type), compared);
        add(reported_by(sample->type), known);
        add(card_metrics(), known);
    }
    const WearExperiment* wear = find_wear(design, experiment);
    if (!wear) { return; }
    add(compared_by_wear(), compared);
    for (const WearNumber& number : wear_numbers()) { add({number.info}, known); }
    const Garment* garment = find_garment(design, wear->garment);
    for (const std::string& panel : garment ? panelsOf(*garment) : std::vector<std::string>()) {
        add(compared_by_wear({"panels/" + panel + "/", "panel " + panel}), known);
    }
}

/// Those of the ticked experiments. Of a new list those that fabrics are compared by are ticked, unless the study says others.
void StudySetup::refreshMetrics()
{
    std::vector<std::string> known, compared;
    for (const std::string& name : ticked(*experiments_)) { addMetricsOf(name, known, compared); }
    fabrics_->setToolTip(
        ofGarments()
            ? "<p>" + tr("Each ticked fabric takes the place of all panels' own. Tick none to leave the garment as it is cut.") + "</p>"
            : QString());
    if (known == known_metrics_ && metrics_->count() > 0) { return; }
    const bool fresh = metrics_->count() == 0;
    std::vector<std::string> on = fresh ? kept_.metrics : ticked(*metrics_);
    const auto is_known = [&known](const std::string& key) { return std::find(known.begin(), known.end(), key) != known.end(); };
    if (!fresh) {
        std::erase_if(on, [&](const std::string& key) { return !is_known(key); });
    }
    if (on.empty()) { on = compared; }
    for (const std::string& key : on) {
        if (!is_known(key)) { known.push_back(key); } // the study file has it; what is wrong is said below
    }
    known_metrics_ = known;
    metrics_->clear();
    for (const std::string& key : known) {
        const MetricName name = metricName(key);
        addItem(*metrics_, QString::fromStdString(key), titleWithUnit(name.title, userUnit(name.unit).unit),
                std::find(on.begin(), on.end(), key) != on.end());
    }
}

void StudySetup::refreshFactors()
{
    const QScopedValueRollback filling(filling_, true);
    const int at = factors_->indexOfTopLevelItem(factors_->currentItem());
    while (factors_->topLevelItemCount() > static_cast<int>(drafts_.size())) { delete factors_->takeTopLevelItem(0); }
    while (factors_->topLevelItemCount() < static_cast<int>(drafts_.size())) { new QTreeWidgetItem(factors_); }
    for (int i = 0; i < factors_->topLevelItemCount(); ++i) {
        const DraftFactor& draft = drafts_[static_cast<std::size_t>(i)];
        const StudyField own = fieldAt(*document_.design(), draft.factor.path);
        const StudyField field = inReadersUnit(own);
        QTreeWidgetItem* item = factors_->topLevelItem(i);
        item->setText(0, fieldTitle(field, true));
        item->setText(1, draft.complaint.isEmpty() ? spreadText(draft.factor, unitOfFactor(own.unit)) : tr("incomplete"));
        const QString now = field.value ? tr("Now %1.").arg(studyNumber(*field.value)) : QString();
        item->setToolTip(0, "<p>" + QString::fromStdString(draft.factor.path).toHtmlEscaped() + ". " + now + "</p>");
    }
    if (at >= 0) { factors_->setCurrentItem(factors_->topLevelItem(std::min(at, factors_->topLevelItemCount() - 1))); }
}

Study StudySetup::read() const
{
    Study study = kept_;
    study.fabrics = ticked(*fabrics_);
    study.experiments = ticked(*experiments_);
    study.metrics = ticked(*metrics_);
    study.factors.clear();
    for (const DraftFactor& draft : drafts_) { study.factors.push_back(draft.factor); }
    study.sampling = static_cast<Sampling>(sampling_->currentIndex());
    study.points = study.sampling == Sampling::one_at_a_time ? 0 : static_cast<std::size_t>(points_->value());
    study.replicates = replicates_->value();
    const int fidelity = fidelity_->currentIndex();
    study.fidelity = fidelity < static_cast<int>(all_fidelities.size()) ? std::optional(static_cast<Fidelity>(fidelity)) : std::nullopt;
    study.error = study.fidelity ? 0 : error_->value() / 100;
    study.sensitivity = static_cast<Sensitivity>(sensitivity_->currentIndex());
    study.seed = seed_->text().trimmed().toULongLong();
    return study;
}

Study StudySetup::study() const
{
    const Study as_shown = read();
    const auto incomplete = [](const DraftFactor& draft) { return !draft.complaint.isEmpty(); };
    if (std::any_of(drafts_.begin(), drafts_.end(), incomplete)) { return as_shown; }
    try {
        return parse_study(format_study(as_shown), "study");
    } catch (const Error&) {
        return as_shown;
    }
}

/// "factors[1].path" -> the title of that factor.
QString StudySetup::placeInWords(const Place& where) const
{
    const std::optional<std::size_t> at = where.key(0) == "factors" ? where.number(0) : std::nullopt;
    if (!at || *at >= drafts_.size()) { return QString::fromStdString(where.text()); }
    return fieldTitle(inReadersUnit(fieldAt(*document_.design(), drafts_[*at].factor.path)), false);
}

void StudySetup::refreshProblems()
{
    numbers_->setRowVisible(error_, fidelity_->currentIndex() == static_cast<int>(all_fidelities.size()));
    points_->setEnabled(static_cast<Sampling>(sampling_->currentIndex()) != Sampling::one_at_a_time);
    const bool no_cloth = ticked(*fabrics_).empty() && !ofGarments();
    const bool lacks_garment = ofGarments() && document_.hasError();                 // it may be the garment that is missing
    add_->setEnabled(!no_cloth && !lacks_garment && !ticked(*experiments_).empty()); // else no field would change a run
    problems_.clear();
    for (const DraftFactor& draft : drafts_) {
        const QString title = fieldTitle(inReadersUnit(fieldAt(*document_.design(), draft.factor.path)), false);
        if (!draft.complaint.isEmpty()) { problems_ << tr("%1: %2").arg(title, draft.complaint); }
    }
    bool is_number = false;
    seed_->text().trimmed().toULongLong(&is_number);
    if (!is_number) {
        problems_ << tr("Seed: This must be a whole number from 0 to 18446744073709551615; given is “%1”.").arg(seed_->text());
    }
    if (no_cloth) { problems_ << tr("Fabrics: Tick one at least."); }
    if (ticked(*experiments_).empty()) { problems_ << tr("Experiments: Tick one at least."); }
    if (document_.hasError()) { problems_ << tr("The project has an error; the Issues panel says which."); }
    if (!problems_.isEmpty()) { return; }
    try {
        const Study study = parse_study(format_study(read()), "study");
        for (const Issue& issue : validate(study, *document_.design())) {
            if (issue.severity == Severity::error) { problems_ << tr("%1: %2").arg(placeInWords(issue.where), issueText(issue)); }
        }
    } catch (const Error& error) {
        const QString sentence = QString::fromStdString(error.what()).remove(0, QString("study: ").size());
        const qsizetype colon = sentence.indexOf(": ");
        const std::string at = sentence.left(colon).toStdString(); // a reader of files tells its places as texts
        std::size_t factor = 0;
        const bool is_factor = std::sscanf(at.c_str(), "factors[%zu]", &factor) == 1;
        problems_ << tr("%1: %2").arg(placeInWords(is_factor ? Place("factors") / factor : Place(at.c_str())), sentence.mid(colon + 2));
    }
}

} // namespace hygroloom
