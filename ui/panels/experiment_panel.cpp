// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/experiment_panel.h"

#include "ui/basics/appearance.h"
#include "ui/panels/climate_course.h"
#include "ui/panels/liquid_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hygroloom {

namespace {

QToolButton* iconButton(const QString& icon, const QString& name)
{
    auto* button = new QToolButton;
    button->setIcon(themedIcon(icon));
    button->setAutoRaise(true);
    button->setToolTip(name);
    button->setAccessibleName(name);
    return button;
}

std::string freeName(const Design& design, std::string wish)
{
    std::string name = wish;
    for (int i = 2; find_experiment(design, name); ++i) { name = wish + " " + std::to_string(i); }
    return name;
}

QString nameOfType(ExperimentType type)
{
    const QString names[] = {ExperimentPanel::tr("Droplets"),
                             ExperimentPanel::tr("Moisture management (AATCC 195)"),
                             ExperimentPanel::tr("Vertical wicking (AATCC 197)"),
                             ExperimentPanel::tr("Horizontal wicking (AATCC 198)"),
                             ExperimentPanel::tr("Drying (AATCC 199, 201)"),
                             ExperimentPanel::tr("Conditioning (ISO 139)"),
                             ExperimentPanel::tr("Sweat")};
    return names[static_cast<int>(type)];
}

} // namespace

ExperimentPanel::ExperimentPanel(Document& document, QWidget* parent)
    : QScrollArea(parent), document_(document), form_(new DesignForm(document))
{
    addChoice();
    addConditions();
    addTypes();
    addDroplets();
    addModel();
    form_->fill(this);
    form_->onRefresh([this] {
        refreshChoice();
        refreshType();
        refreshDroplets();
    });
    form_->refresh();
}

DesignField ExperimentPanel::field(const QString& label, const QString& undo, std::function<std::string()> where, Read read, Write write,
                                   const QString& help)
{
    return {label,
            undo,
            std::move(where),
            [this, read = std::move(read)] { return document_.experiment() ? read(*document_.experiment()) : std::nullopt; },
            [this, write = std::move(write)](Design& design, std::optional<double> value) {
                if (value) { write(design.experiments[static_cast<std::size_t>(document_.experimentIndex())], *value); }
            },
            help};
}

DesignField ExperimentPanel::fixedField(const QString& label, const QString& undo, const char* where, Read read, Write write,
                                        const QString& help)
{
    return field(
        label, undo, [this, where] { return "experiments[" + std::to_string(document_.experimentIndex()) + "]." + where; }, std::move(read),
        std::move(write), help);
}

DesignField ExperimentPanel::climateField(const QString& label, const QString& undo, const char* where, double Climate::*member,
                                          const QString& help)
{
    return field(
        label, undo,
        [this, where] {
            const bool course = document_.experiment() && !document_.experiment()->climates.empty();
            return "experiments[" + std::to_string(document_.experimentIndex()) + (course ? "].climate[0]." : "].climate.") + where;
        },
        [member](const Experiment& e) { return std::optional(e.climate.*member); },
        [member](Experiment& e, double v) { e.climate.*member = v; }, help);
}

QuantityEdit* ExperimentPanel::addSampleSize(std::size_t axis)
{
    return form_->addQuantity(
        Quantity::length(0.1, 2000),
        field(
            axis == 0 ? tr("Along the weft") : tr("Along the warp"), axis == 0 ? tr("sample width") : tr("sample height"),
            [this, axis] {
                const bool strip = document_.experiment() && document_.experiment()->type == ExperimentType::vertical_wicking;
                return "experiments[" + std::to_string(document_.experimentIndex()) + (strip ? "].strip_mm[" : "].sample_mm[") +
                       std::to_string(axis) + "]";
            },
            [axis](const Experiment& e) { return std::optional(e.sample_mm[axis]); },
            [axis](Experiment& e, double v) { e.sample_mm[axis] = v; }));
}

