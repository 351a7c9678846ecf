// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/yarn_panel.h"

#include "ui/basics/ask.h"
#include "ui/basics/core_words.h"
#include "ui/basics/count_edit.h"
#include "ui/basics/number_label.h"
#include "ui/weave/cloth_picture.h"

#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace hygroloom {

namespace {

QIcon swatch(const QColor& color, const QPalette& palette)
{
    QPixmap pixmap(32, 32);
    pixmap.fill(color);
    QPainter painter(&pixmap);
    painter.setPen(QPen(palette.color(QPalette::Mid), 2));
    painter.drawRect(1, 1, 30, 30);
    return pixmap;
}

} // namespace

YarnPanel::YarnPanel(DesignForm& form, YarnUse use, QObject* parent)
    : QObject(parent), form_(form), use_(use), kind_(use == YarnUse::warp   ? tr("warp")
                                                     : use == YarnUse::weft ? tr("weft")
                                                                            : tr("stripe yarn")),
      section_(form.addFoldable(use == YarnUse::warp   ? tr("Warp yarn")
                                : use == YarnUse::weft ? tr("Weft yarn")
                                                       : tr("Yarns of the stripes"))),
      row_{[this] { return path(""); }, [this] { return yarn(); },
           [this](Design& design, const std::function<void(Yarn&)>& change) {
               writing([&](Yarn& y, std::optional<double>) { change(y); })(design, {});
           },
           kind_}
{
    if (use == YarnUse::weft) {
        addSameAsWarp();
    } else if (use == YarnUse::stripes) {
        addChoice();
    }
    addLibrary();
    addMaterials();
    addCore();
    addSizes();
    addTwist();
    addPlies();
    addColor();
    QuantityEdit* filaments = form.addNumber(row_, "filament_count");
    QuantityEdit* fibres = form.addNumber(row_, "fibres_per_yarn");
    QuantityEdit* evenness = form.addNumber(row_, "irregularity_cv");
    QuantityEdit* price = form.addNumber(row_, "price");
    price->setPlaceholderText(tr("no price"));
    crimp_ = form.addDerived(tr("Crimp"), tr("How much longer the yarn is than the fabric."));
    pore_ = form.addDerived(tr("Fibre pores"), tr("Radius of the pores between the fibres; they draw water in by capillarity."));
    fields_ = {fibre_,           blend_, share_,     core_,          core_share_, diameter_, count_, packing_, twist_,
               twist_direction_, plies_, ply_twist_, ply_direction_, color_,      filaments, fibres, evenness, price};
    form.onRefresh([this] { refresh(); });
}

/// Count, diameter and packing factor determine one another. Count and diameter take each other's place; emptied, one leaves the other as
/// it was calculated, so that the yarn keeps its size.
void YarnPanel::addSizes()
{
    const auto size = [&](const char* key, Write write) {
        DesignField made = field_of(row_, key);
        made.write = writing(std::move(write));
        made.within = [this] { return path("").substr(0, path("").size() - 1); };
        return made;
    };
    count_ = new CountEdit;
    DesignField count = size("linear_density_tex", [this](Yarn& y, std::optional<double> v) {
        if (v) {
            set_count(y, count_->count());
        } else {
            y.linear_density_tex.reset();
            if (!y.diameter_mm && free_) { y.diameter_mm = free_->diameter; }
        }
    });
    count.label = tr("Count");
    count.undo = kind_ + " " + tr("count");
    count.help =
        tr("As the trade writes it, with plies and filaments: %1. The diameter follows from it.").arg(QString::fromUtf8(count_forms));
    form_.addField(count_, count, true);
    count_note_ = form_.noteBeside(count_);
    diameter_ = form_.addNumber<Yarn>("diameter_mm", size("diameter_mm", [this](Yarn& y, std::optional<double> v) {
                                          if (v) {
                                              y.linear_density_tex.reset();
                                          } else if (!y.linear_density_tex && free_) {
                                              y.linear_density_tex = free_->linear_density_tex;
                                          }
                                          y.diameter_mm = v;
                                      }));
    diameter_note_ = form_.noteBeside(diameter_);
    packing_ = form_.addNumber<Yarn>("packing_factor", size("packing_factor", [](Yarn& y, std::optional<double> v) {
                                         y.packing_factor = v;
                                         if (v && y.diameter_mm && y.linear_density_tex) { y.diameter_mm.reset(); }
                                     }));
}

void YarnPanel::addTwist()
{
    twist_ = form_.addNumber(row_, "twist_per_m");
    twist_direction_ = addDirection("twist_direction", &Yarn::twist_direction);
}

