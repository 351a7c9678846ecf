// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/panels/fibre_panel.h"

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

std::string freeFibreName(const Design& design, const std::string& wish)
{
    return free_name(wish, [&design](const std::string& name) { return name.empty() || find_material(design, name) != nullptr; });
}

/// Calls work(name) for every name of a fibre in the design's yarns.
template <typename Work> void eachName(Design& design, const Work& work)
{
    for (Fabric& fabric : design.fabrics) {
        const auto of = [&work](Yarn& yarn) {
            for (MaterialShare& part : yarn.material) { work(part.name); }
            if (yarn.core) { work(yarn.core->material); }
        };
        of(fabric.warp);
        of(fabric.weft);
        std::for_each(fabric.extra_yarns.begin(), fabric.extra_yarns.end(), of);
    }
}

/// What yarns take that lose an own fibre: the library's of the same name, else the one that it starts from.
std::string instead(const Material& fibre)
{
    const std::string name = library_name(fibre);
    return find_library_material(name) ? name : material_library().front().name;
}

/// Own numbers are written in the file only: their entry is there while the fibre has them.
enum IsothermRow { as_base, master_curve, own_numbers };

} // namespace

std::optional<std::size_t> ownFibre(Design& design, const std::string& name)
{
    const auto found =
        std::find_if(design.materials.begin(), design.materials.end(), [&](const Material& own) { return own.name == name; });
    if (found != design.materials.end()) { return static_cast<std::size_t>(found - design.materials.begin()); }
    const Material* library = find_library_material(name);
    if (!library) { return std::nullopt; }
    Material made = *library;
    made.based_on = name;
    made.name = freeFibreName(design, name);
    design.materials.push_back(made);
    return design.materials.size() - 1;
}

FibrePanel::FibrePanel(DesignForm& form, QWidget* parent)
    : QObject(parent), form_(form), window_(parent), section_(form.addFoldable(tr("Fibres of the project"), false))
{
    addChoice();
    addCrossSection();
    addWetting();
    addSorption();
    addHeat();
    form_.setPlace(rename_, [this] { return path("name"); });
    form_.onRefresh([this] { refresh(); });
}

void FibrePanel::addChoice()
{
    own_ = new QComboBox;
    own_->setMinimumContentsLength(6);
    own_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(own_, &QComboBox::activated, this, &FibrePanel::choose);
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(own_, 1);
    const auto button = [&](const char* icon, const QString& name, void (FibrePanel::*work)()) {
        QToolButton* made = iconButton(icon, name);
        connect(made, &QToolButton::clicked, this, work);
        layout->addWidget(made);
        return made;
    };
    duplicate_ = button("duplicate", tr("Duplicate the fibre"), &FibrePanel::duplicateFibre);
    rename_ = button("rename", tr("Rename the fibre"), &FibrePanel::askName);
    remove_ = button("delete", tr("Delete the fibre"), &FibrePanel::askRemoval);
    form_.addWide(line);
    own_->setAccessibleName(tr("Fibre of the project"));
    about_ = new QLabel;
    about_->setWordWrap(true);
    about_->setTextFormat(Qt::PlainText);
    about_->setForegroundRole(QPalette::PlaceholderText);
    about_->setAccessibleName(tr("About the fibre"));
    form_.addWide(about_);
}

const Material* FibrePanel::own() const
{
    const auto& fibres = form_.document().design()->materials;
    return fibres.empty() ? nullptr : &fibres[static_cast<std::size_t>(std::clamp(fibre_, 0, static_cast<int>(fibres.size()) - 1))];
}

std::string FibrePanel::path(const char* field) const
{
    return own() ? "materials[" + std::to_string(own() - form_.document().design()->materials.data()) + "]." + field : std::string();
}

void FibrePanel::change(const QString& undo, const std::string& where, const std::function<void(Material&)>& work)
{
    if (!own()) { return; }
    const auto index = static_cast<std::size_t>(own() - form_.document().design()->materials.data());
    form_.document().endStroke();
    form_.document().edit(undo, where, [&](Design& design) { work(design.materials[index]); });
    form_.document().endStroke();
}

FormOwner<Material> FibrePanel::row()
{
    return {[this] { return path(""); }, [this] { return own(); },
            [this](Design& design, const std::function<void(Material&)>& work) {
                if (own()) { work(design.materials[static_cast<std::size_t>(own() - form_.document().design()->materials.data())]); }
            },
            tr("fibre's")};
}

