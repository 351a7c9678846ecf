// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/fabric_quantities.h"

#include "core/base/units.h"
#include "core/design/flyaway.h"
#include "core/design/yarn_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

YarnQuantities describe(const FittedYarn& fitted, const Fabric& fabric, double sett)
{
    YarnQuantities yarn;
    yarn.linear_density_tex = fitted.free.linear_density_tex;
    yarn.diameter_mm = fitted.free.diameter;
    yarn.packing_factor = fitted.free.packing_factor;
    yarn.section_mm = fitted.section;
    yarn.packing_factor_in_fabric = fitted.packing_factor;
    yarn.pitch_mm = 10 / sett;
    // Void area over wetted perimeter of parallel cylinders, twice.
    yarn.pore_radius_um = fitted.fibre.fibre_radius_um * (1 - fitted.packing_factor) / fitted.packing_factor;
    yarn.contact_angle_deg = fabric.contact_angle_deg.value_or(fitted.fibre.contact_angle_deg);
    yarn.flattened = fitted.flattened || fitted.narrowed;
    return yarn;
}

/// Crimp of a warp (or weft) type over all it crosses, percent.
double crimp_percent(const FittedYarns& fitted, bool warp, std::size_t type, double crossed_pitch, double changes)
{
    const auto& crossed = warp ? fitted.weft : fitted.warp;
    const YarnOrder& order = warp ? fitted.weft_order : fitted.warp_order;
    double sum = 0;
    for (std::size_t other = 0; other < crossed.size(); ++other) {
        const CrossingHeights& heights = warp ? fitted.at(type, other) : fitted.at(other, type);
        const Section& own = (warp ? fitted.warp : fitted.weft)[type].section;
        const Interlacing path = fitted.path(crossed_pitch, own, crossed[other].section, warp ? heights.warp : heights.weft);
        const double crimp = path.length / path.pitch - 1;
        sum += order.share[other] * 100 * (crimp > 1e-9 ? crimp : 0) * changes;
    }
    return sum;
}

/// Mean width of a system's yarns in the fabric, mm: narrower where crossed yarns squeeze them.
double mean_width_of(const FittedYarns& fitted, bool warp, double crossed_pitch, double changes)
{
    const auto &yarns = warp ? fitted.warp : fitted.weft, &crossed = warp ? fitted.weft : fitted.warp;
    const YarnOrder &order = warp ? fitted.warp_order : fitted.weft_order, &other_order = warp ? fitted.weft_order : fitted.warp_order;
    double sum = 0;
    for (std::size_t type = 0; type < yarns.size(); ++type)
        for (std::size_t other = 0; other < crossed.size(); ++other) {
            const CrossingHeights& heights = warp ? fitted.at(type, other) : fitted.at(other, type);
            const Section &own = yarns[type].section, &over = crossed[other].section;
            const Interlacing path = fitted.path(crossed_pitch, own, over, warp ? heights.warp : heights.weft);
            const double bent = mean_width(path, own, over, warp ? heights.weft : heights.warp);
            sum += order.share[type] * other_order.share[other] * (changes * bent + (1 - changes) * own.width);
        }
    return sum;
}

/// Share of the area that no yarn covers: a quarter of a hole between two ends and two picks, whose sides are the yarns' edges.
/// Where yarns keep their width it is (1 - c1)(1 - c2).
double open_share(const FittedYarns& fitted, double warp_pitch, double weft_pitch, double warp_changes, double weft_changes)
{
    constexpr std::size_t steps = 64;
    double open = 0;
    for (std::size_t i = 0; i < fitted.warp.size(); ++i)
        for (std::size_t j = 0; j < fitted.weft.size(); ++j) {
            const Section &a = fitted.warp[i].section, &b = fitted.weft[j].section;
            const CrossingHeights& rise = fitted.at(i, j);
            const auto edges = [](const Interlacing& path, const Section& own, const Section& other, double other_rise) {
                std::vector<double> half;
                for (std::size_t k = 0; k < steps; ++k) {
                    const double x = 0.5 * path.pitch * (static_cast<double>(k) + 0.5) / steps;
                    half.push_back(0.5 * (own.width - own.height + squeezed_height_at(path, own, other, other_rise, x)));
                }
                return half;
            };
            const std::vector<double> warp_bent = edges(fitted.path(weft_pitch, a, b, rise.warp), a, b, rise.weft),
                                      warp_straight(steps, 0.5 * a.width);
            const std::vector<double> weft_bent = edges(fitted.path(warp_pitch, b, a, rise.weft), b, a, rise.warp),
                                      weft_straight(steps, 0.5 * b.width);
            const double dx = 0.5 * warp_pitch / steps, dy = 0.5 * weft_pitch / steps;
            const auto beyond = [](std::size_t cell, double size, double edge) {
                return std::clamp(static_cast<double>(cell) + 1 - edge / size, 0.0, 1.0); // share of a cell past a yarn's edge
            };
            double here = 0;
            for (bool warp_turns : {false, true})
                for (bool weft_turns : {false, true}) {
                    const std::vector<double>&warp = warp_turns ? warp_bent : warp_straight, &weft = weft_turns ? weft_bent : weft_straight;
                    double free = 0;
                    for (std::size_t k = 0; k < steps; ++k)
                        for (std::size_t l = 0; l < steps; ++l) free += beyond(k, dx, warp[l]) * beyond(l, dy, weft[k]);
                    const double likely = (warp_turns ? warp_changes : 1 - warp_changes) * (weft_turns ? weft_changes : 1 - weft_changes);
                    here += likely * free / (steps * steps);
                }
            open += fitted.warp_order.share[i] * fitted.weft_order.share[j] * here;
        }
    return open;
}

