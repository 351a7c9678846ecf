// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/fabric_panel.h"

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

bool FabricPanel::showField(const std::string& where)
{
    const std::string extra = "].extra_yarns[";
    if (const std::size_t at = where.find(extra); at != std::string::npos) {
        stripes_->choose(std::atoi(where.c_str() + at + extra.size()) + 1);
    }
    const std::string fibre = "materials[";
    if (where.starts_with(fibre)) { fibres_->choose(std::atoi(where.c_str() + fibre.size())); }
    if (form_->showField(where)) { return true; }
    // A weft that is the same as the warp is edited there.
    const std::size_t weft = where.find("].weft");
    return weft != std::string::npos && form_->showField(std::string(where).replace(weft, 6, "].warp"));
}

DesignField FabricPanel::field(const QString& label, const QString& undo, const char* where, Read read, Write write, const QString& help)
{
    return {label,
            undo,
            [this, where] { return "fabrics[" + std::to_string(document_.fabricIndex()) + "]." + where; },
            [this, read = std::move(read)] { return document_.fabric() ? read(*document_.fabric()) : std::nullopt; },
            [this, write = std::move(write)](Design& design, std::optional<double> value) {
                write(design.fabrics[static_cast<std::size_t>(document_.fabricIndex())], value);
            },
            help};
}

void FabricPanel::addConstruction()
{
    form_->addSection(tr("Construction"));
    addSett(tr("Ends"), tr("ends per cm"), "ends_per_cm", &Fabric::ends_per_cm, tr("Warp yarns per centimetre. You can type “89 epi”."));
    addSett(tr("Picks"), tr("picks per cm"), "picks_per_cm", &Fabric::picks_per_cm,
            tr("Weft yarns per centimetre. You can type “89 ppi”."));
    addThickness();
    addFinish();
    addFaces();
    addCrimps();
    addDerived();
}

void FabricPanel::addSett(const QString& label, const QString& undo, const char* where, double Fabric::*member, const QString& help)
{
    QuantityEdit* edit = form_->addQuantity(Quantity::sett(0.5, 500),
                                            field(
                                                label, undo, where, [member](const Fabric& f) { return std::optional(f.*member); },
                                                [member](Fabric& f, std::optional<double> v) { f.*member = v.value_or(f.*member); }, help));
    QLabel* note = form_->noteBeside(edit);
    form_->onRefresh([=, this] {
        const Fabric* f = document_.fabric();
        edit->setEnabled(f != nullptr);
        note->setText(f ? edit->quantity().besideText(f->*member) : QString());
    });
}

