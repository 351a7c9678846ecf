// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/fabric_panel.h"

#include "core/laboratory/technical.h"
#include "core/project/library.h"
#include "ui/basics/core_words.h"
#include "ui/basics/number_label.h"
#include "ui/basics/preferences.h"
#include "ui/panels/fibre_panel.h"
#include "ui/panels/yarn_panel.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include <cmath>
#include <cstdlib>

namespace hygroloom {

FabricPanel::FabricPanel(Document& document, QWidget* parent) : QScrollArea(parent), document_(document), form_(new DesignForm(document))
{
    addConstruction();
    warp_ = new YarnPanel(*form_, YarnUse::warp, this);
    auto* weft = new YarnPanel(*form_, YarnUse::weft, this);
    stripes_ = new YarnPanel(*form_, YarnUse::stripes, this);
    fibres_ = new FibrePanel(*form_, this);
    for (const YarnPanel* yarn : {warp_, weft, stripes_}) {
        connect(yarn, &YarnPanel::fibreRequested, this, [this](int fibre) {
            fibres_->choose(fibre);
            fibres_->startEditing();
        });
    }
    addFlyaway();
    addMeasured();
    addLoom();
    form_->fill(this);
    connect(&PreferenceNews::instance(), &PreferenceNews::changed, form_, &DesignForm::refresh);
    form_->refresh();
}

void FabricPanel::showYarn(int yarn)
{
    YarnPanel* panel = yarn > 0 ? stripes_ : warp_;
    panel->choose(yarn);
    // The form has to know its size before it can scroll there.
    QMetaObject::invokeMethod(
        this,
        [this, panel] {
            widget()->layout()->activate();
            ensureWidgetVisible(panel->section().content, 0, 0);
            ensureWidgetVisible(panel->section().heading, 0, 8);
        },
        Qt::QueuedConnection);
}

bool FabricPanel::showField(const Place& where)
{
    if (where.key(2) == "extra_yarns" && where.number(2)) { stripes_->choose(static_cast<int>(*where.number(2)) + 1); }
    if (where.key(0) == "materials" && where.number(0)) { fibres_->choose(static_cast<int>(*where.number(0))); }
    if (form_->showField(where.text())) { return true; }
    // A weft that is the same as the warp is edited there.
    return where.key(2) == "weft" && form_->showField(where.with(2, std::string("warp")).text());
}

void FabricPanel::addConstruction()
{
    form_->addSection(tr("Construction"));
    addSett("ends_per_cm", &Fabric::ends_per_cm);
    addSett("picks_per_cm", &Fabric::picks_per_cm);
    addThickness();
    addFinish();
    addFaces();
    addCrimps();
    addDerived();
}

void FabricPanel::addSett(const char* key, double Fabric::*member)
{
    QuantityEdit* edit = form_->addNumber(whole(), key);
    QLabel* note = form_->noteBeside(edit);
    form_->onRefresh([=, this] {
        const Fabric* f = document_.fabric();
        edit->setEnabled(f != nullptr);
        note->setText(f ? edit->quantity().besideText(f->*member) : QString());
    });
}

void FabricPanel::addThickness()
{
    QuantityEdit* thickness = form_->addNumber(whole(), "thickness_mm");
    auto* automatic = new QCheckBox(tr("Auto"));
    automatic->setAccessibleName(tr("Calculate the thickness from the yarns"));
    automatic->setToolTip(automatic->accessibleName());
    auto* grid = qobject_cast<QGridLayout*>(form_->layout());
    grid->addWidget(automatic, grid->rowCount() - 1, 2);
    connect(automatic, &QCheckBox::clicked, this, [this](bool on) {
        const auto index = static_cast<std::size_t>(document_.fabricIndex());
        const double derived = document_.quantities() ? std::round(document_.quantities()->thickness_mm * 1000) / 1000 : 0.5;
        document_.edit(tr("thickness"), {},
                       [&](Design& design) { design.fabrics[index].thickness_mm = on ? std::nullopt : std::optional(derived); });
    });
    form_->onRefresh([=, this] {
        const Fabric* f = document_.fabric();
        const FabricQuantities* q = document_.quantities();
        for (QWidget* widget : {static_cast<QWidget*>(thickness), static_cast<QWidget*>(automatic)}) { widget->setEnabled(f != nullptr); }
        automatic->setChecked(f && !f->thickness_mm);
        thickness->setDerived(q ? std::optional(q->thickness_mm) : std::nullopt);
    });
}

/// The contact angle, and finishes that set it.
void FabricPanel::addFinish()
{
    QuantityEdit* angle = form_->addNumber(whole(), "contact_angle_deg");
    auto* finish = new QComboBox;
    finish->addItem(tr("As the fibres"));
    for (const Finish& one : finishes()) {
        finish->addItem(tr("%1, %2°").arg(coreWord(one.name)).arg(one.contact_angle_deg));
        finish->setItemData(finish->count() - 1, QString::fromStdString(one.note), Qt::ToolTipRole);
    }
    finish->addItem(tr("Own contact angle"));
    finish->setMinimumContentsLength(8);
    finish->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    finish->setToolTip("<p>" + tr("Sets the contact angle above to a typical value for the finish. Measure your own fabric if you can.") +
                       "</p>");
    form_->addRow(tr("Finish"), finish);
    connect(finish, &QComboBox::activated, this, [this](int index) {
        if (index > static_cast<int>(finishes().size())) {
            form_->refresh();
            return;
        }
        const auto fabric = static_cast<std::size_t>(document_.fabricIndex());
        document_.edit(tr("finish"), {}, [&](Design& design) {
            design.fabrics[fabric].contact_angle_deg =
                index == 0 ? std::nullopt : std::optional(finishes()[static_cast<std::size_t>(index) - 1].contact_angle_deg);
        });
    });
    form_->onRefresh([=, this] {
        const Fabric* f = document_.fabric();
        const FabricQuantities* q = document_.quantities();
        angle->setEnabled(f != nullptr);
        finish->setEnabled(f != nullptr);
        angle->setDerived(q ? std::optional(q->warp.contact_angle_deg) : std::nullopt);
        int row = f && f->contact_angle_deg ? static_cast<int>(finishes().size()) + 1 : 0;
        for (std::size_t i = 0; f && i < finishes().size(); ++i) {
            row = f->contact_angle_deg == finishes()[i].contact_angle_deg ? static_cast<int>(i) + 1 : row;
        }
        finish->setCurrentIndex(row);
    });
}

/// What lies on one face only, and the angle at which water draws back.
void FabricPanel::addFaces()
{
    QLabel* receding =
        form_->addDerived(tr("Receding angle"),
                          tr("Contact angle of water that draws back, of warp and weft; 0 on cotton, flax, hemp and viscose, else 20° less "
                             "than the contact angle, both assumed, unless the material gives one. Acts in the closure “pores” only."));
    QuantityEdit* face = form_->addNumber(whole(), "finish_face");
    QuantityEdit* back = form_->addNumber(whole(), "finish_back");
    QuantityEdit* depth = form_->addNumber(whole(), "finish_depth");
    QuantityEdit* holes = form_->addNumber(whole(), "finish_holes");
    form_->onRefresh([=, this] {
        const FabricQuantities* q = document_.quantities();
        for (QuantityEdit* edit : {face, back}) {
            edit->setEnabled(document_.fabric() != nullptr);
            edit->setDerived(q ? std::optional(q->warp.contact_angle_deg) : std::nullopt);
        }
        const Fabric* f = document_.fabric();
        for (QuantityEdit* edit : {depth, holes}) { edit->setEnabled(f != nullptr && (f->finish_face || f->finish_back)); }
        depth->setDerived(q ? std::optional(default_finish_depth) : std::nullopt);
        holes->setDerived(q ? std::optional(0.0) : std::nullopt);
        receding->setText(q ? tr("%1° × %2°").arg(shownNumber(q->warp.receding_angle_deg, 0), shownNumber(q->weft.receding_angle_deg, 0))
                            : QStringLiteral("–"));
    });
}

void FabricPanel::addCrimps()
{
    QuantityEdit* warp = form_->addNumber(whole(), "warp_crimp_percent");
    QuantityEdit* weft = form_->addNumber(whole(), "weft_crimp_percent");
    form_->onRefresh([=, this] {
        const FabricQuantities* q = document_.quantities();
        warp->setEnabled(document_.fabric() != nullptr);
        weft->setEnabled(document_.fabric() != nullptr);
        warp->setDerived(q ? std::optional(q->warp.crimp_percent) : std::nullopt);
        weft->setDerived(q ? std::optional(q->weft.crimp_percent) : std::nullopt);
    });
}

void FabricPanel::addDerived()
{
    form_->addSection(tr("Calculated"));
    QLabel* weight = form_->addDerived(tr("Weight"), tr("Dry mass per area."));
    QLabel* cover = form_->addDerived(
        tr("Cover factor"), tr("Share of the area that yarns hide, seen from above; the rest are holes between them. 1: no hole."));
    QLabel* bending = form_->addDerived(
        tr("Yarn path"), tr("Round: yarns cross in circular arcs (Peirce). Flattened: the sett is too dense for full arcs, so yarns are "
                            "flattened where they cross."));
    QLabel* porosity = form_->addDerived(tr("Porosity"), tr("Share of the fabric's volume that is air, in yarns and between them."));
    QLabel* layer = form_->addDerived(tr("Yarn layer"), tr("Thickness of the interlaced yarns."));
    QLabel* gap = form_->addDerived(tr("Gaps"), tr("Between neighbouring ends × between neighbouring picks."));
    form_->onRefresh([=, this] {
        const FabricQuantities* q = document_.quantities();
        const QString none = QStringLiteral("–");
        if (!q) {
            for (QLabel* label : {weight, cover, bending, porosity, layer, gap}) { label->setText(none); }
            return;
        }
        showNumbers(*weight, {q->areal_density_g_m2}, "g/m²");
        showNumbers(*cover, {q->cover_factor}, {});
        bending->setText(q->jammed ? tr("flattened at crossings") : tr("round (Peirce)"));
        showNumbers(*porosity, {q->porosity}, {});
        showNumbers(*layer, {q->yarn_layer_thickness_mm}, "mm");
        showNumbers(*gap, {q->gap_warp_mm, q->gap_weft_mm}, "mm");
    });
}

void FabricPanel::addFlyaway()
{
    form_->addFoldable(tr("Flyaways"), false);
    const FormOwner<Flyaway> flyaway = part<Flyaway>("flyaway.", [](auto& fabric) { return &fabric.flyaway; });
    for (const Field<Flyaway>& row : fields_of<Flyaway>()) { form_->addNumber(flyaway, row.key); }
}

void FabricPanel::addMeasured()
{
    form_->addFoldable(tr("Measured in the laboratory"), false);
    const FormOwner<Measured> measured = part<Measured>(
        "", [](auto& fabric) { return &fabric.measured; }, tr("measured"));
    QuantityEdit* porosity = form_->addNumber(measured, "porosity");
    QuantityEdit* areal = form_->addNumber(measured, "areal_density_g_m2");
    form_->addNumber(measured, "tortuosity");
    QuantityEdit* measuredCrimp = form_->addNumber(measured, "crimp_percent");
    form_->onRefresh([=, this] {
        const FabricQuantities* q = document_.quantities();
        porosity->setDerived(q ? std::optional(q->porosity) : std::nullopt);
        areal->setDerived(q ? std::optional(q->areal_density_g_m2) : std::nullopt);
        measuredCrimp->setDerived(q ? std::optional(q->warp.crimp_percent) : std::nullopt);
    });
}

/// What the loom makes; what is not given follows, as the card says it.
void FabricPanel::addLoom()
{
    form_->addFoldable(tr("On the loom"), false);
    const FormOwner<Loom> loom = part<Loom>("loom.", [](auto& fabric) { return &fabric.loom; });
    QuantityEdit* reed = form_->addNumber(loom, "reed_width_cm");
    QuantityEdit* ends = form_->addNumber(loom, "ends_per_cm");
    form_->addNumber(loom, "ends_per_dent");
    form_->addNumber(loom, "picks_per_cm");
    QLabel* dents = form_->addDerived(tr("Reed"), tr("Dents in 10 cm, from ends in the reed and ends a dent."));
    QLabel* width = form_->addDerived(tr("Shrinks in width"), tr("From the reed to the finished cloth, of its width."));
    QLabel* length = form_->addDerived(tr("Shrinks in length"), tr("From the loom to the finished cloth, of its length."));
    form_->onRefresh([=, this] {
        const Fabric* fabric = document_.fabric();
        const LoomState state = fabric && document_.fitted() ? technical_card(*fabric, *document_.fitted()).loom : LoomState();
        reed->setDerived(state.reed_width_cm);
        ends->setDerived(state.ends_per_cm);
        const auto show = [](QLabel* label, const std::optional<double>& value, const char* unit) {
            if (value)
                showNumbers(*label, {*value}, unit);
            else
                label->setText(QStringLiteral("–"));
        };
        show(dents, state.dents_per_10_cm, "/10 cm");
        show(width, state.width_shrinks_percent, "%");
        show(length, state.length_shrinks_percent, "%");
    });
}

} // namespace hygroloom
