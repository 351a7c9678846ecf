// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/fit_form.h"

#include "ui/basics/core_words.h"
#include "ui/garment/fields.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/zones_form.h"

#include <QApplication>
#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr double most_gap = 100; // mm, as the project allows

QTableWidget* table(const QString& name, const QStringList& columns)
{
    auto* made = new QTableWidget(0, 2);
    made->setAccessibleName(name);
    made->setHorizontalHeaderLabels(columns);
    made->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    made->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Fixed);
    made->horizontalHeader()->resizeSection(1, made->fontMetrics().horizontalAdvance("auto 100.5 mm") + 16);
    made->verticalHeader()->hide();
    made->setEditTriggers(QAbstractItemView::NoEditTriggers);
    made->setSelectionMode(QAbstractItemView::NoSelection);
    made->setFocusPolicy(Qt::NoFocus); // its fields have it
    made->setTabKeyNavigation(false);
    made->setFrameShape(QFrame::NoFrame);
    QObject::connect(qApp, &QApplication::focusChanged, made, [made](QWidget*, const QWidget* now) {
        for (int row = 0; row < made->rowCount(); ++row) {
            if (now && made->cellWidget(row, 1) == now) { made->scrollToItem(made->item(row, 0)); } // Tab leads to all of them
        }
    });
    return made;
}

void addRow(QTableWidget* to, const QString& name, QuantityEdit* edit)
{
    const int row = to->rowCount();
    to->insertRow(row);
    auto* item = new QTableWidgetItem(name);
    item->setToolTip(name);
    to->setItem(row, 0, item);
    to->setCellWidget(row, 1, edit);
}

/// A field that may be empty, whose edits are steps of the history.
template <typename Change>
QuantityEdit* optionalField(Document& document, const Quantity& quantity, const QString& name, const Change& change)
{
    auto* edit = new QuantityEdit(quantity);
    edit->setOptional(true);
    edit->setAccessibleName(name);
    QObject::connect(edit, &QuantityEdit::edited, edit, [&document, change](std::optional<double> value, bool stepping) {
        change(value);
        if (!stepping) { document.endStroke(); }
    });
    QObject::connect(edit, &QuantityEdit::strokeEnded, edit, [&document] { document.endStroke(); });
    return edit;
}

} // namespace

FitForm::FitForm(GarmentChoice& choice, QWidget* parent)
    : QScrollArea(parent), choice_(choice), zones_(table(tr("Gaps between skin and cloth"), {tr("Zone"), tr("Gap")})),
      seam_rows_(table(tr("Seams"), {tr("Seam"), tr("Passes")})), own_zones_(new ZonesForm(choice))
{
    setWidgetResizable(true);
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* all = new QWidget;
    auto* layout = new QVBoxLayout(all);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(heading(tr("Gap between skin and cloth")));
    zones_->setMinimumHeight(150);
    layout->addWidget(zones_, 3);
    layout->addWidget(heading(tr("Share of the water that seams pass")));
    seam_rows_->setMinimumHeight(110);
    layout->addWidget(seam_rows_, 2);
    layout->addWidget(own_zones_, 1);
    setWidget(all);
    addGap("default", tr("all others"));
    for (const std::string& zone : gap_zones()) { addGap(zone, coreWord(zone)); }
    connect(&choice_, &GarmentChoice::changed, this, &FitForm::refresh);
    connect(&choice_, &GarmentChoice::drawingChanged, this, &FitForm::rebuildSeams);
    rebuildSeams();
}

QuantityEdit* FitForm::gapOf(const std::string& zone) const
{
    const auto at = std::find_if(gaps_.begin(), gaps_.end(), [&](const Gap& gap) { return gap.zone == zone; });
    return at == gaps_.end() ? nullptr : at->edit;
}

QuantityEdit* FitForm::seamOf(const std::string& one, const std::string& other) const
{
    const auto at = std::find_if(seams_.begin(), seams_.end(), [&](const Seam& seam) {
        return (seam.one == one && seam.other == other) || (seam.one == other && seam.other == one);
    });
    return at == seams_.end() ? nullptr : at->edit;
}

