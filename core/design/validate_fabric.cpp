// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A fabric's fields one by one, then whether its yarns fit in it.
#include "core/base/units.h"
#include "core/design/issue_list.h"
#include "core/design/yarn_sections.h"

#include "core/design/fabric_quantities.h"

namespace hygroloom {

namespace {

// From bulky spun yarns to tight filaments. Only a guard against a diameter and a count that were not meant for each other.
constexpr double loosest_usual_packing = 0.3, densest_usual_packing = 0.85;

void require_material(const Design& design, const std::string& name, const Place& at, IssueList& list)
{
    if (find_material(design, name)) return;
    std::vector<std::string> known = names_in(design.materials);
    for (const std::string& shipped : names_in(material_library())) known.push_back(shipped);
    list.error("unknown_material", at, say("There is no material \"{}\"{} Known are: {}.", name, or_near(name, known), listed(known)));
}

bool validate_core(const Design& design, const Yarn& yarn, const Place& where, IssueList& list)
{
    if (!yarn.core) return true;
    const int before = list.errors();
    require_material(design, yarn.core->material, where / "material", list);
    list.fields(where, *yarn.core);
    return list.errors() == before;
}

bool validate_blend(const Design& design, const Yarn& yarn, const Place& where, IssueList& list)
{
    const int before = list.errors();
    if (yarn.material.empty()) list.error("no_material", where, say("The yarn has no material; give a name or a blend."));
    double sum = 0;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < yarn.material.size(); ++i) {
        const MaterialShare& part = yarn.material[i];
        const Place at = yarn.material.size() == 1 ? where : where / i;
        require_material(design, part.name, at, list);
        if (!seen.insert(part.name).second) list.error("duplicate_name", at, say("The blend names \"{}\" twice.", part.name));
        if (!(part.share > 0 && part.share <= 1))
            list.error("range", at / "share", say("A share must be more than 0 and at most 1; given is {}.", part.share));
        sum += part.share;
    }
    if (list.errors() == before && !(std::abs(sum - 1) <= 1e-6))
        list.error("shares", where, say("The shares of the blend must sum to 1; they sum to {}.", sum));
    return list.errors() == before;
}

void validate_plies(const Yarn& yarn, const Place& where, IssueList& list)
{
    if (yarn.yarn_class == YarnClass::monofilament && (yarn.filament_count || yarn.plies > 1))
        list.error("range", where / (yarn.filament_count ? "filament_count" : "plies"),
                   say("A monofilament is one filament, without filament_count and of one ply."));
    if (yarn.plies > yarn.fibres_per_yarn)
        list.error("range", where / "fibres_per_yarn",
                   say("{} drawn fibres do not fill {} plies; give at least one for each.", yarn.fibres_per_yarn, yarn.plies));
}

void validate_yarn(const Design& design, const Yarn& yarn, const Place& where, IssueList& list)
{
    bool sound = validate_blend(design, yarn, where / "material", list);
    sound = validate_core(design, yarn, where / "core", list) && sound;
    const int before = list.errors();
    list.fields(where, yarn);
    if (!yarn.diameter_mm && !yarn.linear_density_tex)
        list.error("no_size", where, say("The yarn needs a count or a diameter (count, linear_density_tex, diameter_mm); none is given."));
    validate_plies(yarn, where, list);

    sound = sound && list.errors() == before;
    for (const std::string& name : materials_in(yarn)) {
        // A material's own fault is reported at the material; here it only stops the arithmetic.
        const Material* material = find_material(design, name);
        sound = sound && material && material->density_kg_m3 >= 500 && material->density_kg_m3 <= 3000;
    }
    if (!sound || !yarn.diameter_mm) {
        if (sound) { // from tex: the diameter must be one that could have been given
            const FreeYarn free = free_yarn(design, yarn);
            list.range(where / "linear_density_tex", say("diameter that follows from the linear density"), free.diameter, 0.005, 10,
                       Stored::mm);
        }
        return;
    }
    const double density = yarn_substance(design, yarn).density_kg_m3;
    const double solid = density * 0.25 * pi * *yarn.diameter_mm * *yarn.diameter_mm; // tex without pores
    if (!yarn.linear_density_tex) return;
    const double packing = *yarn.linear_density_tex / solid;
    if (yarn.packing_factor) {
        if (std::abs(packing / *yarn.packing_factor - 1) > 0.01)
            list.error("yarn_disagrees", where,
                       say("Diameter {:.4g} and packing factor {:.4g} make {:.4g} of this fibre ({:.0f} kg/m3), but "
                           "linear_density_tex says {:.4g}. "
                           "They must agree within 1 %; leave one out.",
                           Amount{*yarn.diameter_mm, Stored::mm}, *yarn.packing_factor, Amount{*yarn.packing_factor * solid, Stored::tex},
                           density, Bare{*yarn.linear_density_tex, Stored::tex}));
    } else if (packing < loosest_packing || packing > densest_packing) {
        list.error("yarn_disagrees", where,
                   say("{:.4g} of this fibre ({:.0f} kg/m3) in a diameter of {:.4g} is a packing factor of {:.3g}; it must "
                       "be from {} to {}.",
                       Amount{*yarn.linear_density_tex, Stored::tex}, density, Amount{*yarn.diameter_mm, Stored::mm}, packing,
                       loosest_packing, densest_packing));
    } else if (packing < loosest_usual_packing || packing > densest_usual_packing) {
        list.add(Severity::warning, "odd_packing", where,
                 say("{:.4g} of this fibre in a diameter of {:.3g} is a packing factor of {:.3g}; usual yarns are packed to {} to {}. "
                     "Leave the diameter or the linear density empty, and it is calculated.",
                     Amount{*yarn.linear_density_tex, Stored::tex}, Amount{*yarn.diameter_mm, Stored::mm}, packing, loosest_usual_packing,
                     densest_usual_packing));
    }
}

void validate_order(const Fabric& fabric, const std::vector<YarnRun>& order, const Place& where, IssueList& list)
{
    double threads = 0;
    const int before = list.errors();
    for (std::size_t i = 0; i < order.size() && list.errors() == before; ++i) {
        const Place at = where / i;
        list.range(at / "yarn", say("number of the yarn (0: the fabric's own, then extra_yarns from 1)"), order[i].yarn, 0,
                   static_cast<double>(fabric.extra_yarns.size()));
        list.range(at / "count", say("number of threads in a run"), order[i].count, 1, largest_yarn_order);
        threads += order[i].count;
    }
    if (threads > largest_yarn_order)
        list.error("range", where, say("One period of the order may have up to {} threads; it has {}.", largest_yarn_order, threads));
}

void validate_extra_yarns(const Design& design, const Fabric& fabric, const Place& where, IssueList& list)
{
    const auto& yarns = fabric.extra_yarns;
    if (yarns.size() > most_extra_yarns)
        list.error("range", where, say("A fabric may have up to {} extra yarns; given are {}.", most_extra_yarns, yarns.size()));
    for (std::size_t i = 0; i < yarns.size() && i < most_extra_yarns; ++i) validate_yarn(design, yarns[i], where / i, list);
}

/// Where round fibres touch all round, no liquid passes between them (Gebart 1992).
void warn_of_closed_yarns(const FittedFabric& fabric, const Place& where, IssueList& list)
{
    const double scale = fabric.fibre_scale;
    for (bool warp : {true, false}) {
        const auto& yarns = warp ? fabric.yarns.warp : fabric.yarns.weft;
        const auto& numbers = (warp ? fabric.yarns.warp_order : fabric.yarns.weft_order).yarns;
        for (std::size_t i = 0; i < yarns.size(); ++i) {
            const double packing = scale * yarns[i].packing_factor;
            if (packing < closest_round_fibres || yarns[i].yarn_class == YarnClass::monofilament) continue;
            const Place yarn =
                numbers[i] > 0 ? where / "extra_yarns" / static_cast<std::size_t>(numbers[i] - 1) : where / (warp ? "warp" : "weft");
            list.add(Severity::warning, "closed_yarns", yarn / "packing_factor",
                     say("Packed to {:.4g}, fibres touch all round (round ones from {:.4g}): liquid wicks along such yarns, but they "
                         "neither absorb through their surface nor pass liquid on where they cross others.",
                         packing, closest_round_fibres));
            break;
        }
    }
}

/// A count of filaments says how thick they are, whatever the material's own radius is.
void validate_filaments(const Design& design, const Yarn& yarn, const Place& where, IssueList& list)
{
    if (!yarn.filament_count) return;
    const Material fibre = blended_material(design, yarn.material);
    const double tex = (1 - (yarn.core ? yarn.core->share : 0)) * free_yarn(design, yarn).linear_density_tex;
    const double radius = filament_radius_um(tex, *yarn.filament_count, fibre.density_kg_m3);
    if (!list.range(where / "filament_count", say("radius of a fibre that follows from the number of filaments"), radius,
                    least_fibre_radius_um, most_fibre_radius_um, Stored::um))
        return;
    if (std::abs(radius / fibre.fibre_radius_um - 1) > 0.01)
        list.add(Severity::note, "filaments", where / "filament_count",
                 say("{:.4g} of {} filaments ({:.0f} kg/m3) make a fibre radius of {:.3g}, which counts; that of {} is {:.3g} "
                     "and is left aside.",
                     Amount{tex, Stored::tex}, *yarn.filament_count, fibre.density_kg_m3, Amount{radius, Stored::um}, fibre.name,
                     Amount{fibre.fibre_radius_um, Stored::um}));
}

/// Whether yarns can be fitted at all.
bool can_be_fitted(const Design& design, const Fabric& fabric, const Place& where, IssueList& list)
{
    for (bool warp : {true, false}) {
        const std::size_t types = yarn_order(fabric, warp).yarns.size();
        if (types <= most_yarn_types) continue;
        list.error("range", where / (warp ? "warp_order" : "weft_order"),
                   say("The order has {} different yarns, colours apart; {} is the most.", types, most_yarn_types));
        return false;
    }
    double thickest[2] = {};
    for (bool warp : {true, false})
        for (int number : yarn_order(fabric, warp).yarns) {
            const Yarn& yarn = yarn_in(fabric, warp, number);
            thickest[warp] = std::max(thickest[warp], free_yarn(design, yarn).diameter);
        }
    if (fabric.thickness_mm && *fabric.thickness_mm - 2 * fabric.flyaway.loop_height_mm < 0.1 * (thickest[true] + thickest[false])) {
        list.error("thickness_too_small", where / "thickness_mm",
                   say("A thickness of {:.4g} less loops of {:.4g} on both faces leaves {:.3g} for yarns of {:.3g} and "
                       "{:.3g}; a tenth of their sum is the least.",
                       Amount{*fabric.thickness_mm, Stored::mm}, Amount{fabric.flyaway.loop_height_mm, Stored::mm},
                       Amount{*fabric.thickness_mm - 2 * fabric.flyaway.loop_height_mm, Stored::mm}, Bare{thickest[true], Stored::mm},
                       Amount{thickest[false], Stored::mm}));
        return false;
    }
    return true;
}

void validate_fit(const Fabric& fabric, const FittedYarns& fitted, const Place& where, IssueList& list)
{
    const auto check = [&](Message name, const char* key, double sett, const FittedYarn& yarn) {
        if (!yarn.too_dense()) return;
        list.error("ends_do_not_fit", where / key,
                   say("{:.4g} {} do not fit: a yarn of {:.3g} ({:.3g}) has {:.2g} x {:.2g} of room; the packing would be {:.3g}, the "
                       "limit is {}. Lower the sett, or give a finer yarn or more thickness.",
                       Bare{sett, Stored::per_cm}, std::move(name), Amount{yarn.free.diameter, Stored::mm},
                       Amount{yarn.free.linear_density_tex, Stored::tex}, Bare{yarn.section.width, Stored::mm},
                       Amount{yarn.section.height, Stored::mm}, yarn.packing_factor, yarn.most_packing()));
    };
    const auto name = [](Message threads, int yarn) {
        const UnitAlone per_cm{Stored::per_cm};
        return yarn > 0 ? say("{}{} of yarn {} (extra yarn {})", threads, per_cm, letters_of(yarn), yarn) : say("{}{}", threads, per_cm);
    };
    for (std::size_t i = 0; i < fitted.warp.size(); ++i)
        check(name(say("ends"), fitted.warp_order.yarns[i]), "ends_per_cm", fabric.ends_per_cm, fitted.warp[i]);
    for (std::size_t i = 0; i < fitted.weft.size(); ++i)
        check(name(say("picks"), fitted.weft_order.yarns[i]), "picks_per_cm", fabric.picks_per_cm, fitted.weft[i]);
    validate_sett(fabric, fitted, where, list);
}

/// Whether the yarns can hold as much fibre as the laboratory's values ask for.
void validate_fibre_scale(const Fabric& fabric, const FittedFabric& fitted, const Place& where, IssueList& list)
{
    const double scale = fitted.fibre_scale;
    if (scale == 1) return;
    double loosest = 1, densest = 0, most = densest_squeezed;
    bool too_dense = false;
    for (const auto* yarns : {&fitted.yarns.warp, &fitted.yarns.weft})
        for (const FittedYarn& yarn : *yarns) {
            loosest = std::min(loosest, scale * yarn.packing_factor);
            densest = std::max(densest, scale * yarn.packing_factor);
            if (yarn.too_dense(scale)) most = yarn.most_packing();
            too_dense = too_dense || yarn.too_dense(scale);
        }
    const Place key = where / (fabric.measured.areal_density_g_m2 ? "areal_density_g_m2" : "porosity");
    if (too_dense || loosest < loosest_packing)
        list.error("measured_disagrees", key,
                   say("The laboratory's value means yarns packed from {:.3g} to {:.3g}; the sections that follow from sett, thickness "
                       "and diameters can hold from {} to {}. Derived are {:.4g} g/m2.",
                       loosest, densest, loosest_packing, most, fitted.measured.areal_density_g_m2 / scale));
    if (fabric.measured.areal_density_g_m2 && fabric.measured.porosity) {
        Measured weighed = fabric.measured;
        weighed.porosity.reset();
        const double meant = with_measured(quantities_of(fabric, fitted.yarns), weighed).porosity;
        if (std::abs(meant - *fabric.measured.porosity) > 0.05)
            list.add(
                Severity::warning, "measured_disagrees", where / "porosity",
                say("The areal density means a porosity of {:.3g}; given is {:.3g}. The areal density decides how much fibre there is.",
                    meant, *fabric.measured.porosity));
    }
}

void note_wicking(const Design& design, const Fabric& fabric, const Place& where, IssueList& list)
{
    const auto note = [&](const Place& at, double angle) {
        if (angle >= 90)
            list.add(Severity::note, "no_wicking", at,
                     say("At a contact angle of {:.3g} degrees water does not wick into the yarns; it wicks below 90.", angle));
    };
    if (fabric.contact_angle_deg) {
        note(where / "contact_angle_deg", *fabric.contact_angle_deg);
        return;
    }
    note(where / "warp" / "material", blended_material(design, fabric.warp.material).contact_angle_deg);
    note(where / "weft" / "material", blended_material(design, fabric.weft.material).contact_angle_deg);
    for (std::size_t i = 0; i < fabric.extra_yarns.size(); ++i)
        note(where / "extra_yarns" / i / "material", blended_material(design, fabric.extra_yarns[i].material).contact_angle_deg);
}

} // namespace