DesignField ExperimentPanel::dropletField(const QString& label, const QString& undo, const char* where, double& (*member)(Droplet&),
                                          const QString& help)
{
    return field(
        label, undo,
        [this, where] {
            return "experiments[" + std::to_string(document_.experimentIndex()) + "].droplets[" + std::to_string(droplet_) + "]." + where;
        },
        [this, member](const Experiment& e) -> std::optional<double> {
            if (droplet_ >= static_cast<int>(e.droplets.size())) { return std::nullopt; }
            Droplet drop = e.droplets[static_cast<std::size_t>(droplet_)];
            return member(drop);
        },
        [this, member](Experiment& e, double value) {
            if (droplet_ < static_cast<int>(e.droplets.size())) { member(e.droplets[static_cast<std::size_t>(droplet_)]) = value; }
        },
        help);
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
    for (int type = 0; type < experiment_types; ++type) { type_->addItem(nameOfType(static_cast<ExperimentType>(type))); }
    type_->setToolTip(tr("Choosing another type takes its standard's climate, sample and duration."));
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
    form_->addQuantity(Quantity::temperature(-10, 60),
                       climateField(tr("Temperature"), tr("temperature"), "temperature_c", &Climate::temperature_c));
    form_->addQuantity(Quantity::percent(0, most_humidity),
                       climateField(tr("Humidity"), tr("relative humidity"), "relative_humidity", &Climate::relative_humidity,
                                    tr("Relative humidity of the air, and of the fabric before the first drop.")));
    form_->addQuantity(Quantity::speed(20), climateField(tr("Air speed"), tr("air speed"), "air_speed_m_s", &Climate::air_speed_m_s));
    course_ = new ClimateCourse(document_);
    form_->addWide(course_);
    form_->addSection(tr("Sample"));
    for (const std::size_t axis : {0, 1}) { size_[axis] = addSampleSize(axis); }
    form_->addQuantity(Quantity::time(0.001, 86400),
                       fixedField(
                           tr("Duration"), tr("duration"), "duration_s", [](const Experiment& e) { return std::optional(e.duration_s); },
                           [](Experiment& e, double v) { e.duration_s = v; }));
}

