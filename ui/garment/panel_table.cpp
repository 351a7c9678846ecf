// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/panel_table.h"

#include "ui/basics/elided_combo.h"
#include "ui/garment/fields.h"
#include "ui/garment/garment_edits.h"

#include <QHeaderView>

#include <algorithm>

namespace hygroloom {

PanelTable::PanelTable(GarmentChoice& choice, QWidget* parent) : QTableWidget(0, 4, parent), choice_(choice)
{
    setHorizontalHeaderLabels({tr("Panel"), tr("Fabric"), tr("Grain"), tr("Top face")});
    horizontalHeaderItem(2)->setToolTip(tr("Angle of the warp from the pattern's upward direction, counter-clockwise seen from outside."));
    horizontalHeaderItem(3)->setToolTip(tr("Where the fabric's top face lies."));
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Fixed);
    setWordWrap(true);
    horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    horizontalHeader()->setSectionResizeMode(2, QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(3, QHeaderView::Fixed);
    horizontalHeader()->setMinimumSectionSize(40);
    horizontalHeader()->resizeSection(2, fontMetrics().horizontalAdvance("−360°") + 8);
    horizontalHeader()->resizeSection(3, fontMetrics().horizontalAdvance(tr("outside")) + 27);
    verticalHeader()->hide();
    setEditTriggers(NoEditTriggers);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Panels of the garment"));
    connect(&choice_, &GarmentChoice::drawingChanged, this, &PanelTable::rebuild);
    connect(&choice_, &GarmentChoice::changed, this, &PanelTable::refresh);
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0) { Q_EMIT panelChosen(row); }
    });
    rebuild();
}

void PanelTable::choosePanel(int panel)
{
    const QSignalBlocker quiet(this);
    if (panel >= 0 && panel < rowCount()) { selectRow(panel); }
}

void PanelTable::rebuild()
{
    std::vector<std::string> names, shown;
    if (choice_.drawing()) {
        for (const DrawnPanel& panel : choice_.drawing()->panels) { names.push_back(panel.name); }
    }
    for (const Row& row : rows_) { shown.push_back(row.panel); }
    if (names != shown) {
        setRowCount(0);
        rows_.clear();
        for (const std::string& name : names) { addRow(name); }
        shareWidth();
    }
    refresh();
}

/// As wide as the longest word of a name, which goes on in a second line, so that fabrics have the room that is left.
void PanelTable::shareWidth()
{
    int longest = horizontalHeader()->sectionSizeHint(0);
    for (const Row& row : rows_) {
        for (const QString& word : QString::fromStdString(row.panel).split(' ')) {
            longest = std::max(longest, fontMetrics().horizontalAdvance(word) + 10);
        }
    }
    const int room = horizontalHeader()->sectionSize(0) + horizontalHeader()->sectionSize(1);
    horizontalHeader()->resizeSection(0, std::min(longest, room / 2));
    resizeRowsToContents();
}

void PanelTable::resizeEvent(QResizeEvent* event)
{
    QTableWidget::resizeEvent(event);
    shareWidth();
}

void PanelTable::addRow(const std::string& panel)
{
    const int row = rowCount();
    const QString name = QString::fromStdString(panel);
    insertRow(row);
    auto* item = new QTableWidgetItem(name);
    item->setToolTip(name);
    setItem(row, 0, item);
    Row made{panel, new ElidedCombo, nullptr, new QComboBox};
    made.fabric->setAccessibleName(tr("Fabric of %1").arg(name));
    made.fabric->setMinimumContentsLength(4);
    made.fabric->setIconSize({12, 12});
    made.fabric->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(made.fabric, &QComboBox::activated, this, [this, panel, name](int index) {
        const std::string fabric = choice_.document().design()->fabrics[static_cast<std::size_t>(index)].name;
        editCut(choice_.document(), tr("cut %1 from %2").arg(name, QString::fromStdString(fabric)), choice_.garmentIndex(), panel, {},
                [&](PanelCut& cut) { cut.fabric = fabric; });
    });
    made.grain = rowField<PanelCut>(
        choice_.document(), "grain_deg",
        [this, panel, name](double value) {
            editCut(choice_.document(), tr("turn the grain of %1").arg(name), choice_.garmentIndex(), panel, "grain_deg",
                    [&](PanelCut& cut) { cut.grain_deg = value; });
        },
        tr("Grain of %1").arg(name));
    made.face->addItems({tr("outside"), tr("inside")});
    made.face->setAccessibleName(tr("Top face of %1").arg(name));
    connect(made.face, &QComboBox::activated, this, [this, panel, name](int index) {
        editCut(choice_.document(), tr("turn %1").arg(name), choice_.garmentIndex(), panel, {},
                [&](PanelCut& cut) { cut.top_inside = index == 1; });
    });
    setCellWidget(row, 1, made.fabric);
    setCellWidget(row, 2, made.grain);
    setCellWidget(row, 3, made.face);
    rows_.push_back(made);
}

void PanelTable::refresh()
{
    const Garment* garment = choice_.garment();
    if (!garment) { return; }
    const auto& fabrics = choice_.document().design()->fabrics;
    const QStringList names = namesOf(fabrics);
    const std::string where = "garments[" + std::to_string(choice_.garmentIndex()) + "].panels.";
    for (const Row& row : rows_) {
        const PanelCut* cut = garment->cut_of(row.panel);
        setChoices(row.fabric, names, cut ? static_cast<int>(names.indexOf(QString::fromStdString(cut->fabric))) : -1,
                   [](int i) { return colorIcon(fabricColor(i)); });
        row.fabric->setToolTip(cut ? QString::fromStdString(cut->fabric) : tr("This panel has no fabric."));
        row.grain->setValue(cut ? cut->grain_deg : 0.0);
        row.grain->setIssues(choice_.document().issuesAt(where + row.panel + ".grain_deg"));
        const QSignalBlocker quiet(row.face);
        row.face->setCurrentIndex(cut && cut->top_inside ? 1 : 0);
    }
}

} // namespace hygroloom
