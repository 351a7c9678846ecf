// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a yarn is made of: its fibre, the one that it is blended with, its core; and the project's own copies of them.
#include "ui/basics/core_words.h"
#include "ui/panels/fibre_panel.h"
#include "ui/panels/yarn_panel.h"

#include <QToolButton>

#include <algorithm>

namespace hygroloom {

void YarnPanel::addMaterials()
{
    fibre_ = new QComboBox;
    blend_ = new QComboBox;
    form_.addRow(tr("Fibre"), fibre_, [this] { return path("material"); });
    addOwnButton(fibre_, tr("Own fibre from the yarn's"), [](Yarn& y) { return y.material.empty() ? nullptr : &y.material[0].name; });
    form_.addRow(tr("Blended with"), blend_);
    addOwnButton(blend_, tr("Own fibre from the blended one"),
                 [](Yarn& y) { return y.material.size() > 1 ? &y.material[1].name : nullptr; });
    connect(fibre_, &QComboBox::activated, this, [this](int index) {
        const std::string name = fibre_->itemData(index).toString().toStdString();
        editYarn(tr("%1 fibre").arg(kind_), path("material"), [&](Yarn& y) { y.material.front().name = name; });
    });
    connect(blend_, &QComboBox::activated, this, [this](int index) {
        const std::string name = blend_->itemData(index).toString().toStdString();
        editYarn(tr("%1 blend").arg(kind_), path("material"), [&](Yarn& y) {
            const double share = y.material.size() > 1 ? y.material.front().share : 0.5;
            y.material.resize(1);
            y.material.front().share = index == 0 ? 1.0 : share;
            if (index > 0) { y.material.push_back({name, 1 - share}); }
        });
    });
    share_ = form_.addQuantity(
        Quantity::percent(0.01, 1),
        {tr("Share of first fibre"), tr("%1 blend share").arg(kind_), [this] { return path("material[0].share"); },
         [this] { return yarn() && !yarn()->material.empty() ? std::optional(yarn()->material.front().share) : std::nullopt; },
         writing([](Yarn& y, std::optional<double> v) {
             if (y.material.size() == 2 && v) {
                 y.material[0].share = *v;
                 y.material[1].share = 1 - *v;
             }
         }),
         tr("Fraction of the first fibre, by dry mass.")});
}

void YarnPanel::addOwnButton(QComboBox* choice, const QString& name, PartName part)
{
    auto* button = new QToolButton;
    button->setText(tr("Own…")); // with its width the panel is laid out
    button->setAccessibleName(name);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    form_.putBeside(choice, button);
    own_buttons_.emplace_back(button, part);
    connect(button, &QToolButton::clicked, this, [this, part] { makeOwn(part); });
}

void YarnPanel::makeOwn(PartName part)
{
    Document& document = form_.document();
    Yarn now = *yarn();
    const std::string* used = part(now);
    Design made = *document.design();
    const std::optional<std::size_t> own = used ? ownFibre(made, *used) : std::nullopt;
    if (!own) { return; }
    if (made.materials.size() > document.design()->materials.size()) {
        const std::string name = made.materials[*own].name;
        const auto take = writing([&](Yarn& y, std::optional<double>) { *part(y) = name; });
        document.endStroke();
        document.edit(tr("own fibre"), {}, [&](Design& design) {
            design.materials = made.materials;
            take(design, {});
        });
    }
    Q_EMIT fibreRequested(static_cast<int>(*own));
}

void YarnPanel::addCore()
{
    core_ = new QComboBox;
    core_->setToolTip(
        "<p>" +
        tr("Of a core-spun yarn: the bare filament in its middle, which the fibres are spun round. It takes room from the pores "
           "and no liquid water.") +
        "</p>");
    form_.addRow(tr("Core"), core_, [this] { return path("core"); });
    addOwnButton(core_, tr("Own fibre from the core's"), [](Yarn& y) { return y.core ? &y.core->material : nullptr; });
    connect(core_, &QComboBox::activated, this, [this](int index) {
        const std::string name = core_->itemData(index).toString().toStdString();
        editYarn(tr("%1 core").arg(kind_), path("core"), [&](Yarn& y) {
            const YarnCore before = y.core.value_or(YarnCore{});
            y.core.reset();
            if (index > 0) { y.core = YarnCore{name, before.share}; }
        });
    });
    core_share_ = form_.addNumber(FormOwner<YarnCore>{[this] { return path("core."); },
                                                      [this] { return yarn() && yarn()->core ? &*yarn()->core : nullptr; },
                                                      [this](Design& design, const std::function<void(YarnCore&)>& change) {
                                                          writing([&](Yarn& y, std::optional<double>) {
                                                              if (y.core) { change(*y.core); }
                                                          })(design, {});
                                                      },
                                                      kind_},
                                  "share");
}

void YarnPanel::refreshMaterials()
{
    QStringList names;
    for (const Material& material : form_.document().design()->materials) { names << QString::fromStdString(material.name); }
    for (const Material& material : material_library()) {
        if (const QString name = QString::fromStdString(material.name); !names.contains(name)) { names << name; }
    }
    const auto fill = [](QComboBox* box, QStringList items, const QString& current) {
        if (!items.contains(current)) { items << current; }
        QStringList present;
        for (int i = 0; i < box->count(); ++i) { present << box->itemData(i).toString(); }
        if (present != items) {
            box->clear();
            for (const QString& item : items) { box->addItem(coreWord(item), item); }
        }
        box->setCurrentIndex(static_cast<int>(items.indexOf(current)));
    };
    const auto& material = yarn()->material;
    const QString none = tr("none");
    fill(fibre_, names, material.empty() ? QString() : QString::fromStdString(material.front().name));
    fill(blend_, QStringList{none} + names, material.size() > 1 ? QString::fromStdString(material[1].name) : none);
    fill(core_, QStringList{none} + names, yarn()->core ? QString::fromStdString(yarn()->core->material) : none);
}

void YarnPanel::refreshOwnButtons()
{
    Yarn now = yarn() ? *yarn() : Yarn{};
    const auto& materials = form_.document().design()->materials;
    for (const auto& [button, part] : own_buttons_) {
        const std::string* name = yarn() ? part(now) : nullptr;
        const bool own = name && std::any_of(materials.begin(), materials.end(), [name](const Material& m) { return m.name == *name; });
        button->setText(own ? tr("Edit…") : tr("Own…"));
        button->setToolTip("<p>" +
                           (own ? tr("Shows the values of this fibre of the project: cross-section, size, wetting, regain.")
                                : tr("Copies this fibre into the project, where its cross-section, size, wetting and regain can be set.")) +
                           "</p>");
        button->setVisible(name || part == own_buttons_.front().second);
        button->setEnabled(name);
    }
}

} // namespace hygroloom
