// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/wear_form.h"

#include "ui/basics/elided_combo.h"
#include "ui/basics/icon_button.h"
#include "ui/basics/language.h"
#include "ui/basics/name_dialog.h"
#include "ui/basics/typed_value.h"
#include "ui/garment/fields.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/rates_file.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

Quantity factorQuantity()
{
    Quantity quantity = Quantity::fraction(0, largest_activity);
    quantity.step = 0.1;
    return quantity;
}

QString aboutFactor()
{
    return WearForm::tr(
        "From this time on, sweat rates are those of the table of zones times this number: 1 gives the table's rates, 0 none. "
        "The table is chosen in Garment, under Sweat.");
}

} // namespace

WearForm::WearForm(GarmentChoice& choice, QWidget* parent)
    : QScrollArea(parent), choice_(choice), activity_title_(heading(tr("Activity"))), activity_(new QTableWidget(0, 2)),
      rates_(new RatesFile(choice))
{
    setWidgetResizable(true);
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* all = new QWidget;
    auto* layout = new QVBoxLayout(all);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(makeHead());
    auto* form = new QFormLayout;
    form->setVerticalSpacing(4);
    const auto whole = [](auto& wear) { return &wear; };
    addField<WearExperiment>(form, "duration_s", "", whole);
    for (const Field<Climate>& row : fields_of<Climate>()) {
        addField<Climate>(form, row.key, "climate.", [](auto& wear) { return &wear.climate; });
    }
    addField<WearExperiment>(form, "initial_water_g_m2", "", whole);
    layout->addLayout(form);
    layout->addWidget(makeActivity(), 1);
    setWidget(all);
    setMinimumWidth(all->minimumSizeHint().width() + 16);
    connect(&choice_, &GarmentChoice::changed, this, &WearForm::refresh);
    refresh();
}

QWidget* WearForm::makeHead()
{
    wears_ = new ElidedCombo;
    wears_->setAccessibleName(tr("Wear experiment"));
    wears_->setMinimumContentsLength(8);
    wears_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(wears_, &QComboBox::activated, this, [this](int row) {
        const std::vector<int> places = choice_.wearsOfGarment();
        if (row >= 0 && row < static_cast<int>(places.size())) { choice_.setWearIndex(places[static_cast<std::size_t>(row)]); }
    });
    add_ = iconButton("add", tr("Add an experiment on this garment"));
    connect(add_, &QToolButton::clicked, this, [this] {
        if (choice_.garment()) { choice_.setWearIndex(addWear(choice_.document(), choice_.garment()->name)); }
    });
    rename_ = iconButton("rename", tr("Rename the experiment"));
    connect(rename_, &QToolButton::clicked, this, [this] {
        if (!choice_.wear()) { return; }
        const int wear = choice_.wearIndex();
        NameDialog dialog(
            tr("Rename the Experiment"), QString::fromStdString(choice_.wear()->name),
            [this, wear](const QString& name) { return whyNotWearName(*choice_.document().design(), wear, name); }, this);
        if (dialog.exec() == QDialog::Accepted) { renameWear(choice_.document(), wear, dialog.name()); }
    });
    remove_ = iconButton("delete", tr("Remove the experiment"));
    connect(remove_, &QToolButton::clicked, this, [this] {
        commitTypedValue(*window());
        if (choice_.wear()) { removeWear(choice_.document(), choice_.wearIndex()); }
    });
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(wears_, 1);
    layout->addWidget(add_);
    layout->addWidget(rename_);
    layout->addWidget(remove_);
    return row;
}

template <typename Part, typename Of> void WearForm::addField(QFormLayout* form, const char* key, const char* before, Of of)
{
    const Field<Part>& row = field_named<Part>(key);
    const QString name = coreWord(row.label);
    const std::string path = std::string(before) + key;
    auto* edit = rowField<Part>(choice_.document(), key, [this, name, path, &row, of](double typed) {
        editWear(choice_.document(), tr("change %1").arg(withinSentence(name)), choice_.wearIndex(), path.c_str(),
                 [&](WearExperiment& wear) { set_field(row, *of(wear), typed); });
    });
    form->addRow(name, edit);
    fields_.push_back({edit, path, [&row, of](const WearExperiment& wear) { return field_value(row, *of(wear)); }});
}

QWidget* WearForm::makeActivity()
{
    activity_->setHorizontalHeaderLabels({tr("From"), tr("Sweat factor")});
    activity_->horizontalHeaderItem(1)->setToolTip("<p>" + aboutFactor() + "</p>");
    activity_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    activity_->verticalHeader()->hide();
    activity_->setSelectionMode(QAbstractItemView::SingleSelection);
    activity_->setSelectionBehavior(QAbstractItemView::SelectRows);
    activity_->setTabKeyNavigation(false);
    activity_->setFrameShape(NoFrame);
    activity_->setMinimumHeight(90);
    activity_->setAccessibleName(tr("Activity over time"));
    add_activity_ = iconButton("add", tr("Add a change of activity"));
    remove_activity_ = iconButton("remove", tr("Remove the selected change of activity"));
    connect(add_activity_, &QToolButton::clicked, this, &WearForm::addActivity);
    connect(remove_activity_, &QToolButton::clicked, this, &WearForm::removeActivity);
    connect(activity_, &QTableWidget::currentCellChanged, this,
            [this](int row) { remove_activity_->setEnabled(choice_.wear() && row > 0 && row < activity_->rowCount()); });
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* head = new QHBoxLayout;
    activity_title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // names of files may be long
    head->addWidget(activity_title_, 1);
    head->addWidget(add_activity_);
    head->addWidget(remove_activity_);
    layout->addLayout(head);
    layout->addWidget(rates_);
    layout->addWidget(activity_, 1);
    layout->addStretch(); // where the table is not there
    return box;
}