void YarnPanel::addPlies()
{
    plies_ = form_.addNumber(row_, "plies");
    ply_twist_ = form_.addNumber(row_, "ply_twist_per_m");
    ply_direction_ = addDirection("ply_twist_direction", &Yarn::ply_twist_direction);
}

QComboBox* YarnPanel::addDirection(const char* key, TwistDirection Yarn::*member)
{
    auto* box = new QComboBox;
    box->addItems({tr("S twist"), tr("Z twist")});
    const DesignField row = field_of(row_, key);
    form_.addRow(row.label, box);
    connect(box, &QComboBox::activated, this, [this, row, key, member](int index) {
        editYarn(row.undo, path(key), [=](Yarn& y) { y.*member = index == 0 ? TwistDirection::s : TwistDirection::z; });
    });
    return box;
}

void YarnPanel::addSameAsWarp()
{
    same_ = new QCheckBox(tr("Same as warp"));
    same_->setAccessibleName(tr("Weft yarn is the same as the warp yarn"));
    form_.addWide(same_);
    connect(same_, &QCheckBox::clicked, this, [this](bool on) {
        unlinked_ = on ? std::string() : form_.document().fabric()->name;
        if (on && form_.document().fabric()->warp != form_.document().fabric()->weft) {
            const auto index = static_cast<std::size_t>(form_.document().fabricIndex());
            form_.document().edit(tr("weft same as warp"), {},
                                  [index](Design& design) { design.fabrics[index].weft = design.fabrics[index].warp; });
        }
        refresh();
    });
}

void YarnPanel::addChoice()
{
    choice_ = new QComboBox;
    choice_->setMinimumContentsLength(8);
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice_->setToolTip("<p>" + tr("Yarns beside the fabric's own, which is A. Letters are those of the stripes, such as 12A 4B.") +
                        "</p>");
    form_.addRow(tr("Yarn"), choice_);
    choice_->setAccessibleName(tr("Yarn of the stripes"));
    connect(choice_, &QComboBox::activated, this, [this](int index) {
        stripe_ = index;
        form_.refresh();
    });
}

void YarnPanel::choose(int yarn)
{
    section_.open();
    if (use_ == YarnUse::stripes) {
        stripe_ = std::max(0, yarn - 1);
        form_.refresh();
    }
}

void YarnPanel::addColor()
{
    color_ = new QToolButton;
    color_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    color_->setPopupMode(QToolButton::InstantPopup);
    color_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* menu = new QMenu(color_);
    connect(menu->addAction(tr("Choose…")), &QAction::triggered, this, [this] {
        if (const auto color = askColor(color_, tr("Yarn Colour"), yarnColor(*yarn(), isWarp()))) {
            editYarn(tr("%1 colour").arg(kind_), path("color"), [&](Yarn& y) {
                y.color = Color{static_cast<std::uint8_t>(color->red()), static_cast<std::uint8_t>(color->green()),
                                static_cast<std::uint8_t>(color->blue())};
            });
        }
    });
    connect(menu->addAction(tr("Undyed")), &QAction::triggered, this,
            [this] { editYarn(tr("%1 colour").arg(kind_), path("color"), [](Yarn& y) { y.color.reset(); }); });
    color_->setMenu(menu);
    form_.addRow(tr("Colour"), color_);
}

const Yarn* YarnPanel::yarn() const
{
    const Fabric* fabric = form_.document().fabric();
    if (!fabric) { return nullptr; }
    if (use_ == YarnUse::stripes) { return fabric->extra_yarns.empty() ? nullptr : &fabric->extra_yarns[stripe()]; }
    return use_ == YarnUse::weft ? &fabric->weft : &fabric->warp;
}

std::size_t YarnPanel::stripe() const
{
    const Fabric* fabric = form_.document().fabric();
    const int count = fabric ? static_cast<int>(fabric->extra_yarns.size()) : 0;
    return static_cast<std::size_t>(std::clamp(stripe_, 0, std::max(0, count - 1)));
}

Yarn& YarnPanel::yarnOf(Fabric& fabric) const
{
    return use_ == YarnUse::stripes ? fabric.extra_yarns[stripe()] : use_ == YarnUse::weft ? fabric.weft : fabric.warp;
}

std::function<void(Design&, std::optional<double>)> YarnPanel::writing(std::function<void(Yarn&, std::optional<double>)> change)
{
    return [this, change = std::move(change)](Design& design, std::optional<double> value) {
        if (!yarn()) { return; }
        Fabric& fabric = design.fabrics[static_cast<std::size_t>(form_.document().fabricIndex())];
        const bool linked = use_ == YarnUse::warp && fabric.name != unlinked_ && fabric.warp == fabric.weft;
        change(yarnOf(fabric), value);
        if (linked && !form_.property("weft apart").toBool()) { fabric.weft = fabric.warp; }
    };
}

