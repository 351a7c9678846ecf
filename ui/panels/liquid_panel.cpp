// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/liquid_panel.h"

#include "core/base/words.h"

#include "ui/basics/ask.h"
#include "ui/basics/core_words.h"
#include "ui/basics/icon_button.h"
#include "ui/basics/name_dialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace hygroloom {

namespace {

bool inLibrary(const std::string& name) { return find_liquid({}, name) != nullptr; }

QString shownName(const std::string& name)
{
    QString shown = coreWord(name);
    if (inLibrary(name)) { shown[0] = shown[0].toUpper(); }
    return shown;
}

std::string freeLiquidName(const Design& design, const std::string& wish)
{
    return free_name(wish, [&design](const std::string& name) { return name.empty() || find_liquid(design, name) != nullptr; });
}

} // namespace

LiquidPanel::LiquidPanel(DesignForm& form, QWidget* parent)
    : QObject(parent), form_(form), window_(parent), used_(new QComboBox), note_(new QLabel)
{
    Document& document = form_.document();
    form_.addRow(tr("Liquid"), used_, [&document] { return "experiments[" + std::to_string(document.experimentIndex()) + "].liquid"; });
    connect(used_, &QComboBox::activated, this, [this, &document](int row) {
        if (document.experiment()) {
            const auto index = static_cast<std::size_t>(document.experimentIndex());
            document.edit(tr("liquid"), {},
                          [&](Design& design) { design.experiments[index].liquid = used_->itemData(row).toString().toStdString(); });
        }
    });
    note_->setWordWrap(true);
    note_->setTextFormat(Qt::PlainText);
    note_->setAccessibleName(tr("About the liquid"));
    form_.addWide(note_);
}

void LiquidPanel::addOwnLiquids()
{
    section_ = form_.addFoldable(tr("Liquids of the project"), false);
    own_ = new QComboBox;
    own_->setAccessibleName(tr("Liquid of the project"));
    own_->setMinimumContentsLength(6);
    own_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(own_, &QComboBox::activated, this, &LiquidPanel::choose);
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(own_, 1);
    const auto button = [&](const char* icon, const QString& name, void (LiquidPanel::*work)()) {
        QToolButton* made = iconButton(icon, name);
        connect(made, &QToolButton::clicked, this, work);
        layout->addWidget(made);
        return made;
    };
    button("add", tr("Add a liquid like the experiment's, and use it"), &LiquidPanel::addLiquid);
    duplicate_ = button("duplicate", tr("Duplicate the liquid"), &LiquidPanel::duplicateLiquid);
    rename_ = button("rename", tr("Rename the liquid"), &LiquidPanel::askName);
    remove_ = button("delete", tr("Delete the liquid"), &LiquidPanel::askRemoval);
    form_.addWide(line);
    users_ = new QLabel;
    users_->setWordWrap(true);
    users_->setTextFormat(Qt::PlainText);
    users_->setForegroundRole(QPalette::PlaceholderText);
    users_->setAccessibleName(tr("Experiments that use the liquid"));
    form_.addWide(users_);
    const FormOwner<Liquid> row{
        [this] { return own() ? "liquids[" + std::to_string(own() - form_.document().design()->liquids.data()) + "]." : std::string(); },
        [this] { return own(); },
        [this](Design& design, const std::function<void(Liquid&)>& change) {
            if (own()) { change(design.liquids[static_cast<std::size_t>(own() - form_.document().design()->liquids.data())]); }
        }};
    for (const Field<Liquid>& each : fields_of<Liquid>()) { fields_.push_back(form_.addNumber(row, each.key)); }
    form_.onRefresh([this] { refresh(); });
}

const Liquid* LiquidPanel::own() const
{
    const auto& liquids = form_.document().design()->liquids;
    return liquids.empty() ? nullptr : &liquids[static_cast<std::size_t>(std::clamp(liquid_, 0, static_cast<int>(liquids.size()) - 1))];
}

QStringList LiquidPanel::usersOf(const std::string& liquid) const
{
    QStringList names;
    for (const Experiment& experiment : form_.document().design()->experiments) {
        if (experiment.liquid == liquid) { names << tr("“%1”").arg(QString::fromStdString(experiment.name)); }
    }
    return names;
}