/// g/m2 of one system, and the mm of solid fibre they are.
struct SystemMass {
    double areal = 0;
    double solid = 0;
};
SystemMass mass_of(const FittedYarns& fitted, bool warp, double sett, double crossed_pitch, double changes)
{
    SystemMass mass;
    const auto& yarns = warp ? fitted.warp : fitted.weft;
    const YarnOrder& order = warp ? fitted.warp_order : fitted.weft_order;
    for (std::size_t type = 0; type < yarns.size(); ++type) {
        const double crimp = 0.01 * crimp_percent(fitted, warp, type, crossed_pitch, changes);
        const double areal = order.share[type] * sett * yarns[type].free.linear_density_tex * (1 + crimp) / 10; // tex x 1/cm is 0.1 g/m2
        mass.areal += areal;
        mass.solid += areal / yarns[type].fibre.density_kg_m3; // 1 g/m2 over 1 kg/m3 is 1 mm
    }
    return mass;
}

/// Volume of loops and hairs on one system, mm3 per mm2 of fabric. Fibres of plied yarns are taken to lie along the yarn.
double flyaway_volume(const Fabric& fabric, const YarnOrder& order, const std::vector<FittedYarn>& yarns, bool warp, double length_per_mm2)
{
    const Flyaway& flyaway = fabric.flyaway;
    double volume = 0;
    for (std::size_t type = 0; type < yarns.size(); ++type) {
        const Yarn& yarn = yarn_in(fabric, warp, order.yarns[type]);
        const double turns = yarn.plies > 1 ? 0 : 1e-3 * yarn.twist_per_m;
        const double loop = mean_loop_length(flyaway.loop_height_mm, turns, std::sqrt(section_area(yarns[type].section) / pi));
        const double per_mm = flyaway.loop_density_per_mm * loop + flyaway.hair_density_per_mm * flyaway.hair_length_mm;
        const double radius = 1e-3 * yarns[type].fibre.fibre_radius_um;
        volume += order.share[type] * length_per_mm2 * per_mm * pi * radius * radius;
    }
    return volume;
}

void note_section(std::vector<std::string>& notes, const char* name, const FittedYarn& fitted, bool to_fit, double pitch)
{
    const FreeYarn& free = fitted.free;
    const Section& section = fitted.section;
    if (fitted.flattened)
        notes.push_back(fmt::format("The {} yarns, {:.3g} mm across when free, are flattened to {:.3g} mm of height {}.", name,
                                    free.diameter, section.height, to_fit ? "to fit the thickness" : "to bend round each other"));
    if (fitted.narrowed)
        notes.push_back(
            fmt::format("The {} yarns are narrowed to {:.3g} mm, 98 % of their pitch of {:.3g} mm; their packing factor rises from "
                        "{:.3g} to {:.3g}.",
                        name, section.width, pitch, free.packing_factor, fitted.packing_factor));
    else if (fitted.flattened)
        notes.push_back(fmt::format("The {} yarns become {:.3g} mm wide, keeping their area.", name, section.width));
}