/// What only some types have, each in a group of its own.
void ExperimentPanel::addTypes()
{
    const auto group = [this](std::initializer_list<ExperimentType> types) { groups_.push_back({form_->addGroup(), types}); };
    using Type = ExperimentType;
    group({Type::moisture_management, Type::horizontal_wicking});
    form_->addQuantity(Quantity::volume(0.001, 100000), fixedField(
                                                            tr("Volume"), tr("volume of liquid"), "volume_ul",
                                                            [](const Experiment& e) { return std::optional(e.volume_ul); },
                                                            [](Experiment& e, double v) { e.volume_ul = v; }));
    group({Type::moisture_management});
    form_->addQuantity(Quantity::time(0.01, 86400),
                       fixedField(
                           tr("Feed"), tr("time of the feed"), "feed_s", [](const Experiment& e) { return std::optional(e.feed_s); },
                           [](Experiment& e, double v) { e.feed_s = v; }, tr("How long the pump runs.")));
    form_->addQuantity(Quantity::volume(0, 1000),
                       fixedField(
                           tr("Drops"), tr("volume of the feed's drops"), "drop_ul",
                           [](const Experiment& e) { return std::optional(e.drop_ul); }, [](Experiment& e, double v) { e.drop_ul = v; },
                           tr("The feed falls on the cloth in drops of this volume, at most 64 of them, evenly in time. 0: one pool that "
                              "the yarns drink from.")));
    group({Type::vertical_wicking});
    direction_ = new QComboBox;
    direction_->addItems({tr("Along the warp"), tr("Along the weft")});
    form_->addRow(tr("Strip"), direction_);
    connect(direction_, &QComboBox::activated, this,
            [this](int chosen) { edit(tr("direction of the strip"), [&](Experiment& e) { e.along_weft = chosen == 1; }); });
    form_->addQuantity(Quantity::length(0.01, 2000),
                       fixedField(
                           tr("Immersion"), tr("immersion"), "immersion_mm",
                           [](const Experiment& e) { return std::optional(e.immersion_mm); },
                           [](Experiment& e, double v) { e.immersion_mm = v; }, tr("How deep the strip's end hangs in the liquid.")));
    group({Type::drying});
    form_->addQuantity(Quantity::arealDensity(100000), fixedField(
                                                           tr("Water"), tr("water at the start"), "initial_water_g_m2",
                                                           [](const Experiment& e) { return std::optional(e.initial_water_g_m2); },
                                                           [](Experiment& e, double v) { e.initial_water_g_m2 = v; },
                                                           tr("In the cloth at the start, over what it holds in this climate.")));
    group({Type::conditioning});
    form_->addQuantity(Quantity::temperature(-10, 60), fixedField(
                                                           tr("From"), tr("temperature at the start"), "initial.temperature_c",
                                                           [](const Experiment& e) { return std::optional(e.initial.temperature_c); },
                                                           [](Experiment& e, double v) { e.initial.temperature_c = v; },
                                                           tr("The sample comes from air of this temperature.")));
    form_->addQuantity(Quantity::percent(0, most_humidity),
                       fixedField(
                           tr("From humidity"), tr("humidity at the start"), "initial.relative_humidity",
                           [](const Experiment& e) { return std::optional(e.initial.relative_humidity); },
                           [](Experiment& e, double v) { e.initial.relative_humidity = v; },
                           tr("The sample comes from air of this humidity.")));
    group({Type::sweat});
    form_->addQuantity(Quantity::arealRate(100000),
                       fixedField(
                           tr("Rate"), tr("rate of sweat"), "rate_g_m2_h", [](const Experiment& e) { return std::optional(e.rate_g_m2_h); },
                           [](Experiment& e, double v) { e.rate_g_m2_h = v; }));
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
    closure_->addItems({tr("As Kissa measured"), tr("Li and Zhu"), tr("As the paper prints")});
    closure_->setToolTip(tr("How liquid moves in the pores of the yarns. As the paper prints: pores of 0.2 mm, one contact angle "
                            "for all fibres, uptake in proportion to their regain."));
    form_->addRow(tr("Flow in yarns"), closure_);
    connect(closure_, &QComboBox::activated, this,
            [this](int chosen) { edit(tr("flow in yarns"), [&](Experiment& e) { e.closure = static_cast<Closure>(chosen); }); });
    swelling_ = new QCheckBox(tr("Wet fibres narrow the pores"));
    form_->addWide(swelling_);
    connect(swelling_, &QCheckBox::clicked, this, [this](bool on) { edit(tr("swelling"), [&](Experiment& e) { e.swelling = on; }); });
    liquids_->addOwnLiquids();
}