void LiquidPanel::refresh()
{
    const Document& document = form_.document();
    const Experiment* experiment = document.experiment();
    const auto& liquids = document.design()->liquids;
    used_->setEnabled(experiment);
    used_->clear();
    for (const Liquid& liquid : liquids) { used_->addItem(QString::fromStdString(liquid.name), QString::fromStdString(liquid.name)); }
    for (const Liquid& liquid : library_liquids()) {
        if (const QString name = QString::fromStdString(liquid.name); used_->findData(name) < 0) { // one's own goes before
            used_->addItem(shownName(liquid.name), name);
        }
    }
    const Liquid* chosen = experiment ? find_liquid(*document.design(), experiment->liquid) : nullptr;
    if (experiment && !chosen) {
        used_->addItem(tr("%1 (missing)").arg(QString::fromStdString(experiment->liquid)), QString::fromStdString(experiment->liquid));
    }
    used_->setCurrentIndex(experiment ? used_->findData(QString::fromStdString(experiment->liquid)) : -1);
    note_->setForegroundRole(chosen ? QPalette::PlaceholderText : QPalette::WindowText);
    note_->setText(chosen ? tr("%1, %2, %3 at 20 °C")
                                .arg(Quantity::surfaceTension(1, 500).text(chosen->surface_tension_mn_m),
                                     Quantity::viscosity(0.05, 1000).text(chosen->viscosity_mpa_s),
                                     Quantity::density(500, 2000).text(chosen->density_kg_m3))
                   : experiment ? tr("The project has no liquid of this name. Choose another.")
                                : QString());
    const std::string used = experiment ? experiment->liquid : std::string();
    if (std::exchange(last_used_, used) != used) {
        for (std::size_t i = 0; i < liquids.size(); ++i) {
            if (liquids[i].name == used && static_cast<int>(i) != liquid_) {
                liquid_ = static_cast<int>(i);
                form_.refresh();
                return;
            }
        }
    }
    own_->clear();
    for (const Liquid& liquid : liquids) { own_->addItem(QString::fromStdString(liquid.name)); }
    own_->setCurrentIndex(own() ? static_cast<int>(own() - liquids.data()) : -1);
    for (QWidget* widget : std::initializer_list<QWidget*>{own_, duplicate_, rename_, remove_}) { widget->setEnabled(own()); }
    for (QWidget* widget : fields_) { widget->setEnabled(own()); }
    const QStringList users = own() ? usersOf(own()->name) : QStringList();
    users_->setText(!own()            ? tr("None yet. Add one to choose its surface tension, viscosity and density.")
                    : users.isEmpty() ? tr("No experiment uses it.")
                                      : tr("Used by %1.").arg(users.join(", ")));
}

void LiquidPanel::choose(int liquid)
{
    section_.open();
    liquid_ = liquid;
    form_.refresh();
}

void LiquidPanel::addLiquid()
{
    Document& document = form_.document();
    const Liquid* like = document.experiment() ? find_liquid(*document.design(), document.experiment()->liquid) : nullptr;
    Liquid made = like ? *like : library_liquids().front();
    made.name = freeLiquidName(*document.design(), made.name);
    document.editState(tr("add liquid"), [&](Design& design, DesignState& state) {
        design.liquids.push_back(made);
        if (document.experiment()) { design.experiments[static_cast<std::size_t>(state.experiment)].liquid = made.name; }
    });
    choose(static_cast<int>(document.design()->liquids.size()) - 1);
}

void LiquidPanel::duplicateLiquid()
{
    if (!own()) { return; }
    Document& document = form_.document();
    Liquid made = *own();
    made.name = freeLiquidName(*document.design(), made.name);
    document.endStroke();
    document.edit(tr("duplicate liquid"), {}, [&](Design& design) { design.liquids.push_back(made); });
    choose(static_cast<int>(document.design()->liquids.size()) - 1);
}

QString LiquidPanel::whyNotNamed(const QString& name) const
{
    const std::string wanted = name.trimmed().toStdString();
    if (!own() || wanted.empty()) { return tr("A liquid needs a name."); }
    const bool taken = wanted != own()->name && find_liquid(*form_.document().design(), wanted);
    return taken ? tr("A liquid “%1” already exists. Choose another name.").arg(name.trimmed()) : QString();
}

bool LiquidPanel::rename(const QString& name, QString* why)
{
    *why = whyNotNamed(name);
    if (!why->isEmpty()) { return false; }
    const std::string wanted = name.trimmed().toStdString(), old = own()->name;
    if (wanted == old) { return true; }
    Document& document = form_.document();
    const auto index = static_cast<std::size_t>(own() - document.design()->liquids.data());
    document.endStroke();
    document.edit(tr("rename liquid"), {}, [&](Design& design) {
        design.liquids[index].name = wanted;
        for (Experiment& experiment : design.experiments) { experiment.liquid = experiment.liquid == old ? wanted : experiment.liquid; }
    });
    return true;
}

void LiquidPanel::removeLiquid()
{
    if (!own()) { return; }
    Document& document = form_.document();
    const std::string name = own()->name;
    const auto index = own() - document.design()->liquids.data();
    document.endStroke();
    document.edit(tr("delete liquid"), {}, [&](Design& design) {
        design.liquids.erase(design.liquids.begin() + index);
        for (Experiment& experiment : design.experiments) {
            if (experiment.liquid == name && !find_liquid(design, name)) { experiment.liquid = "water"; }
        }
    });
}

void LiquidPanel::askName()
{
    if (!own()) { return; }
    NameDialog dialog(
        tr("Rename liquid"), QString::fromStdString(own()->name), [this](const QString& name) { return whyNotNamed(name); }, window_);
    QString why;
    if (dialog.exec() == QDialog::Accepted) { rename(dialog.name(), &why); }
}

void LiquidPanel::askRemoval()
{
    const QStringList users = own() ? usersOf(own()->name) : QStringList();
    if (!users.isEmpty()) {
        const QString name = QString::fromStdString(own()->name);
        const QString instead = inLibrary(own()->name) ? tr("the library's liquid of the same name") : tr("water");
        if (!confirm(window_, tr("Delete liquid"), tr("Delete “%1”?").arg(name),
                     tr("“%1” is used by %2. They will use %3 instead.").arg(name, users.join(", "), instead), tr("Delete"))) {
            return;
        }
    }
    removeLiquid();
}

} // namespace hygroloom