/// Shapes by name, and the one number by which they act.
void FibrePanel::addCrossSection()
{
    shape_ = new QComboBox;
    for (const CrossSection& shape : cross_sections()) { shape_->addItem(coreWord(shape.shape), QString::fromStdString(shape.shape)); }
    shape_->addItem(tr("own perimeter"), QString());
    const QString acts = tr("Acts in the closure “pores” only.");
    shape_->setToolTip("<p>" + tr("A fibre of more surface draws water in more strongly.") + " " + acts + "</p>");
    form_.addRow(tr("Cross-section"), shape_, [this] { return path("cross_section"); });
    connect(shape_, &QComboBox::activated, this, [this](int index) {
        change(tr("cross-section"), path("cross_section"), [&](Material& fibre) {
            fibre.cross_section = index < static_cast<int>(cross_sections().size())
                                      ? cross_sections()[static_cast<std::size_t>(index)]
                                      : CrossSection{fibre.cross_section.perimeter_factor, {}};
        });
        if (index == static_cast<int>(cross_sections().size())) { fields_.front()->setFocus(Qt::OtherFocusReason); }
    });
    DesignField perimeter{tr("Perimeter ratio"),
                          tr("perimeter of the fibre"),
                          [this] { return path("cross_section"); },
                          [this] { return own() ? std::optional(own()->cross_section.perimeter_factor) : std::nullopt; },
                          [this](Design& design, std::optional<double> value) {
                              if (own() && value) {
                                  const auto index = static_cast<std::size_t>(own() - form_.document().design()->materials.data());
                                  design.materials[index].cross_section = {*value, {}};
                              }
                          },
                          tr("Of the cross-section, over that of a circle of the same area; deep-grooved fibres reach 2.5 to 3.") + " " +
                              acts};
    fields_.push_back(form_.addQuantity(Quantity::fraction(1, 3), perimeter));
    for (const char* key : {"fibre_radius_um", "density_kg_m3"}) { fields_.push_back(form_.addNumber(row(), key)); }
}

void FibrePanel::addWetting()
{
    fields_.push_back(form_.addNumber(row(), "contact_angle_deg"));
    receding_ = form_.addNumber(row(), "receding_angle_deg");
    fields_.push_back(receding_);
}

void FibrePanel::addSorption()
{
    for (const char* key : {"standard_regain", "saturation_regain"}) { fields_.push_back(form_.addNumber(row(), key)); }
    isotherm_ = new QComboBox;
    isotherm_->addItems({tr("as the fibre it is based on"), tr("master curve")});
    isotherm_->setToolTip("<p>" + tr("Regain over relative humidity. The master curve goes through the standard regain.") + "</p>");
    form_.addRow(tr("Isotherm"), isotherm_, [this] { return path("isotherm"); });
    connect(isotherm_, &QComboBox::activated, this, &FibrePanel::chooseIsotherm);
}

int FibrePanel::isothermRow() const
{
    if (!own()) { return -1; }
    if (!own()->gab.given()) { return master_curve; }
    const Material* base = find_library_material(own()->based_on);
    return base && base->gab == own()->gab ? as_base : own_numbers;
}

void FibrePanel::chooseIsotherm(int row)
{
    if (row == isothermRow() || row == own_numbers) { return; }
    const Material* base = own() ? find_library_material(own()->based_on) : nullptr;
    change(tr("isotherm"), path("isotherm"), [&](Material& fibre) { fibre.gab = row == as_base && base ? base->gab : GabIsotherm{}; });
}

void FibrePanel::refreshIsotherm()
{
    const int row = isothermRow();
    const Material* base = own() ? find_library_material(own()->based_on) : nullptr;
    isotherm_->setEnabled(own() && (own()->gab.given() || (base && base->gab.given())));
    if (isotherm_->count() > own_numbers) { isotherm_->removeItem(own_numbers); }
    if (row == own_numbers) { isotherm_->addItem(tr("own numbers")); }
    isotherm_->setCurrentIndex(row);
}

void FibrePanel::addHeat()
{
    for (const char* key : {"thermal_conductivity_w_mk", "specific_heat_j_kgk", "heat_of_wetting_j_g"}) {
        fields_.push_back(form_.addNumber(row(), key));
    }
}

QStringList FibrePanel::usersOf(const std::string& fibre) const
{
    QStringList names;
    for (const Fabric& fabric : form_.document().design()->fabrics) {
        const auto of = [&fibre](const Yarn& yarn) {
            const auto all = materials_in(yarn);
            return std::find(all.begin(), all.end(), fibre) != all.end();
        };
        if (of(fabric.warp) || of(fabric.weft) || std::any_of(fabric.extra_yarns.begin(), fabric.extra_yarns.end(), of)) {
            names << tr("“%1”").arg(QString::fromStdString(fabric.name));
        }
    }
    return names;
}