void FabricPanel::addThickness()
{
    QuantityEdit* thickness = form_->addQuantity(
        Quantity::length(0.01, 50),
        field(
            tr("Thickness"), tr("thickness"), "thickness_mm", [](const Fabric& f) { return f.thickness_mm; },
            [](Fabric& f, std::optional<double> v) { f.thickness_mm = v; }, tr("Leave empty to calculate it from the yarns.")),
        true);
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
    QuantityEdit* angle = form_->addQuantity(
        Quantity::angle(0, 180),
        field(
            tr("Contact angle"), tr("contact angle"), "contact_angle_deg", [](const Fabric& f) { return f.contact_angle_deg; },
            [](Fabric& f, std::optional<double> v) { f.contact_angle_deg = v; },
            tr("Advancing contact angle of water on the finished fabric. Leave empty to use that of each yarn's fibres. Above 90° the "
               "yarns do not absorb water.")),
        true);
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
    const auto add = [&](const QString& label, const QString& undo, const char* where, std::optional<double> Fabric::*member) {
        return form_->addQuantity(
            Quantity::angle(0, 180),
            field(
                label, undo, where, [member](const Fabric& f) { return f.*member; },
                [member](Fabric& f, std::optional<double> v) { f.*member = v; },
                tr("Contact angle of a finish on this face alone. Leave empty for the yarns' own. Acts in the closure "
                   "“pores” only.")),
            true);
    };
    QuantityEdit* face = add(tr("Finish, top face"), tr("finish of the top face"), "finish_face", &Fabric::finish_face);
    QuantityEdit* back = add(tr("Finish, back"), tr("finish of the back"), "finish_back", &Fabric::finish_back);
    const auto addShare = [&](const QString& label, const QString& undo, const char* where, std::optional<double> Fabric::*member,
                              const QString& help) {
        return form_->addQuantity(Quantity::percent(0, 1),
                                  field(
                                      label, undo, where, [member](const Fabric& f) { return f.*member; },
                                      [member](Fabric& f, std::optional<double> v) { f.*member = v; }, help),
                                  true);
    };
    QuantityEdit* depth =
        addShare(tr("Finish, depth"), tr("depth of the finish"), "finish_depth", &Fabric::finish_depth,
                 tr("How deep the finish of a face reaches, of the fabric's thickness. The yarns wick below it. Leave empty for 10 %, "
                    "which is assumed. 100 %: the yarns that lie on the face are finished through. Acts in the closure “pores” only."));
    QuantityEdit* holes = addShare(tr("Finish, untreated"), tr("holes of the finish"), "finish_holes", &Fabric::finish_holes,
                                   tr("Share of the crowns and hairs on the finished face that the finish leaves untreated: liquid passes "
                                      "there at once. Leave empty for none. Acts in the closure “pores” only."));
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
    Quantity percent = Quantity::fraction(0, 100);
    percent.unit = "%";
    percent.units = {TradeUnit{{"%"}}};
    percent.step = 0.5;
    percent.decimals = 1;
    const auto add = [&](const QString& label, const QString& undo, const char* where, std::optional<double> Fabric::*member) {
        return form_->addQuantity(percent,
                                  field(
                                      label, undo, where, [member](const Fabric& f) { return f.*member; },
                                      [member](Fabric& f, std::optional<double> v) { f.*member = v; },
                                      tr("How much longer the yarn is than the fabric. Leave empty to share the crimp between warp and "
                                         "weft by their stiffness.")),
                                  true);
    };
    QuantityEdit* warp = add(tr("Warp crimp"), tr("warp crimp"), "warp_crimp_percent", &Fabric::warp_crimp_percent);
    QuantityEdit* weft = add(tr("Weft crimp"), tr("weft crimp"), "weft_crimp_percent", &Fabric::weft_crimp_percent);
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
    const auto add = [this](const QString& label, const QString& undo, const char* where, double Flyaway::*member, const Quantity& quantity,
                            const QString& help) {
        form_->addQuantity(quantity, field(
                                         label, undo, where, [member](const Fabric& f) { return std::optional(f.flyaway.*member); },
                                         [member](Fabric& f, std::optional<double> v) { f.flyaway.*member = v.value_or(0); }, help));
    };
    add(tr("Loops"), tr("loop density"), "flyaway.loop_density_per_mm", &Flyaway::loop_density_per_mm, Quantity::perMillimetre(1000),
        tr("Fibres that leave the yarn and come back to it, per mm of yarn. With the closure “pores” they hold falling drops off dry "
           "yarns."));
    add(tr("Hairs"), tr("hair density"), "flyaway.hair_density_per_mm", &Flyaway::hair_density_per_mm, Quantity::perMillimetre(1000),
        tr("Fibre ends that stand out of the yarn, per mm of yarn. With the closure “pores” they hold falling drops "
           "off dry yarns."));
    add(tr("Loop height"), tr("loop height"), "flyaway.loop_height_mm", &Flyaway::loop_height_mm, Quantity::length(0, 20),
        tr("Height of the highest loop above the yarn; the lowest is half as high. Loops make the cloth thicker, and the still air among "
           "them slows drying."));
    add(tr("Hair length"), tr("hair length"), "flyaway.hair_length_mm", &Flyaway::hair_length_mm, Quantity::length(0, 50),
        tr("Mean length of the fibre ends; the shortest have half of it, the longest one and a half times."));
}

void FabricPanel::addMeasured()
{
    form_->addFoldable(tr("Measured in the laboratory"), false);
    const auto add = [this](const QString& label, const QString& undo, const char* where, std::optional<double> Measured::*member,
                            const Quantity& quantity) {
        return form_->addQuantity(quantity,
                                  field(
                                      label, undo, where, [member](const Fabric& f) { return f.measured.*member; },
                                      [member](Fabric& f, std::optional<double> v) { f.measured.*member = v; },
                                      tr("Replaces the calculated value. Leave empty to use the calculated one.")),
                                  true);
    };
    Quantity weight = Quantity::fraction(1, 10000);
    weight.unit = "g/m²";
    weight.units = trade_units(Stored::g_per_m2);
    weight.step = 1;
    Quantity radius = Quantity::length(0.05, 1000);
    radius.unit = "µm";
    radius.units = trade_units(Stored::um);
    Quantity crimp = Quantity::fraction(0, 100);
    crimp.unit = "%";
    crimp.units = {TradeUnit{{"%"}}};
    crimp.step = 0.5;
    QuantityEdit* porosity = add(tr("Porosity"), tr("measured porosity"), "porosity", &Measured::porosity, Quantity::fraction(0.01, 0.999));
    QuantityEdit* areal = add(tr("Weight"), tr("measured weight"), "areal_density_g_m2", &Measured::areal_density_g_m2, weight);
    QuantityEdit* capillary =
        add(tr("Pore radius"), tr("measured pore radius"), "capillary_radius_um", &Measured::capillary_radius_um, radius);
    add(tr("Tortuosity"), tr("measured tortuosity"), "tortuosity", &Measured::tortuosity, Quantity::fraction(1, 20));
    QuantityEdit* measuredCrimp = add(tr("Crimp"), tr("measured crimp"), "crimp_percent", &Measured::crimp_percent, crimp);
    form_->onRefresh([=, this] {
        const FabricQuantities* q = document_.quantities();
        porosity->setDerived(q ? std::optional(q->porosity) : std::nullopt);
        areal->setDerived(q ? std::optional(q->areal_density_g_m2) : std::nullopt);
        capillary->setDerived(q ? std::optional(q->warp.pore_radius_um) : std::nullopt);
        measuredCrimp->setDerived(q ? std::optional(q->warp.crimp_percent) : std::nullopt);
    });
}

} // namespace hygroloom
