// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/garment_edits.h"

#include "core/base/words.h"
#include "core/project/library.h"
#include "ui/basics/words.h"
#include "ui/document/sources.h"

#include <QFileInfo>

#include <algorithm>

namespace hygroloom {

namespace {

void pushWear(Design& design, const std::string& garment, const Climate* climate)
{
    WearExperiment wear;
    wear.garment = garment;
    if (climate) { wear.climate = *climate; }
    wear.name = free_name("wear", [&design](const std::string& name) {
        return find_wear(design, name) != nullptr || find_experiment(design, name) != nullptr;
    });
    design.wears.push_back(std::move(wear));
}

int add(Document& document, Garment garment)
{
    const Experiment* experiment = document.experiment();
    const std::optional<Climate> climate = experiment ? std::optional(experiment->climate) : std::nullopt;
    document.edit(tr("add %1").arg(QString::fromStdString(garment.name)), {}, [&](Design& design) {
        if (design.fabrics.empty()) { add_preset(design, shipped_presets().front()); }
        garment.panels["*"].fabric = design.fabrics.front().name;
        garment.name = free_name(garment.name, [&design](const std::string& name) { return find_garment(design, name) != nullptr; });
        design.garments.push_back(garment);
        pushWear(design, garment.name, climate ? &*climate : nullptr);
    });
    document.endStroke();
    return static_cast<int>(document.design()->garments.size()) - 1;
}

} // namespace

int addBuiltInGarment(Document& document, const std::string& kind)
{
    Garment garment;
    garment.built_in = standard_garment(kind);
    garment.name = kind;
    return add(document, std::move(garment));
}

int addGarmentFile(Document& document, const QString& path)
{
    Garment garment;
    const QFileInfo file(path);
    garment.source = sourceFrom(document.folder(), path).toStdString();
    garment.name = file.completeBaseName().toStdString();
    return add(document, std::move(garment));
}

void removeGarment(Document& document, int garment)
{
    if (garment < 0 || garment >= static_cast<int>(document.design()->garments.size())) { return; }
    document.edit(tr("remove garment"), {}, [garment](Design& design) {
        const auto at = design.garments.begin() + garment;
        std::erase_if(design.wears, [name = at->name](const WearExperiment& wear) { return wear.garment == name; });
        design.garments.erase(at);
    });
    document.endStroke();
}

QString whyNotGarmentName(const Design& design, int garment, const QString& name)
{
    const QString wish = name.trimmed();
    if (wish.isEmpty()) { return tr("A garment needs a name."); }
    const Garment* other = find_garment(design, wish.toStdString());
    const bool taken = other && other != &design.garments[static_cast<std::size_t>(garment)];
    return taken ? tr("A garment “%1” already exists. Choose another name.").arg(wish) : QString();
}

QString whyNotWearName(const Design& design, int wear, const QString& name)
{
    const QString wish = name.trimmed();
    if (wish.isEmpty()) { return tr("An experiment needs a name."); }
    const WearExperiment* other = find_wear(design, wish.toStdString());
    const bool taken = find_experiment(design, wish.toStdString()) || (other && other != &design.wears[static_cast<std::size_t>(wear)]);
    return taken ? tr("An experiment “%1” already exists. Choose another name.").arg(wish) : QString();
}

void renameGarment(Document& document, int garment, const QString& name)
{
    const std::string wish = name.trimmed().toStdString();
    const Design& now = *document.design();
    if (garment < 0 || garment >= static_cast<int>(now.garments.size()) || !whyNotGarmentName(now, garment, name).isEmpty() ||
        now.garments[static_cast<std::size_t>(garment)].name == wish) {
        return;
    }
    document.edit(tr("rename garment"), {}, [&](Design& design) {
        std::string& own = design.garments[static_cast<std::size_t>(garment)].name;
        for (WearExperiment& wear : design.wears) {
            if (wear.garment == own) { wear.garment = wish; }
        }
        own = wish;
    });
    document.endStroke();
}

void renameWear(Document& document, int wear, const QString& name)
{
    const std::string wish = name.trimmed().toStdString();
    const Design& now = *document.design();
    if (wear < 0 || wear >= static_cast<int>(now.wears.size()) || !whyNotWearName(now, wear, name).isEmpty() ||
        now.wears[static_cast<std::size_t>(wear)].name == wish) {
        return;
    }
    editWear(document, tr("rename wear experiment"), wear, {}, [&](WearExperiment& edited) { edited.name = wish; });
}

void editGarment(Document& document, const QString& text, int garment, const std::string& field,
                 const std::function<void(Garment&)>& change)
{
    if (garment < 0 || garment >= static_cast<int>(document.design()->garments.size())) { return; }
    document.edit(text, field.empty() ? field : "garments[" + std::to_string(garment) + "]." + field,
                  [&](Design& design) { change(design.garments[static_cast<std::size_t>(garment)]); });
    if (field.empty()) { document.endStroke(); }
}

void editCut(Document& document, const QString& text, int garment, const std::string& panel, const std::string& field,
             const std::function<void(PanelCut&)>& change)
{
    editGarment(document, text, garment, field.empty() ? field : "panels." + panel + "." + field, [&](Garment& edited) {
        const PanelCut* before = edited.cut_of(panel);
        PanelCut cut = before ? *before : PanelCut{};
        change(cut);
        edited.panels[panel] = cut;
    });
}

void cutAllFrom(Document& document, int garment, const std::string& fabric)
{
    editGarment(document, tr("cut all panels from %1").arg(QString::fromStdString(fabric)), garment, {},
                [&](Garment& edited) { cut_all_from(edited, fabric); });
}

void setGap(Garment& garment, const std::string& zone, std::optional<double> gap_mm)
{
    if (gap_mm) {
        garment.wearer.gap_mm[zone] = *gap_mm;
    } else {
        garment.wearer.gap_mm.erase(zone);
    }
}

std::string seamKey(const Garment& garment, const std::string& one, const std::string& other)
{
    if (one.empty()) { return "default"; }
    const std::string turned = other + "|" + one;
    return garment.seams.contains(turned) ? turned : one + "|" + other;
}

void setSeam(Garment& garment, const std::string& one, const std::string& other, std::optional<double> share)
{
    const std::string key = seamKey(garment, one, other);
    if (share) {
        garment.seams[key] = *share;
    } else {
        garment.seams.erase(key);
    }
}

QString whyNotZoneName(const Garment& garment, int zone, const QString& name)
{
    const std::string wish = name.trimmed().toStdString();
    const auto& body = gap_zones();
    const auto& own = garment.wearer.own_zones;
    if (wish.empty()) { return tr("A zone needs a name."); }
    if (wish == "default" || std::find(body.begin(), body.end(), wish) != body.end()) {
        return tr("“%1” is a zone of the body. Choose another name.").arg(name.trimmed());
    }
    for (std::size_t k = 0; k < own.size(); ++k) {
        if (own[k].name == wish && static_cast<int>(k) != zone) {
            return tr("A zone “%1” already exists. Choose another name.").arg(name.trimmed());
        }
    }
    return {};
}

int addOwnZone(Document& document, int garment, const std::string& panel, const std::vector<std::array<double, 2>>& outline_mm)
{
    constexpr double usual_rate = 842; // g/m2h, of the chest at exercise: resources/body
    editGarment(document, tr("draw a zone"), garment, {}, [&](Garment& edited) {
        std::vector<OwnZone>& zones = edited.wearer.own_zones;
        const std::string name = free_name("zone", [&zones](const std::string& wish) {
            return std::any_of(zones.begin(), zones.end(), [&wish](const OwnZone& zone) { return zone.name == wish; });
        });
        zones.push_back({name, panel, outline_mm, usual_rate});
    });
    return static_cast<int>(document.design()->garments[static_cast<std::size_t>(garment)].wearer.own_zones.size()) - 1;
}

void removeOwnZone(Document& document, int garment, int zone)
{
    const auto& garments = document.design()->garments;
    if (garment < 0 || garment >= static_cast<int>(garments.size()) || zone < 0 ||
        zone >= static_cast<int>(garments[static_cast<std::size_t>(garment)].wearer.own_zones.size())) {
        return;
    }
    editGarment(document, tr("delete zone"), garment, {},
                [zone](Garment& edited) { edited.wearer.own_zones.erase(edited.wearer.own_zones.begin() + zone); });
}

void editOwnZone(Document& document, const QString& text, int garment, int zone, const std::string& field,
                 const std::function<void(OwnZone&)>& change)
{
    editGarment(document, text, garment, field.empty() ? field : "wearer.own_zones[" + std::to_string(zone) + "]." + field,
                [&](Garment& edited) {
                    if (zone >= 0 && zone < static_cast<int>(edited.wearer.own_zones.size())) {
                        change(edited.wearer.own_zones[static_cast<std::size_t>(zone)]);
                    }
                });
}

int addWear(Document& document, const std::string& garment)
{
    const Experiment* experiment = document.experiment();
    const std::optional<Climate> climate = experiment ? std::optional(experiment->climate) : std::nullopt;
    document.edit(tr("add wear experiment"), {}, [&](Design& design) { pushWear(design, garment, climate ? &*climate : nullptr); });
    document.endStroke();
    return static_cast<int>(document.design()->wears.size()) - 1;
}

void removeWear(Document& document, int wear)
{
    if (wear < 0 || wear >= static_cast<int>(document.design()->wears.size())) { return; }
    document.edit(tr("remove wear experiment"), {}, [wear](Design& design) { design.wears.erase(design.wears.begin() + wear); });
    document.endStroke();
}

void editWear(Document& document, const QString& text, int wear, const std::string& field,
              const std::function<void(WearExperiment&)>& change)
{
    if (wear < 0 || wear >= static_cast<int>(document.design()->wears.size())) { return; }
    document.edit(text, field.empty() ? field : "wears[" + std::to_string(wear) + "]." + field,
                  [&](Design& design) { change(design.wears[static_cast<std::size_t>(wear)]); });
    if (field.empty()) { document.endStroke(); }
}

} // namespace hygroloom
