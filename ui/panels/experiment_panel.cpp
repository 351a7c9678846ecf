// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/experiment_panel.h"

#include "core/base/words.h"

#include "ui/basics/core_words.h"
#include "ui/basics/icon_button.h"
#include "ui/basics/name_dialog.h"
#include "ui/panels/climate_course.h"
#include "ui/panels/droplet_section.h"
#include "ui/panels/liquid_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdlib>

namespace hygroloom {

namespace {

QString titleOf(ExperimentType type)
{
    const ExperimentTypeInfo& info = info_of(type);
    return *info.standard ? ExperimentPanel::tr("%1 (%2)").arg(coreWord(info.title), info.standard) : coreWord(info.title);
}

/// That an experiment of the type has until somebody changes it; a number may follow.
std::string usualName(ExperimentType type)
{
    if (type == ExperimentType::droplet) { return QCoreApplication::translate("hygroloom::ExperimentPanel", "one drop").toStdString(); }
    return coreWord(QString::fromUtf8(info_of(type).title).toLower()).toStdString();
}

bool isUsualName(const std::string& name, ExperimentType type)
{
    const std::string usual = usualName(type);
    if (!name.starts_with(usual)) { return false; }
    const std::string rest = name.substr(usual.size());
    return rest.empty() || (rest.size() > 1 && rest[0] == ' ' && rest.find_first_not_of("0123456789", 1) == std::string::npos);
}

std::string freeName(const std::string& wish, const Design& design)
{
    return free_name(wish, [&design](const std::string& name) { return find_experiment(design, name) != nullptr; });
}

} // namespace

Experiment freshExperiment(ExperimentType type)
{
    Experiment experiment = standard_experiment(type);
    if (type == ExperimentType::droplet) { experiment.sample_mm = {40, 40}; }
    return experiment;
}

ExperimentPanel::ExperimentPanel(Document& document, QWidget* parent)
    : QScrollArea(parent), document_(document), form_(new DesignForm(document))
{
    addChoice();
    addConditions();
    addTypes();
    groups_.push_back({form_->addGroup(), "droplets"});
    droplets_ = new DropletSection(*form_, this);
    addModel();
    form_->fill(this);
    form_->onRefresh([this] {
        refreshChoice();
        refreshType();
    });
    form_->refresh();
}

QuantityEdit* ExperimentPanel::addSampleSize(std::size_t axis)
{
    const DesignField size{
        axis == 0 ? tr("Along the weft") : tr("Along the warp"),
        axis == 0 ? tr("sample width") : tr("sample height"),
        [this, axis] {
            const ExperimentType type = document_.experiment() ? document_.experiment()->type : ExperimentType{};
            return "experiments[" + std::to_string(document_.experimentIndex()) + "]." + info_of(type).sample_key + "[" +
                   std::to_string(axis) + "]";
        },
        [this, axis] { return document_.experiment() ? std::optional(document_.experiment()->sample_mm[axis]) : std::nullopt; },
        [this, axis](Design& design, std::optional<double> value) {
            double& sample = design.experiments[static_cast<std::size_t>(document_.experimentIndex())].sample_mm[axis];
            sample = value.value_or(sample);
        },
        {}};
    return form_->addQuantity(Quantity::length(0.1, 2000), size);
}

void ExperimentPanel::addChoice()
{
    choice_ = new QComboBox;
    choice_->setAccessibleName(tr("Experiment"));
    choice_->setMinimumContentsLength(8);
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    QToolButton* add = iconButton("add", tr("Add an experiment"));
    rename_ = iconButton("rename", tr("Rename the experiment"));
    remove_ = iconButton("delete", tr("Delete the experiment"));
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(choice_, 1);
    layout->addWidget(add);
    layout->addWidget(rename_);
    layout->addWidget(remove_);
    form_->addWide(line);
    type_ = new QComboBox;
    for (int type = 0; type < experiment_types; ++type) { type_->addItem(titleOf(static_cast<ExperimentType>(type))); }
    type_->setToolTip(tr("A new type sets the climate, sample and duration of its standard."));
    type_->setAccessibleName(tr("Type of experiment"));
    type_->setMinimumContentsLength(8);
    type_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form_->addWide(type_);
    connect(type_, &QComboBox::activated, this, &ExperimentPanel::setType);
    connect(choice_, &QComboBox::activated, &document_, &Document::setExperimentIndex);
    connect(add, &QToolButton::clicked, this, &ExperimentPanel::addExperiment);
    connect(rename_, &QToolButton::clicked, this, &ExperimentPanel::renameExperiment);
    connect(remove_, &QToolButton::clicked, this, &ExperimentPanel::removeExperiment);
}

void ExperimentPanel::addConditions()
{
    form_->addSection(tr("Climate"));
    const FormOwner<Climate> climate =
        part<Climate>([this] { return document_.experiment() && !document_.experiment()->climates.empty() ? "climate[0]." : "climate."; },
                      [](auto& experiment) { return &experiment.climate; });
    for (const Field<Climate>& row : fields_of<Climate>()) { form_->addNumber(climate, row.key); }
    course_ = new ClimateCourse(document_);
    form_->addWide(course_);
    form_->addSection(tr("Sample"));
    for (const std::size_t axis : {0, 1}) { size_[axis] = addSampleSize(axis); }
    form_->addNumber(whole(), "duration_s");
}

/// What only some types have, each in a group of its own.
void ExperimentPanel::addTypes()
{
    const auto group = [this](const char* field) { groups_.push_back({form_->addGroup(), field}); };
    group("volume_ul");
    form_->addNumber(whole(), "volume_ul");
    group("feed_s");
    form_->addNumber(whole(), "feed_s");
    form_->addNumber(whole(), "drop_ul");
    group("direction");
    direction_ = new QComboBox;
    direction_->addItems({tr("Along the warp"), tr("Along the weft")});
    form_->addRow(tr("Strip"), direction_);
    connect(direction_, &QComboBox::activated, this,
            [this](int chosen) { edit(tr("direction of the strip"), [&](Experiment& e) { e.along_weft = chosen == 1; }); });
    form_->addNumber(whole(), "immersion_mm");
    group("initial_water_g_m2");
    form_->addNumber(whole(), "initial_water_g_m2");
    group("initial");
    const FormOwner<Climate> initial =
        part<Climate>([] { return "initial."; }, [](auto& experiment) { return &experiment.initial; }, tr("initial"));
    DesignField temperature = field_of(initial, "temperature_c"), humidity = field_of(initial, "relative_humidity");
    temperature.label = tr("Initial temperature");
    temperature.help = tr("Temperature of the air in which the sample was conditioned.");
    humidity.label = tr("Initial humidity");
    humidity.help = tr("Relative humidity of the air in which the sample was conditioned.");
    form_->addNumber<Climate>("temperature_c", temperature);
    form_->addNumber<Climate>("relative_humidity", humidity);
    group("rate_g_m2_h");
    form_->addNumber(whole(), "rate_g_m2_h");
    side_ = new QComboBox;
    side_->addItems({tr("Bottom"), tr("Top")});
    form_->addRow(tr("Face"), side_);
    connect(side_, &QComboBox::activated, this,
            [this](int chosen) { edit(tr("sweating face"), [&](Experiment& e) { e.from_top = chosen == 1; }); });
}

void ExperimentPanel::addModel()
{
    form_->addSection(tr("Liquid"));
    liquids_ = new LiquidPanel(*form_, this);
    closure_ = new QComboBox;
    closure_->addItems({tr("Mao et al. (as printed)"), tr("Pores in and between yarns")});
    closure_->setToolTip(
        tr("How liquid moves in the pores of the yarns. Mao et al.: pores of 0.2 mm, one contact angle for all "
           "fibres, uptake in proportion to regain. Pores in and between yarns: liquid follows suction, and a stain stops."));
    form_->addRow(tr("Wicking model"), closure_);
    connect(closure_, &QComboBox::activated, this,
            [this](int chosen) { edit(tr("wicking model"), [&](Experiment& e) { e.closure = static_cast<Closure>(chosen); }); });
    swelling_ = new QCheckBox(tr("Wet fibres swell"));
    form_->addWide(swelling_);
    connect(swelling_, &QCheckBox::clicked, this, [this](bool on) { edit(tr("swelling"), [&](Experiment& e) { e.swelling = on; }); });
    liquids_->addOwnLiquids();
}

void ExperimentPanel::refreshChoice()
{
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    for (const Experiment& experiment : document_.design()->experiments) { choice_->addItem(QString::fromStdString(experiment.name)); }
    choice_->setCurrentIndex(document_.experiment() ? document_.experimentIndex() : -1);
    choice_->setEnabled(choice_->count() > 0);
    remove_->setEnabled(document_.experiment());
    rename_->setEnabled(document_.experiment());
}

/// Shows what the experiment's type has.
void ExperimentPanel::refreshType()
{
    const Experiment* experiment = document_.experiment();
    for (const Group& group : groups_) { group.widget->setVisible(experiment && uses_field(experiment->type, group.field)); }
    for (QWidget* widget : std::initializer_list<QWidget*>{type_, closure_, swelling_}) { widget->setEnabled(experiment); }
    if (!experiment) { return; }
    type_->setCurrentIndex(static_cast<int>(experiment->type));
    direction_->setCurrentIndex(experiment->along_weft ? 1 : 0);
    side_->setCurrentIndex(experiment->from_top ? 1 : 0);
    closure_->setCurrentIndex(static_cast<int>(experiment->closure));
    swelling_->setChecked(experiment->swelling);
    // A strip is measured as it is held, not by warp and weft.
    const bool strip = uses_field(experiment->type, "direction");
    form_->setLabel(size_[0], strip ? tr("Strip width") : tr("Along the weft"));
    form_->setLabel(size_[1], strip ? tr("Strip length") : tr("Along the warp"));
}

void ExperimentPanel::setType(int chosen)
{
    const auto type = static_cast<ExperimentType>(chosen);
    if (!document_.experiment() || document_.experiment()->type == type) { return; }
    document_.edit(tr("type of experiment"), {}, [&](Design& design) {
        Experiment& e = design.experiments[static_cast<std::size_t>(document_.experimentIndex())];
        const std::string old = std::exchange(e.name, {}); // which is free now
        Experiment standard = freshExperiment(type);
        standard.name = isUsualName(old, e.type) ? freeName(usualName(type), design) : old;
        standard.closure = e.closure;
        standard.swelling = e.swelling;
        e = standard;
    });
}

void ExperimentPanel::edit(const QString& undo, const std::function<void(Experiment&)>& change)
{
    if (document_.experiment()) {
        const auto index = static_cast<std::size_t>(document_.experimentIndex());
        document_.edit(undo, {}, [&](Design& design) { change(design.experiments[index]); });
    }
}

bool ExperimentPanel::showField(const Place& where)
{
    const std::string part = where.key(2);
    const std::optional<std::size_t> number = where.number(2);
    if (where.key(0) == "liquids" && where.number(0)) { liquids_->choose(static_cast<int>(*where.number(0))); }
    if (part == "droplets" && number) { droplets_->choose(static_cast<int>(*number)); }
    if (part == "climate" && number.value_or(0) > 0 && course_->showField(where.text())) {
        QMetaObject::invokeMethod(
            this, [this] { ensureWidgetVisible(course_, 0, 8); }, Qt::QueuedConnection);
        return true;
    }
    if (form_->showField(where.text())) { return true; }
    if (part == "droplets") { // there is none, or there are too many
        QWidget* list = droplets_->list();
        list->setFocus();
        QMetaObject::invokeMethod(
            this, [this, list] { ensureWidgetVisible(list, 0, 8); }, Qt::QueuedConnection);
        return true;
    }
    choice_->setFocus();
    return false;
}

void ExperimentPanel::addExperiment()
{
    document_.editState(tr("add experiment"), [this](Design& design, DesignState& state) {
        Experiment experiment = document_.experiment() ? *document_.experiment() : freshExperiment(ExperimentType::droplet);
        experiment.name = freeName(experiment.name.empty() ? usualName(experiment.type) : experiment.name, design);
        design.experiments.push_back(experiment);
        state.experiment = static_cast<int>(design.experiments.size()) - 1;
    });
}

void ExperimentPanel::renameExperiment()
{
    if (!document_.experiment()) { return; }
    const QString old = QString::fromStdString(document_.experiment()->name);
    const auto whyNot = [this, old](const QString& name) {
        const bool taken = name.trimmed() != old && find_experiment(*document_.design(), name.trimmed().toStdString());
        return taken ? tr("An experiment “%1” already exists. Choose another name.").arg(name.trimmed()) : QString();
    };
    NameDialog dialog(tr("Rename experiment"), old, whyNot, this);
    const bool accepted = dialog.exec() == QDialog::Accepted;
    const QString name = dialog.name();
    if (accepted && !name.isEmpty() && name != old) {
        edit(tr("rename experiment"), [&](Experiment& e) { e.name = name.toStdString(); });
    }
}

void ExperimentPanel::removeExperiment()
{
    document_.editState(tr("delete experiment"), [](Design& design, DesignState& state) {
        design.experiments.erase(design.experiments.begin() + state.experiment);
        state.experiment = std::max(0, state.experiment - 1);
    });
}

} // namespace hygroloom
