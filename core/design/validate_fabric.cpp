// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A fabric's fields one by one, then whether its yarns fit in it.
#include "core/base/units.h"
#include "core/base/words.h"
#include "core/design/issue_list.h"
#include "core/design/yarn_sections.h"

#include "core/design/fabric_quantities.h"

#include <fmt/ranges.h>

namespace hygroloom {

namespace {

// From bulky spun yarns to tight filaments. Only a guard against a diameter and a count that were not meant for each other.
constexpr double loosest_usual_packing = 0.3, densest_usual_packing = 0.85;

void require_material(const Design& design, const std::string& name, const std::string& at, IssueList& list)
{
    if (find_material(design, name)) return;
    std::vector<std::string> known;
    for (const Material& own : design.materials) known.push_back(own.name);
    for (const Material& shipped : material_library()) known.push_back(shipped.name);
    list.error("unknown_material", at,
               fmt::format("There is no material \"{}\"{} Known are: {}.", name, did_you_mean(name, known), fmt::join(known, ", ")));
}

bool validate_core(const Design& design, const Yarn& yarn, const std::string& where, IssueList& list)
{
    if (!yarn.core) return true;
    const int before = list.errors();
    require_material(design, yarn.core->material, where + ".material", list);
    list.fields(where, *yarn.core);
    return list.errors() == before;
}

bool validate_blend(const Design& design, const Yarn& yarn, const std::string& where, IssueList& list)
{
    const int before = list.errors();
    if (yarn.material.empty()) list.error("no_material", where, "The yarn has no material; give a name or a blend.");
    double sum = 0;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < yarn.material.size(); ++i) {
        const MaterialShare& part = yarn.material[i];
        const std::string at = yarn.material.size() == 1 ? where : fmt::format("{}[{}]", where, i);
        require_material(design, part.name, at, list);
        if (!seen.insert(part.name).second) list.error("duplicate_name", at, fmt::format("The blend names \"{}\" twice.", part.name));
        if (!(part.share > 0 && part.share <= 1))
            list.error("range", at + ".share", fmt::format("A share must be more than 0 and at most 1; given is {}.", part.share));
        sum += part.share;
    }
    if (list.errors() == before && !(std::abs(sum - 1) <= 1e-6))
        list.error("shares", where, fmt::format("The shares of the blend must sum to 1; they sum to {}.", sum));
    return list.errors() == before;
}

void validate_plies(const Yarn& yarn, const std::string& where, IssueList& list)
{
    if (yarn.yarn_class == YarnClass::monofilament && (yarn.filament_count || yarn.plies > 1))
        list.error("range", where + (yarn.filament_count ? ".filament_count" : ".plies"),
                   "A monofilament is one filament, without filament_count and of one ply.");
    if (yarn.plies > yarn.fibres_per_yarn)
        list.error("range", where + ".fibres_per_yarn",
                   fmt::format("{} drawn fibres do not fill {} plies; give at least one for each.", yarn.fibres_per_yarn, yarn.plies));
}

void validate_yarn(const Design& design, const Yarn& yarn, const std::string& where, IssueList& list)
{
    bool sound = validate_blend(design, yarn, where + ".material", list);
    sound = validate_core(design, yarn, where + ".core", list) && sound;
    const int before = list.errors();
    list.fields(where, yarn);
    if (!yarn.diameter_mm && !yarn.linear_density_tex)
        list.error("no_size", where, "The yarn needs a count or a diameter (count, linear_density_tex, diameter_mm); none is given.");
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
            list.range(where + ".linear_density_tex", "diameter that follows from the linear density", free.diameter, 0.005, 10, "mm");
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
                       fmt::format("Diameter {:.4g} mm and packing factor {:.4g} make {:.4g} tex of this fibre ({:.0f} kg/m3), but "
                                   "linear_density_tex says {:.4g}. "
                                   "They must agree within 1 %; leave one out.",
                                   *yarn.diameter_mm, *yarn.packing_factor, *yarn.packing_factor * solid, density,
                                   *yarn.linear_density_tex));
    } else if (packing < loosest_packing || packing > densest_packing) {
        list.error("yarn_disagrees", where,
                   fmt::format("{:.4g} tex of this fibre ({:.0f} kg/m3) in a diameter of {:.4g} mm is a packing factor of {:.3g}; it must "
                               "be from {} to {}.",
                               *yarn.linear_density_tex, density, *yarn.diameter_mm, packing, loosest_packing, densest_packing));
    } else if (packing < loosest_usual_packing || packing > densest_usual_packing) {
        list.add(
            Severity::warning, "odd_packing", where,
            fmt::format(
                "{:.4g} tex of this fibre in a diameter of {:.3g} mm is a packing factor of {:.3g}; usual yarns are packed to {} to {}. "
                "Leave the diameter or the linear density empty, and it is calculated.",
                *yarn.linear_density_tex, *yarn.diameter_mm, packing, loosest_usual_packing, densest_usual_packing));
    }
}