void FitForm::addGap(const std::string& zone, const QString& name)
{
    QuantityEdit* edit = optionalField(choice_.document(), Quantity::length(0, most_gap), tr("Gap: %1").arg(name),
                                       [this, zone, name](std::optional<double> gap) {
                                           editGarment(choice_.document(), tr("change gap: %1").arg(name), choice_.garmentIndex(),
                                                       "wearer.gap_mm." + zone, [&](Garment& garment) { setGap(garment, zone, gap); });
                                       });
    edit->setHelp(zone == "shoulder"  ? tr("Where cloth rests on the shoulder. Empty: as the zone there. 0: they touch.")
                  : zone == "default" ? tr("Of zones that have no gap of their own. Empty: 3 mm. 0: they touch.")
                                      : tr("Empty: as all others. 0: they touch."));
    addRow(zones_, name, edit);
    gaps_.push_back({zone, edit});
}

void FitForm::addSeam(const std::string& one, const std::string& other, const QString& name)
{
    QuantityEdit* edit = optionalField(
        choice_.document(), Quantity::percent(0, 1), tr("Seam: %1").arg(name), [this, one, other, name](std::optional<double> share) {
            editGarment(choice_.document(), tr("change seam: %1").arg(name), choice_.garmentIndex(), "seams." + one + "|" + other,
                        [&](Garment& garment) { setSeam(garment, one, other, share); });
        });
    edit->setHelp(one.empty() ? tr("Of seams that have no share of their own. Empty: 100 %, as where cloth overlaps; 0 %: taped.")
                              : tr("100 %: as where cloth overlaps; 0 %: taped. Empty: as all others."));
    addRow(seam_rows_, name, edit);
    seams_.push_back({one, other, edit});
}

/// A row for each two panels that are sewn together, however many edges they share.
void FitForm::rebuildSeams()
{
    std::vector<std::array<std::string, 2>> pairs{{}};
    if (const auto& drawing = choice_.drawing()) {
        for (const auto& [one, other] : drawing->sewn) {
            pairs.push_back({drawing->panels[static_cast<std::size_t>(one)].name, drawing->panels[static_cast<std::size_t>(other)].name});
        }
    }
    const bool same = std::equal(pairs.begin(), pairs.end(), seams_.begin(), seams_.end(),
                                 [](const auto& pair, const Seam& seam) { return pair[0] == seam.one && pair[1] == seam.other; });
    if (!same) {
        seam_rows_->setRowCount(0);
        seams_.clear();
        for (const auto& [one, other] : pairs) {
            addSeam(one, other, one.empty() ? tr("all others") : QString::fromStdString(one + " – " + other));
        }
        QWidget* before = gaps_.back().edit; // made after the fields of other docks
        for (const Seam& seam : seams_) {
            setTabOrder(before, seam.edit);
            before = seam.edit;
        }
    }
    refresh();
}

void FitForm::refresh()
{
    const Garment* garment = choice_.garment();
    widget()->setEnabled(garment != nullptr);
    if (!garment) { return; }
    const Document& document = choice_.document();
    const std::string where = "garments[" + std::to_string(choice_.garmentIndex()) + "].";
    const auto valueOf = [](const std::map<std::string, double>& map, const std::string& key) {
        const auto at = map.find(key);
        return at == map.end() ? std::nullopt : std::optional(at->second);
    };
    for (const Gap& gap : gaps_) {
        gap.edit->setValue(valueOf(garment->wearer.gap_mm, gap.zone));
        gap.edit->setDerived(gap.zone == "default" ? Garment{}.gap_of({}) : garment->gap_of("default"));
        gap.edit->setIssues(document.issuesAt(where + "wearer.gap_mm." + gap.zone));
    }
    for (const Seam& seam : seams_) {
        const std::string key = seamKey(*garment, seam.one, seam.other);
        seam.edit->setValue(valueOf(garment->seams, key));
        seam.edit->setDerived(seam.one.empty() ? 1.0 : garment->seam_between({}, {}));
        seam.edit->setIssues(document.issuesAt(where + "seams." + key));
    }
}

} // namespace hygroloom