void ExperimentPanel::addDroplets()
{
    groups_.push_back({form_->addGroup(), {ExperimentType::droplet}});
    droplets_ = new QListWidget;
    droplets_->setAccessibleName(tr("Droplets"));
    droplets_->setFixedHeight(90); // as three buttons
    auto* buttons = new QVBoxLayout;
    QToolButton* add = iconButton("add", tr("Add a droplet"));
    remove_droplet_ = iconButton("remove", tr("Remove the droplet"));
    place_ = iconButton("drop", tr("Place the droplet: click on the fabric"));
    place_->setCheckable(true);
    connect(place_, &QToolButton::toggled, this, &ExperimentPanel::placingChanged);
    buttons->setSpacing(4);
    buttons->addWidget(add);
    buttons->addWidget(remove_droplet_);
    buttons->addWidget(place_);
    buttons->addStretch();
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(droplets_, 1);
    layout->addLayout(buttons);
    form_->addWide(line);
    no_droplet_ = new QLabel(tr("No droplet yet. Add one to wet the fabric."));
    no_droplet_->setWordWrap(true);
    form_->addWide(no_droplet_);
    connect(add, &QToolButton::clicked, this, &ExperimentPanel::addDroplet);
    connect(remove_droplet_, &QToolButton::clicked, this, &ExperimentPanel::removeDroplet);
    connect(droplets_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0 && row != droplet_) {
            droplet_ = row;
            form_->refresh();
            Q_EMIT dropletChosen();
        }
    });
    using D = Droplet&;
    droplet_fields_ = {
        form_->addQuantity(Quantity::volume(0.001, 5000),
                           dropletField(tr("Volume"), tr("droplet volume"), "volume_ul", [](D d) -> double& { return d.volume_ul; })),
        form_->addQuantity(Quantity::time(0, 86400),
                           dropletField(
                               tr("Time"), tr("droplet time"), "time_s", [](D d) -> double& { return d.time_s; }, tr("When it appears."))),
        form_->addQuantity(Quantity::length(-1000, 1000), dropletField(
                                                              tr("Place along weft"), tr("droplet place"), "at_mm[0]",
                                                              [](D d) -> double& { return d.at_mm[0]; }, tr("From the sample's centre."))),
        form_->addQuantity(Quantity::length(-1000, 1000), dropletField(
                                                              tr("Place along warp"), tr("droplet place"), "at_mm[1]",
                                                              [](D d) -> double& { return d.at_mm[1]; }, tr("From the sample's centre."))),
        form_->addQuantity(Quantity::length(0, 100),
                           dropletField(
                               tr("Height"), tr("droplet height"), "height_mm", [](D d) -> double& { return d.height_mm; },
                               tr("Of its lowest point over the fabric."))),
        form_->addQuantity(Quantity::speed(fastest_droplet_m_s),
                           dropletField(
                               tr("Speed"), tr("droplet speed"), "speed_m_s", [](D d) -> double& { return d.speed_m_s; },
                               tr("Downwards, when it appears.")))};
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
    for (const Group& group : groups_) {
        group.widget->setVisible(experiment && std::find(group.types.begin(), group.types.end(), experiment->type) != group.types.end());
    }
    for (QWidget* widget : std::initializer_list<QWidget*>{type_, closure_, swelling_}) { widget->setEnabled(experiment); }
    if (!experiment) { return; }
    type_->setCurrentIndex(static_cast<int>(experiment->type));
    direction_->setCurrentIndex(experiment->along_weft ? 1 : 0);
    side_->setCurrentIndex(experiment->from_top ? 1 : 0);
    closure_->setCurrentIndex(static_cast<int>(experiment->closure));
    swelling_->setChecked(experiment->swelling);
    // Of a strip it is the way it hangs that counts.
    const bool strip = experiment->type == ExperimentType::vertical_wicking;
    form_->setLabel(size_[0], strip ? tr("Strip's width") : tr("Along the weft"));
    form_->setLabel(size_[1], strip ? tr("Strip's length") : tr("Along the warp"));
}

void ExperimentPanel::setType(int chosen)
{
    const auto type = static_cast<ExperimentType>(chosen);
    if (!document_.experiment() || document_.experiment()->type == type) { return; }
    edit(tr("type of experiment"), [&](Experiment& e) {
        Experiment standard = standard_experiment(type);
        standard.name = e.name;
        standard.closure = e.closure;
        standard.swelling = e.swelling;
        e = standard;
    });
}

void ExperimentPanel::refreshDroplets()
{
    const QSignalBlocker quiet(droplets_);
    const Experiment* experiment = document_.experiment();
    const int count = experiment ? static_cast<int>(experiment->droplets.size()) : 0;
    const int chosen = std::clamp(droplet_, 0, std::max(0, count - 1));
    if (chosen != droplet_) {
        droplet_ = chosen;
        form_->refresh();
        return;
    }
    droplets_->clear();
    for (int i = 0; i < count; ++i) {
        const Droplet& drop = experiment->droplets[static_cast<std::size_t>(i)];
        droplets_->addItem(tr("%1: %2 µl at %3 s, place %4, %5 mm")
                               .arg(i + 1)
                               .arg(shownNumber(drop.volume_ul, 2), shownNumber(drop.time_s, 2), shownNumber(drop.at_mm[0], 1),
                                    shownNumber(drop.at_mm[1], 1)));
    }
    droplets_->setCurrentRow(count > 0 ? droplet_ : -1);
    remove_droplet_->setEnabled(count > 0);
    place_->setEnabled(count > 0);
    if (count == 0 || experiment->type != ExperimentType::droplet) { place_->setChecked(false); }
    no_droplet_->setVisible(count == 0);
    for (QWidget* widget : droplet_fields_) { widget->setEnabled(count > 0); }
}