void validate_order(const Fabric& fabric, const std::vector<YarnRun>& order, const std::string& where, IssueList& list)
{
    double threads = 0;
    const int before = list.errors();
    for (std::size_t i = 0; i < order.size() && list.errors() == before; ++i) {
        const std::string at = fmt::format("{}[{}]", where, i);
        list.range(at + ".yarn", "number of the yarn (0: the fabric's own, then extra_yarns from 1)", order[i].yarn, 0,
                   static_cast<double>(fabric.extra_yarns.size()));
        list.range(at + ".count", "number of threads in a run", order[i].count, 1, largest_yarn_order);
        threads += order[i].count;
    }
    if (threads > largest_yarn_order)
        list.error("range", where,
                   fmt::format("One period of the order may have up to {} threads; it has {}.", largest_yarn_order, threads));
}

void validate_extra_yarns(const Design& design, const Fabric& fabric, const std::string& where, IssueList& list)
{
    const auto& yarns = fabric.extra_yarns;
    if (yarns.size() > most_extra_yarns)
        list.error("range", where, fmt::format("A fabric may have up to {} extra yarns; given are {}.", most_extra_yarns, yarns.size()));
    for (std::size_t i = 0; i < yarns.size() && i < most_extra_yarns; ++i)
        validate_yarn(design, yarns[i], fmt::format("{}[{}]", where, i), list);
}

/// Where round fibres touch all round, no liquid passes between them (Gebart 1992).
void warn_of_closed_yarns(const FittedFabric& fabric, const std::string& where, IssueList& list)
{
    const double scale = fabric.fibre_scale;
    for (bool warp : {true, false}) {
        const auto& yarns = warp ? fabric.yarns.warp : fabric.yarns.weft;
        const auto& numbers = (warp ? fabric.yarns.warp_order : fabric.yarns.weft_order).yarns;
        for (std::size_t i = 0; i < yarns.size(); ++i) {
            const double packing = scale * yarns[i].packing_factor;
            if (packing < closest_round_fibres || yarns[i].yarn_class == YarnClass::monofilament) continue;
            const std::string yarn = numbers[i] > 0 ? fmt::format(".extra_yarns[{}]", numbers[i] - 1) : warp ? ".warp" : ".weft";
            list.add(
                Severity::warning, "closed_yarns", where + yarn + ".packing_factor",
                fmt::format("Packed to {:.4g}, fibres touch all round (round ones from {:.4g}): liquid wicks along such yarns, but they "
                            "neither absorb through their surface nor pass liquid on where they cross others.",
                            packing, closest_round_fibres));
            break;
        }
    }
}