void YarnPanel::editYarn(const QString& undo, const std::string& field, const std::function<void(Yarn&)>& change)
{
    const auto write = writing([&](Yarn& y, std::optional<double>) { change(y); });
    form_.document().edit(undo, field, [&](Design& design) { write(design, {}); });
    form_.document().endStroke();
}

std::string YarnPanel::path(const char* field) const
{
    const std::string own = use_ == YarnUse::stripes ? "extra_yarns[" + std::to_string(stripe()) + "]"
                            : use_ == YarnUse::weft  ? "weft"
                                                     : "warp";
    return "fabrics[" + std::to_string(form_.document().fabricIndex()) + "]." + own + "." + field;
}

void YarnPanel::refresh()
{
    if (choice_) { refreshChoice(); }
    refreshLibrary();
    const Yarn* y = yarn();
    for (QWidget* field : fields_) { field->setEnabled(y != nullptr); }
    if (same_) { same_->setEnabled(y != nullptr); }
    if (!y) {
        fibre_->setCurrentIndex(-1);
        blend_->setCurrentIndex(-1);
        refreshOwnButtons();
        refreshDerived();
        return;
    }
    refreshMaterials();
    count_->setYarn(*y);
    twist_direction_->setCurrentIndex(y->twist_direction == TwistDirection::s ? 0 : 1);
    ply_direction_->setCurrentIndex(y->ply_twist_direction == TwistDirection::s ? 0 : 1);
    color_->setIcon(swatch(yarnColor(*y, isWarp()), form_.palette()));
    color_->setText(y->color ? yarnColor(*y, isWarp()).name() : tr("undyed"));
    share_->setEnabled(y->material.size() == 2);
    core_share_->setEnabled(y->core.has_value());
    ply_twist_->setEnabled(y->plies > 1);
    ply_direction_->setEnabled(y->plies > 1);
    refreshOwnButtons();
    if (same_) { refreshSame(); }
    refreshDerived();
}

void YarnPanel::refreshSame()
{
    const Fabric& fabric = *form_.document().fabric();
    const bool same = fabric.warp == fabric.weft && fabric.name != unlinked_;
    form_.setProperty("weft apart", !same);
    same_->setChecked(same);
    for (QWidget* field : fields_) { field->setEnabled(!same && field->isEnabled()); }
    for (const auto& [button, part] : own_buttons_) { button->setEnabled(!same); }
}

void YarnPanel::refreshChoice()
{
    const Fabric* fabric = form_.document().fabric();
    const int count = fabric ? static_cast<int>(fabric->extra_yarns.size()) : 0;
    section_.setShown(count > 0);
    choice_->clear();
    for (int i = 0; i < count; ++i) {
        const Yarn& one = fabric->extra_yarns[static_cast<std::size_t>(i)];
        const QString fibre = one.material.empty() ? QString() : coreWord(one.material.front().name);
        choice_->addItem(swatch(yarnColor(one, true), form_.palette()), yarnLetter(i + 1) + "  " + fibre);
    }
    choice_->setCurrentIndex(static_cast<int>(stripe()));
}

void YarnPanel::refreshDerived()
{
    const auto& fitted = form_.document().fitted();
    const YarnQuantities* q = nullptr;
    free_.reset();
    if (use_ == YarnUse::stripes) {
        if (fitted && stripe() < fitted->stripes.size()) {
            const StripeYarn& lying = fitted->stripes[stripe()];
            free_ = lying.free;
            q = lying.as_end ? &*lying.as_end : lying.as_pick ? &*lying.as_pick : nullptr;
        }
    } else if (fitted) {
        q = use_ == YarnUse::weft ? &fitted->derived.weft : &fitted->derived.warp;
        free_ = FreeYarn{q->diameter_mm, q->linear_density_tex, q->packing_factor};
    }
    diameter_->setDerived(free_ ? std::optional(free_->diameter) : std::nullopt);
    count_->setDerived(free_ ? std::optional(free_->linear_density_tex) : std::nullopt);
    packing_->setDerived(free_ ? std::optional(free_->packing_factor) : std::nullopt);
    const Yarn* y = yarn();
    count_note_->setText(y && y->linear_density_tex ? count_->otherSystem(*y->linear_density_tex) : QString());
    diameter_note_->setText(y && y->linear_density_tex && !y->diameter_mm ? tr("from the count") : QString());
    if (q) {
        showNumbers(*crimp_, {q->crimp_percent}, "%");
        showNumbers(*pore_, {q->pore_radius_um}, "µm");
    } else {
        for (QLabel* label : {crimp_, pore_}) { label->setText(QStringLiteral("–")); }
    }
}

} // namespace hygroloom