void ExperimentPanel::edit(const QString& undo, const std::function<void(Experiment&)>& change)
{
    if (document_.experiment()) {
        const auto index = static_cast<std::size_t>(document_.experimentIndex());
        document_.edit(undo, {}, [&](Design& design) { change(design.experiments[index]); });
    }
}

void ExperimentPanel::addDroplet()
{
    const Experiment* experiment = document_.experiment();
    if (!experiment) { return; }
    // After the last one by default: two drops in one place at one time would overlap.
    Droplet drop = experiment->droplets.empty() ? Droplet{} : experiment->droplets.back();
    if (!experiment->droplets.empty()) { drop.time_s += std::min(1.0, std::max(0.0, experiment->duration_s - drop.time_s) / 2); }
    droplet_ = static_cast<int>(experiment->droplets.size());
    edit(tr("add droplet"), [&](Experiment& e) { e.droplets.push_back(drop); });
}

void ExperimentPanel::placeDroplet(const QPointF& at)
{
    const auto rounded = [](double mm) { return std::round(10 * mm) / 10; };
    const Experiment* experiment = document_.experiment();
    if (experiment && droplet_ < static_cast<int>(experiment->droplets.size())) {
        edit(tr("droplet place"), [&](Experiment& e) {
            e.droplets[static_cast<std::size_t>(droplet_)].at_mm = {rounded(at.x()), rounded(at.y())};
        });
        document_.endStroke();
    }
}

bool ExperimentPanel::placing() const { return place_->isChecked(); }

void ExperimentPanel::endPlacing() { place_->setChecked(false); }

void ExperimentPanel::removeDroplet()
{
    const Experiment* experiment = document_.experiment();
    if (experiment && droplet_ < static_cast<int>(experiment->droplets.size())) {
        edit(tr("remove droplet"), [&](Experiment& e) { e.droplets.erase(e.droplets.begin() + droplet_); });
    }
}

bool ExperimentPanel::showField(const std::string& where)
{
    const auto numberAfter = [&where](const char* key) {
        const std::size_t at = where.find(key);
        return at == std::string::npos ? -1 : std::atoi(where.c_str() + at + std::char_traits<char>::length(key));
    };
    if (where.starts_with("liquids[")) { liquids_->choose(numberAfter("liquids[")); }
    if (const int droplet = numberAfter("].droplets["); droplet >= 0 && droplet != droplet_) {
        droplet_ = droplet;
        form_->refresh();
    }
    if (numberAfter("].climate[") > 0 && course_->showField(where)) {
        QMetaObject::invokeMethod(
            this, [this] { ensureWidgetVisible(course_, 0, 8); }, Qt::QueuedConnection);
        return true;
    }
    if (form_->showField(where)) { return true; }
    if (where.find("].droplets") != std::string::npos) { // there is none, or there are too many
        droplets_->setFocus();
        QMetaObject::invokeMethod(
            this, [this] { ensureWidgetVisible(droplets_, 0, 8); }, Qt::QueuedConnection);
        return true;
    }
    choice_->setFocus();
    return false;
}

void ExperimentPanel::addExperiment()
{
    document_.editState(tr("add experiment"), [this](Design& design, DesignState& state) {
        Experiment experiment = document_.experiment() ? *document_.experiment() : Experiment{};
        experiment.name = freeName(design, experiment.name.empty() ? tr("one drop").toStdString() : experiment.name);
        design.experiments.push_back(experiment);
        state.experiment = static_cast<int>(design.experiments.size()) - 1;
    });
}

void ExperimentPanel::renameExperiment()
{
    if (!document_.experiment()) { return; }
    bool accepted = false;
    const QString old = QString::fromStdString(document_.experiment()->name);
    const QString name = QInputDialog::getText(this, tr("Rename experiment"), tr("Name:"), QLineEdit::Normal, old, &accepted).trimmed();
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