/// A count of filaments says how thick they are, whatever the material's own radius is.
void validate_filaments(const Design& design, const Yarn& yarn, const std::string& where, IssueList& list)
{
    if (!yarn.filament_count) return;
    const Material fibre = blended_material(design, yarn.material);
    const double tex = (1 - (yarn.core ? yarn.core->share : 0)) * free_yarn(design, yarn).linear_density_tex;
    const double radius = filament_radius_um(tex, *yarn.filament_count, fibre.density_kg_m3);
    if (!list.range(where + ".filament_count", "radius of a fibre that follows from the number of filaments", radius, least_fibre_radius_um,
                    most_fibre_radius_um, "µm"))
        return;
    if (std::abs(radius / fibre.fibre_radius_um - 1) > 0.01)
        list.add(
            Severity::note, "filaments", where + ".filament_count",
            fmt::format("{:.4g} tex of {} filaments ({:.0f} kg/m3) make a fibre radius of {:.3g} µm, which counts; that of {} is {:.3g} "
                        "µm and is left aside.",
                        tex, *yarn.filament_count, fibre.density_kg_m3, radius, fibre.name, fibre.fibre_radius_um));
}

/// Whether yarns can be fitted at all.
bool can_be_fitted(const Design& design, const Fabric& fabric, const std::string& where, IssueList& list)
{
    for (bool warp : {true, false}) {
        const std::size_t types = yarn_order(fabric, warp).yarns.size();
        if (types <= most_yarn_types) continue;
        list.error("range", where + (warp ? ".warp_order" : ".weft_order"),
                   fmt::format("The order has {} different yarns, colours apart; {} is the most.", types, most_yarn_types));
        return false;
    }
    double thickest[2] = {};
    for (bool warp : {true, false})
        for (int number : yarn_order(fabric, warp).yarns) {
            const Yarn& yarn = yarn_in(fabric, warp, number);
            thickest[warp] = std::max(thickest[warp], free_yarn(design, yarn).diameter);
        }
    if (fabric.thickness_mm && *fabric.thickness_mm - 2 * fabric.flyaway.loop_height_mm < 0.1 * (thickest[true] + thickest[false])) {
        list.error("thickness_too_small", where + ".thickness_mm",
                   fmt::format("A thickness of {:.4g} mm less loops of {:.4g} mm on both faces leaves {:.3g} mm for yarns of {:.3g} and "
                               "{:.3g} mm; a tenth of "
                               "their sum is the least.",
                               *fabric.thickness_mm, fabric.flyaway.loop_height_mm,
                               *fabric.thickness_mm - 2 * fabric.flyaway.loop_height_mm, thickest[true], thickest[false]));
        return false;
    }
    return true;
}

void validate_fit(const Fabric& fabric, const FittedYarns& fitted, const std::string& where, IssueList& list)
{
    const auto check = [&](const std::string& name, const char* key, double sett, const FittedYarn& yarn) {
        if (!yarn.too_dense()) return;
        list.error(
            "ends_do_not_fit", where + "." + key,
            fmt::format(
                "{:.4g} {} do not fit: a yarn of {:.3g} mm ({:.3g} tex) has {:.2g} x {:.2g} mm of room; the packing would be {:.3g}, the "
                "limit is {}. Lower the sett, or give a finer yarn or more thickness.",
                sett, name, yarn.free.diameter, yarn.free.linear_density_tex, yarn.section.width, yarn.section.height, yarn.packing_factor,
                yarn.most_packing()));
    };
    const auto name = [](const char* threads, int yarn) {
        return yarn > 0 ? fmt::format("{}/cm of yarn {} (extra yarn {})", threads, letters_of(yarn), yarn) : fmt::format("{}/cm", threads);
    };
    for (std::size_t i = 0; i < fitted.warp.size(); ++i)
        check(name("ends", fitted.warp_order.yarns[i]), "ends_per_cm", fabric.ends_per_cm, fitted.warp[i]);
    for (std::size_t i = 0; i < fitted.weft.size(); ++i)
        check(name("picks", fitted.weft_order.yarns[i]), "picks_per_cm", fabric.picks_per_cm, fitted.weft[i]);
    validate_sett(fabric, fitted, where, list);
}

