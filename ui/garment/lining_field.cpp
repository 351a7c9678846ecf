// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/lining_field.h"

#include "ui/basics/elided_combo.h"
#include "ui/garment/fields.h"
#include "ui/garment/garment_edits.h"

#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int first_fabric = 2; ///< among the choices, behind none and the same

/// Of a panel, among the choices; less than 0: none of them.
int liningOf(const PanelCut* cut, const QStringList& fabrics)
{
    if (!cut || cut->layers < 2) { return 0; }
    if (cut->lining.empty()) { return 1; }
    const auto fabric = static_cast<int>(fabrics.indexOf(QString::fromStdString(cut->lining)));
    return fabric < 0 ? -1 : first_fabric + fabric;
}

} // namespace

LiningField::LiningField(GarmentChoice& choice, QWidget* parent)
    : QWidget(parent), choice_(choice), label_(new QLabel), lining_(new ElidedCombo)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label_);
    layout->addWidget(lining_, 1);
    label_->setBuddy(lining_);
    lining_->setAccessibleName(tr("Lining"));
    lining_->setMinimumContentsLength(6);
    lining_->setPlaceholderText(tr("not alike"));
    lining_->setIconSize({12, 12});
    lining_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(lining_, &QComboBox::activated, this, &LiningField::line);
    connect(&choice_, &GarmentChoice::drawingChanged, this, [this] { setPanel(-1); });
    connect(&choice_, &GarmentChoice::changed, this, &LiningField::refresh);
    refresh();
}

void LiningField::setPanel(int panel)
{
    panel_ = panel;
    refresh();
}

std::vector<std::string> LiningField::panels() const
{
    std::vector<std::string> names;
    if (!choice_.drawing()) { return names; }
    const auto& drawn = choice_.drawing()->panels;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        if (panel_ < 0 || static_cast<std::size_t>(panel_) == k) { names.push_back(drawn[k].name); }
    }
    return names;
}

void LiningField::refresh()
{
    const std::vector<std::string> chosen = panels();
    setEnabled(choice_.garment() && !chosen.empty());
    if (!isEnabled()) { return; }
    const QString of = panel_ < 0 ? tr("Lining of all panels") : tr("Lining of %1").arg(QString::fromStdString(chosen.front()));
    label_->setText(of);
    lining_->setAccessibleName(of);
    const QStringList fabrics = namesOf(choice_.document().design()->fabrics);
    const auto own = [&](const std::string& panel) { return liningOf(choice_.garment()->cut_of(panel), fabrics); };
    const int first = own(chosen.front());
    const bool alike = std::all_of(chosen.begin(), chosen.end(), [&](const std::string& panel) { return own(panel) == first; });
    setChoices(lining_, QStringList{tr("none"), tr("the same fabric")} + fabrics, alike ? first : -1,
               [](int i) { return i < first_fabric ? QIcon() : colorIcon(fabricColor(i - first_fabric)); });
    const PanelCut* cut = choice_.garment()->cut_of(chosen.front());
    const QString about = tr("A second layer of cloth under the first, on the skin. Choose a panel in the table to line it alone.");
    lining_->setToolTip(alike && cut && cut->layers > 2 ? tr("%1 layers.").arg(cut->layers) + "\n" + about : about);
}

void LiningField::line(int index)
{
    const std::vector<std::string> chosen = panels();
    const auto& fabrics = choice_.document().design()->fabrics;
    const std::string lining = index < first_fabric ? std::string() : fabrics[static_cast<std::size_t>(index - first_fabric)].name;
    const QString what = panel_ < 0 ? tr("line all panels") : tr("line %1").arg(QString::fromStdString(chosen.front()));
    editGarment(choice_.document(), what, choice_.garmentIndex(), {}, [&](Garment& garment) {
        for (const std::string& panel : chosen) {
            const PanelCut* usual = garment.cut_of(panel);
            if (!usual) { continue; }
            PanelCut cut = *usual;
            cut.layers = index == 0 ? 1 : std::max(2, cut.layers);
            cut.lining = lining;
            garment.panels[panel] = cut;
        }
    });
}

} // namespace hygroloom