void FibrePanel::refresh()
{
    const auto& fibres = form_.document().design()->materials;
    own_->clear();
    for (const Material& fibre : fibres) { own_->addItem(QString::fromStdString(fibre.name)); }
    own_->setCurrentIndex(own() ? static_cast<int>(own() - fibres.data()) : -1);
    for (QWidget* widget : std::initializer_list<QWidget*>{own_, duplicate_, rename_, remove_, shape_}) { widget->setEnabled(own()); }
    for (QWidget* widget : fields_) { widget->setEnabled(own()); }
    refreshIsotherm();
    refreshShape();
    receding_->setDerived(own() ? std::optional(receding_angle_under(*own(), own()->contact_angle_deg)) : std::nullopt);
    if (!own()) {
        about_->setText(tr("None yet. “Own…” beside the fibre of a yarn makes one of it."));
        return;
    }
    const QStringList users = usersOf(own()->name);
    const QString used = users.isEmpty() ? tr("No fabric uses it.") : tr("Used by %1.").arg(users.join(", "));
    about_->setText(own()->based_on.empty() ? used : tr("Based on %1. %2").arg(coreWord(own()->based_on), used));
}

void FibrePanel::refreshShape()
{
    int row = -1;
    if (own()) {
        row = static_cast<int>(cross_sections().size());
        for (int i = 0; i < row; ++i) {
            if (own()->cross_section.shape == cross_sections()[static_cast<std::size_t>(i)].shape) { row = i; }
        }
        // A library's fibre gives no shape: it is round.
        if (own()->cross_section == CrossSection{}) { row = 0; }
    }
    shape_->setCurrentIndex(row);
}

void FibrePanel::choose(int fibre)
{
    section_.open();
    fibre_ = fibre;
    form_.refresh();
}

void FibrePanel::startEditing() { form_.showField(path("cross_section")); }

void FibrePanel::duplicateFibre()
{
    if (!own()) { return; }
    Document& document = form_.document();
    Material made = *own();
    made.name = freeFibreName(*document.design(), made.name);
    document.endStroke();
    document.edit(tr("duplicate fibre"), {}, [&](Design& design) { design.materials.push_back(made); });
    choose(static_cast<int>(document.design()->materials.size()) - 1);
}

QString FibrePanel::whyNotNamed(const QString& name) const
{
    const std::string wanted = name.trimmed().toStdString();
    if (!own() || wanted.empty()) { return tr("A fibre needs a name."); }
    const bool taken = wanted != own()->name && find_material(*form_.document().design(), wanted);
    return taken ? tr("A fibre “%1” already exists. Choose another name.").arg(name.trimmed()) : QString();
}

bool FibrePanel::rename(const QString& name, QString* why)
{
    *why = whyNotNamed(name);
    if (!why->isEmpty()) { return false; }
    const std::string wanted = name.trimmed().toStdString(), old = own()->name;
    if (wanted == old) { return true; }
    Document& document = form_.document();
    const auto index = static_cast<std::size_t>(own() - document.design()->materials.data());
    document.endStroke();
    document.edit(tr("rename fibre"), {}, [&](Design& design) {
        design.materials[index].name = wanted;
        eachName(design, [&](std::string& used) { used = used == old ? wanted : used; });
    });
    return true;
}

void FibrePanel::removeFibre()
{
    if (!own()) { return; }
    Document& document = form_.document();
    const std::string name = own()->name, other = instead(*own());
    const auto index = own() - document.design()->materials.data();
    document.endStroke();
    document.edit(tr("delete fibre"), {}, [&](Design& design) {
        design.materials.erase(design.materials.begin() + index);
        if (!find_material(design, name)) {
            eachName(design, [&](std::string& used) { used = used == name ? other : used; });
        }
    });
}

void FibrePanel::askName()
{
    if (!own()) { return; }
    NameDialog dialog(
        tr("Rename fibre"), QString::fromStdString(own()->name), [this](const QString& name) { return whyNotNamed(name); }, window_);
    QString why;
    if (dialog.exec() == QDialog::Accepted) { rename(dialog.name(), &why); }
}

void FibrePanel::askRemoval()
{
    const QStringList users = own() ? usersOf(own()->name) : QStringList();
    if (!users.isEmpty()) {
        const QString name = QString::fromStdString(own()->name);
        if (!confirm(window_, tr("Delete fibre"), tr("Delete “%1”?").arg(name),
                     tr("“%1” is used by %2. They will use %3 instead.").arg(name, users.join(", "), coreWord(instead(*own()))),
                     tr("Delete"))) {
            return;
        }
    }
    removeFibre();
}

} // namespace hygroloom