/// Whether the yarns can hold as much fibre as the laboratory's values ask for.
void validate_fibre_scale(const Fabric& fabric, const FittedFabric& fitted, const std::string& where, IssueList& list)
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
    const std::string key = where + (fabric.measured.areal_density_g_m2 ? ".areal_density_g_m2" : ".porosity");
    if (too_dense || loosest < loosest_packing)
        list.error(
            "measured_disagrees", key,
            fmt::format("The laboratory's value means yarns packed from {:.3g} to {:.3g}; the sections that follow from sett, thickness "
                        "and diameters can hold from {} to {}. Derived are {:.4g} g/m2.",
                        loosest, densest, loosest_packing, most, fitted.measured.areal_density_g_m2 / scale));
    if (fabric.measured.areal_density_g_m2 && fabric.measured.porosity) {
        Measured weighed = fabric.measured;
        weighed.porosity.reset();
        const double meant = with_measured(quantities_of(fabric, fitted.yarns), weighed).porosity;
        if (std::abs(meant - *fabric.measured.porosity) > 0.05)
            list.add(
                Severity::warning, "measured_disagrees", where + ".porosity",
                fmt::format(
                    "The areal density means a porosity of {:.3g}; given is {:.3g}. The areal density decides how much fibre there is.",
                    meant, *fabric.measured.porosity));
    }
}

void note_wicking(const Design& design, const Fabric& fabric, const std::string& where, IssueList& list)
{
    const auto note = [&](const std::string& at, double angle) {
        if (angle >= 90)
            list.add(Severity::note, "no_wicking", at,
                     fmt::format("At a contact angle of {:.3g} degrees water does not wick into the yarns; it wicks below 90.", angle));
    };
    if (fabric.contact_angle_deg) {
        note(where + ".contact_angle_deg", *fabric.contact_angle_deg);
        return;
    }
    note(where + ".warp.material", blended_material(design, fabric.warp.material).contact_angle_deg);
    note(where + ".weft.material", blended_material(design, fabric.weft.material).contact_angle_deg);
    for (std::size_t i = 0; i < fabric.extra_yarns.size(); ++i)
        note(fmt::format("{}.extra_yarns[{}].material", where, i),
             blended_material(design, fabric.extra_yarns[i].material).contact_angle_deg);
}

} // namespace

std::shared_ptr<const FittedFabric> validate_fabric(const Design& design, const Fabric& fabric, const std::string& where, IssueList& list)
{
    const int before = list.errors();
    validate_yarn(design, fabric.warp, where + ".warp", list);
    validate_yarn(design, fabric.weft, where + ".weft", list);
    validate_weave(fabric, where, list);
    validate_extra_yarns(design, fabric, where + ".extra_yarns", list);
    validate_order(fabric, fabric.warp_order, where + ".warp_order", list);
    validate_order(fabric, fabric.weft_order, where + ".weft_order", list);
    list.fields(where, fabric);
    list.fields(where + ".flyaway", fabric.flyaway);
    list.fields(where, fabric.measured);
    list.fields(where + ".uncertainty", fabric.uncertainty);
    if (fabric.calibrated)
        list.range(where + ".calibrated.residual_rms", "residual of a calibration", fabric.calibrated->residual_rms, 0, 1e9);

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
    validate_filaments(design, fabric.warp, where + ".warp", list);
    validate_filaments(design, fabric.weft, where + ".weft", list);
    for (std::size_t i = 0; i < fabric.extra_yarns.size(); ++i)
        validate_filaments(design, fabric.extra_yarns[i], fmt::format("{}.extra_yarns[{}]", where, i), list);
    if (list.errors() > before || !can_be_fitted(design, fabric, where, list)) return nullptr;
    FittedYarns fit = fit_yarns(design, fabric);
    validate_fit(fabric, fit, where, list);
    if (list.errors() > before) return nullptr;
    auto fitted = std::make_shared<const FittedFabric>(fit_fabric(design, fabric, std::move(fit)));
    validate_fibre_scale(fabric, *fitted, where, list);
    if (list.errors() > before) return nullptr;
    warn_of_closed_yarns(*fitted, where, list);
    note_wicking(design, fabric, where, list);
    for (const std::string& sentence : fitted->derived.notes) list.add(Severity::note, "sections", where, sentence);
    return fitted;
}

} // namespace hygroloom