std::shared_ptr<const FittedFabric> validate_fabric(const Design& design, const Fabric& fabric, const Place& where, IssueList& list)
{
    const int before = list.errors();
    validate_yarn(design, fabric.warp, where / "warp", list);
    validate_yarn(design, fabric.weft, where / "weft", list);
    validate_weave(fabric, where, list);
    validate_extra_yarns(design, fabric, where / "extra_yarns", list);
    validate_order(fabric, fabric.warp_order, where / "warp_order", list);
    validate_order(fabric, fabric.weft_order, where / "weft_order", list);
    list.fields(where, fabric);
    list.fields(where / "flyaway", fabric.flyaway);
    list.fields(where, fabric.measured);
    list.fields(where / "uncertainty", fabric.uncertainty);
    list.fields(where / "loom", fabric.loom);
    if (fabric.calibrated)
        list.range(where / "calibrated" / "residual_rms", say("residual of a calibration"), fabric.calibrated->residual_rms, 0, 1e9);

    // The arithmetic needs sound numbers, those of the materials included.
    std::vector<const Yarn*> yarns{&fabric.warp, &fabric.weft};
    for (const Yarn& yarn : fabric.extra_yarns) yarns.push_back(&yarn);
    for (const Yarn* yarn : yarns)
        for (const std::string& name : materials_in(*yarn)) {
            const Material* material = find_material(design, name);
            if (!material) return nullptr;
            IssueList own;
            validate_material(*material, {}, own);
            if (own.errors() > 0) return nullptr;
        }
    if (list.errors() > before) return nullptr;
    validate_filaments(design, fabric.warp, where / "warp", list);
    validate_filaments(design, fabric.weft, where / "weft", list);
    for (std::size_t i = 0; i < fabric.extra_yarns.size(); ++i)
        validate_filaments(design, fabric.extra_yarns[i], where / "extra_yarns" / i, list);
    if (list.errors() > before || !can_be_fitted(design, fabric, where, list)) return nullptr;
    FittedYarns fit = fit_yarns(design, fabric);
    validate_fit(fabric, fit, where, list);
    if (list.errors() > before) return nullptr;
    auto fitted = std::make_shared<const FittedFabric>(fit_fabric(design, fabric, std::move(fit)));
    validate_fibre_scale(fabric, *fitted, where, list);
    if (list.errors() > before) return nullptr;
    warn_of_closed_yarns(*fitted, where, list);
    note_wicking(design, fabric, where, list);
    for (const Message& note : fitted->derived.notes) list.add(Severity::note, "sections", where, note);
    return fitted;
}

} // namespace hygroloom
