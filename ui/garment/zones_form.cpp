// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/zones_form.h"

#include "ui/basics/icon_button.h"
#include "ui/basics/name_dialog.h"
#include "ui/basics/typed_value.h"
#include "ui/garment/fields.h"
#include "ui/garment/garment_edits.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace hygroloom {

namespace {

} // namespace

ZonesForm::ZonesForm(GarmentChoice& choice, QWidget* parent)
    : QWidget(parent), choice_(choice), table_(new QTableWidget(0, 2)),
      draw_(iconButton("add", tr("Draw a zone on a flat panel: click its corners, and the first one again"))),
      rename_(iconButton("rename", tr("Rename the selected zone"))), remove_(iconButton("delete", tr("Delete the selected zone")))
{
    table_->setAccessibleName(tr("Own zones"));
    table_->setHorizontalHeaderLabels({tr("Zone"), tr("Sweats")});
    table_->horizontalHeaderItem(1)->setToolTip(tr("In place of the body's zone; times the factor of the activity."));
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Fixed);
    table_->horizontalHeader()->resizeSection(1, table_->fontMetrics().horizontalAdvance("100000 g/m²h") + 24);
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->setFrameShape(QFrame::NoFrame);
    draw_->setCheckable(true);
    connect(draw_, &QToolButton::toggled, this, &ZonesForm::drawingWanted);
    connect(rename_, &QToolButton::clicked, this, &ZonesForm::rename);
    connect(remove_, &QToolButton::clicked, this, &ZonesForm::removeSelected);
    connect(table_, &QTableWidget::cellDoubleClicked, this, &ZonesForm::rename);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &ZonesForm::refresh);
    auto* head = new QHBoxLayout;
    head->addWidget(heading(tr("Own zones")), 1);
    for (QToolButton* button : {draw_, rename_, remove_}) { head->addWidget(button); }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(head);
    layout->addWidget(table_, 1);
    table_->setMinimumHeight(90);
    connect(&choice_, &GarmentChoice::changed, this, &ZonesForm::refresh);
    connect(&choice_, &GarmentChoice::drawingChanged, this, &ZonesForm::refresh);
    refresh();
}

void ZonesForm::setDrawing(bool drawing)
{
    const QSignalBlocker quiet(draw_);
    draw_->setChecked(drawing);
}

void ZonesForm::rename()
{
    const int row = table_->currentRow();
    if (!choice_.garment() || row < 0 || row >= static_cast<int>(choice_.garment()->wearer.own_zones.size())) { return; }
    const int garment = choice_.garmentIndex();
    NameDialog dialog(
        tr("Rename the Zone"), QString::fromStdString(choice_.garment()->wearer.own_zones[static_cast<std::size_t>(row)].name),
        [this, garment, row](const QString& name) {
            return whyNotZoneName(choice_.document().design()->garments[static_cast<std::size_t>(garment)], row, name);
        },
        this);
    if (dialog.exec() == QDialog::Accepted) {
        editOwnZone(choice_.document(), tr("rename zone"), garment, row, {},
                    [&](OwnZone& zone) { zone.name = dialog.name().toStdString(); });
    }
}

void ZonesForm::removeSelected()
{
    commitTypedValue(*window());
    removeOwnZone(choice_.document(), choice_.garmentIndex(), table_->currentRow());
}

void ZonesForm::addRow()
{
    const int row = table_->rowCount();
    table_->insertRow(row);
    table_->setItem(row, 0, new QTableWidgetItem);
    auto* rate = rowField<OwnZone>(
        choice_.document(), "sweat_g_m2_h",
        [this, row](double typed) {
            editOwnZone(choice_.document(), tr("change sweat of a zone"), choice_.garmentIndex(), row, "sweat_g_m2_h",
                        [&](OwnZone& zone) { zone.sweat_g_m2_h = typed; });
        },
        tr("Sweat of own zone %1").arg(row + 1));
    table_->setCellWidget(row, 1, rate);
    rates_.push_back(rate);
}

void ZonesForm::refresh()
{
    const QSignalBlocker quiet(table_);
    const Garment* garment = choice_.garment();
    const std::vector<OwnZone> zones = garment ? garment->wearer.own_zones : std::vector<OwnZone>{};
    while (table_->rowCount() > static_cast<int>(zones.size())) {
        rates_.pop_back();
        table_->removeRow(table_->rowCount() - 1);
    }
    while (table_->rowCount() < static_cast<int>(zones.size())) { addRow(); }
    const std::string where = "garments[" + std::to_string(choice_.garmentIndex()) + "].wearer.own_zones[";
    for (std::size_t k = 0; k < zones.size(); ++k) {
        const QString name = QString::fromStdString(zones[k].name), panel = QString::fromStdString(zones[k].panel);
        QTableWidgetItem* item = table_->item(static_cast<int>(k), 0);
        item->setText(tr("%1, on %2").arg(name, panel));
        item->setToolTip(item->text());
        rates_[k]->setValue(zones[k].sweat_g_m2_h);
        rates_[k]->setIssues(choice_.document().issuesAt(where + std::to_string(k) + "].sweat_g_m2_h"));
    }
    const int row = table_->currentRow();
    const bool any = row >= 0 && row < table_->rowCount() && !table_->selectedItems().isEmpty();
    draw_->setEnabled(garment != nullptr && choice_.drawing() && zones.size() < most_own_zones);
    rename_->setEnabled(any);
    remove_->setEnabled(any);
}

} // namespace hygroloom