void WearForm::addActivity()
{
    commitTypedValue(*window());
    const WearExperiment* wear = choice_.wear();
    if (!wear || wear->activity.empty()) { return; }
    const int last = static_cast<int>(wear->activity.size()) - 1;
    const int row = std::clamp(activity_->currentRow() < 0 ? last : activity_->currentRow(), 0, last);
    const Activity& from = wear->activity[static_cast<std::size_t>(row)];
    const double next = row < last ? wear->activity[static_cast<std::size_t>(row) + 1].time_s : wear->duration_s;
    const Activity added{0.5 * (from.time_s + next), from.factor};
    editWear(choice_.document(), tr("add activity"), choice_.wearIndex(), {},
             [&](WearExperiment& edited) { edited.activity.insert(edited.activity.begin() + row + 1, added); });
    activity_->selectRow(row + 1);
}

void WearForm::removeActivity()
{
    commitTypedValue(*window());
    const int row = activity_->currentRow();
    const WearExperiment* wear = choice_.wear();
    if (!wear || row <= 0 || row >= static_cast<int>(wear->activity.size())) { return; }
    editWear(choice_.document(), tr("remove activity"), choice_.wearIndex(), {},
             [row](WearExperiment& edited) { edited.activity.erase(edited.activity.begin() + row); });
}

void WearForm::refresh()
{
    const Design& design = *choice_.document().design();
    QStringList names;
    int current = -1;
    for (const int place : choice_.wearsOfGarment()) {
        if (place == choice_.wearIndex()) { current = static_cast<int>(names.size()); }
        names << QString::fromStdString(design.wears[static_cast<std::size_t>(place)].name);
    }
    setChoices(wears_, names, current);
    const WearExperiment* wear = choice_.wear();
    wears_->setEnabled(!names.isEmpty());
    add_->setEnabled(choice_.garment() != nullptr);
    for (QWidget* part : {static_cast<QWidget*>(rename_), static_cast<QWidget*>(remove_)}) { part->setEnabled(wear != nullptr); }
    const bool from_file = wear && !wear->activity_file.empty();
    activity_title_->setText(from_file ? tr("Activity: %1").arg(QFileInfo(QString::fromStdString(wear->activity_file)).fileName())
                                       : tr("Activity"));
    activity_title_->setToolTip(from_file ? tr("%1 says how the zones sweat over time.").arg(QString::fromStdString(wear->activity_file))
                                          : QString());
    for (QWidget* part : {static_cast<QWidget*>(activity_), static_cast<QWidget*>(add_activity_)}) {
        part->setEnabled(wear != nullptr && !from_file);
    }
    for (QWidget* part :
         {static_cast<QWidget*>(activity_), static_cast<QWidget*>(add_activity_), static_cast<QWidget*>(remove_activity_)}) {
        part->setVisible(!from_file); // the file holds in its place
    }
    const std::string where =
        "experiments[" + std::to_string(design.experiments.size() + static_cast<std::size_t>(std::max(0, choice_.wearIndex()))) + "].";
    for (const Shown& field : fields_) {
        field.edit->setEnabled(wear != nullptr);
        if (!wear) { continue; }
        field.edit->setValue(field.value(*wear));
        field.edit->setIssues(choice_.document().issuesAt(where + field.key));
    }
    refreshActivity();
}

void WearForm::refreshActivity()
{
    const WearExperiment* wear = choice_.wear();
    const int rows = wear ? static_cast<int>(wear->activity.size()) : 0;
    while (activity_->rowCount() > rows) { activity_->removeRow(activity_->rowCount() - 1); }
    while (activity_->rowCount() < rows) {
        const int row = activity_->rowCount();
        activity_->insertRow(row);
        const auto at = static_cast<std::size_t>(row);
        activity_->setCellWidget(
            row, 0, quantityField(choice_.document(), Quantity::time(0, 1e6), tr("Time %1").arg(row + 1), [this, at](double time) {
                editWear(choice_.document(), tr("change time of activity"), choice_.wearIndex(),
                         "activity[" + std::to_string(at) + "].time_s", [&](WearExperiment& edited) {
                             if (at < edited.activity.size()) { edited.activity[at].time_s = time; }
                         });
            }));
        auto* edit = quantityField(choice_.document(), factorQuantity(), tr("Factor %1").arg(row + 1), [this, at](double factor) {
            editWear(choice_.document(), tr("change activity"), choice_.wearIndex(), "activity[" + std::to_string(at) + "].factor",
                     [&](WearExperiment& edited) {
                         if (at < edited.activity.size()) { edited.activity[at].factor = factor; }
                     });
        });
        edit->setHelp(aboutFactor());
        activity_->setCellWidget(row, 1, edit);
    }
    const std::string where =
        "experiments[" +
        std::to_string(choice_.document().design()->experiments.size() + static_cast<std::size_t>(std::max(0, choice_.wearIndex()))) +
        "].activity[";
    for (int row = 0; row < rows; ++row) {
        const Activity& moment = wear->activity[static_cast<std::size_t>(row)];
        auto* time = static_cast<QuantityEdit*>(activity_->cellWidget(row, 0));
        auto* factor = static_cast<QuantityEdit*>(activity_->cellWidget(row, 1));
        time->setEnabled(row > 0); // the first begins with the experiment
        time->setValue(moment.time_s);
        factor->setValue(moment.factor);
        time->setIssues(choice_.document().issuesAt(where + std::to_string(row) + "].time_s"));
        factor->setIssues(choice_.document().issuesAt(where + std::to_string(row) + "].factor"));
    }
    remove_activity_->setEnabled(wear && activity_->currentRow() > 0 && activity_->currentRow() < rows);
}

} // namespace hygroloom