FabricQuantities quantities_of(const Design& design, const Fabric& fabric)
{
    const FittedYarns fitted = fit_yarns(design, fabric);
    const FittedYarn &warp = fitted.warp[0], &weft = fitted.weft[0];

    FabricQuantities q;
    q.warp = describe(warp, fabric, fabric.ends_per_cm);
    q.weft = describe(weft, fabric, fabric.picks_per_cm);
    q.warp.rise_mm = 2 * fitted.at(0, 0).warp;
    q.weft.rise_mm = 2 * fitted.at(0, 0).weft;

    // A yarn runs longer than the fabric only where it changes sides.
    const double warp_changes = share_of_changes(fabric.weave, true);
    const double weft_changes = share_of_changes(fabric.weave, false);
    q.warp.cover = mean_width_of(fitted, true, q.weft.pitch_mm, warp_changes) / q.warp.pitch_mm;
    q.weft.cover = mean_width_of(fitted, false, q.warp.pitch_mm, weft_changes) / q.weft.pitch_mm;
    q.warp.crimp_percent = crimp_percent(fitted, true, 0, q.weft.pitch_mm, warp_changes);
    q.weft.crimp_percent = crimp_percent(fitted, false, 0, q.warp.pitch_mm, weft_changes);
    q.jammed = fitted.jammed;

    q.cover_factor = 1 - open_share(fitted, q.warp.pitch_mm, q.weft.pitch_mm, warp_changes, weft_changes);
    const SystemMass warp_mass = mass_of(fitted, true, fabric.ends_per_cm, q.weft.pitch_mm, warp_changes);
    const SystemMass weft_mass = mass_of(fitted, false, fabric.picks_per_cm, q.warp.pitch_mm, weft_changes);
    q.areal_density_g_m2 = warp_mass.areal + weft_mass.areal;

    q.yarn_layer_thickness_mm = fitted.thickness();
    q.thickness_mm = fabric.thickness_mm.value_or(q.yarn_layer_thickness_mm + 2 * fabric.flyaway.loop_height_mm);
    const double fibre_mm = warp_mass.solid + weft_mass.solid;
    q.porosity = 1 - fibre_mm / q.thickness_mm;
    q.fibre_volume_fraction = fibre_mm / q.yarn_layer_thickness_mm;
    const double fly = flyaway_volume(fabric, fitted.warp_order, fitted.warp, true, (1 + 0.01 * q.warp.crimp_percent) / q.warp.pitch_mm) +
                       flyaway_volume(fabric, fitted.weft_order, fitted.weft, false, (1 + 0.01 * q.weft.crimp_percent) / q.weft.pitch_mm);
    q.smoothness = std::max(0.0, 1 - fly / q.thickness_mm);
    q.rough_porosity = std::max(0.01, q.porosity - (1 - q.smoothness));
    q.gap_warp_mm = q.warp.pitch_mm * (1 - q.warp.cover);
    q.gap_weft_mm = q.weft.pitch_mm * (1 - q.weft.cover);
    q.inter_yarn_pore_radius_um = 1e3 * q.gap_warp_mm * q.gap_weft_mm / (q.gap_warp_mm + q.gap_weft_mm);

    const bool to_fit = fabric.thickness_mm.has_value();
    note_section(q.notes, "warp", warp, to_fit, q.warp.pitch_mm);
    note_section(q.notes, "weft", weft, to_fit, q.weft.pitch_mm);
    const double hair = q.thickness_mm - q.yarn_layer_thickness_mm;
    if (fabric.thickness_mm && hair > 0.005 * q.thickness_mm)
        q.notes.push_back(
            fmt::format("The interlaced yarns are {:.3g} mm thick; the other {:.3g} mm of the given thickness are flyaway fibres.",
                        q.yarn_layer_thickness_mm, hair));
    const auto note_crimp = [&](const char* name, const std::optional<double>& set, double reached) {
        if (set && std::abs(*set - reached) > 0.5)
            q.notes.push_back(fmt::format("The {}'s crimp is set to {:.3g} %; yarns of these sections and setts can have {:.3g} %.", name,
                                          *set, reached));
    };
    note_crimp("warp", fabric.warp_crimp_percent ? fabric.warp_crimp_percent : fabric.measured.crimp_percent, q.warp.crimp_percent);
    note_crimp("weft", fabric.weft_crimp_percent ? fabric.weft_crimp_percent : fabric.measured.crimp_percent, q.weft.crimp_percent);
    if (q.jammed)
        q.notes.push_back("Round yarns lie too close to bend round each other in full arcs; they are squeezed where they change sides.");
    return q;
}

double scale_to(const FabricQuantities& q, const Measured& measured)
{
    if (measured.areal_density_g_m2) return *measured.areal_density_g_m2 / q.areal_density_g_m2;
    if (measured.porosity) return (1 - *measured.porosity) / (1 - q.porosity);
    return 1;
}

} // namespace

FabricQuantities derive_quantities(const Design& design, const Fabric& fabric)
{
    Fabric unmeasured = fabric;
    unmeasured.measured = {};
    return quantities_of(design, unmeasured);
}

FabricQuantities quantities_in_use(const Design& design, const Fabric& fabric)
{
    FabricQuantities q = quantities_of(design, fabric);
    const double scale = scale_to(q, fabric.measured);
    for (YarnQuantities* yarn : {&q.warp, &q.weft}) {
        yarn->pore_radius_um *= (1 - scale * yarn->packing_factor_in_fabric) / (scale * (1 - yarn->packing_factor_in_fabric));
        yarn->linear_density_tex *= scale;
        yarn->packing_factor *= scale;
        yarn->packing_factor_in_fabric *= scale;
        yarn->pore_radius_um = fabric.measured.capillary_radius_um.value_or(yarn->pore_radius_um);
    }
    q.areal_density_g_m2 *= scale;
    q.fibre_volume_fraction *= scale;
    q.porosity = fabric.measured.porosity.value_or(1 - scale * (1 - q.porosity));
    q.rough_porosity = std::max(0.01, q.porosity - (1 - q.smoothness));
    return q;
}

double fibre_scale(const Design& design, const Fabric& fabric) { return scale_to(quantities_of(design, fabric), fabric.measured); }

} // namespace hygroloom
