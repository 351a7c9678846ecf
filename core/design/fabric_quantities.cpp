// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/fabric_quantities.h"

#include "core/base/units.h"
#include "core/design/flyaway.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

/// Share of the area that no yarn covers: a quarter of a hole between two ends and two picks, whose sides are the yarns' edges.
/// Where yarns keep their width it is (1 - c1)(1 - c2).
double open_share(const FittedYarns& fitted, double warp_pitch, double weft_pitch, double warp_changes, double weft_changes)
{
    constexpr std::size_t steps = 64;
    double open = 0;
    for (std::size_t i = 0; i < fitted.warp.size(); ++i)
        for (std::size_t j = 0; j < fitted.weft.size(); ++j) {
            const SpanPair& bent = fitted.span_at(i, j);
            const auto edges = [](const SpanSections& sections) {
                std::vector<double> half;
                for (std::size_t k = 0; k < steps; ++k) {
                    const double at = 0.5 * (span_samples - 1) * (static_cast<double>(k) + 0.5) / steps;
                    const auto low = static_cast<std::size_t>(at);
                    const double part = at - static_cast<double>(low);
                    half.push_back((1 - part) * sections.half_width(low) + part * sections.half_width(low + 1));
                }
                return half;
            };
            const std::vector<double> warp_bent = edges(bent.warp), warp_straight(steps, 0.5 * fitted.warp[i].section.width);
            const std::vector<double> weft_bent = edges(bent.weft), weft_straight(steps, 0.5 * fitted.weft[j].section.width);
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
SystemMass mass_of(const WovenYarns& woven, bool warp)
{
    SystemMass mass;
    const auto& yarns = woven.types(warp);
    for (std::size_t type = 0; type < yarns.size(); ++type) {
        const double crimp = 0.01 * crimp_percent(woven, warp, type);
        const double threads = woven.order(warp).share[type] * woven.sett_per_cm(warp);
        const double areal = threads * yarns[type].free.linear_density_tex * (1 + crimp) / 10; // tex x 1/cm is 0.1 g/m2
        mass.areal += areal;
        mass.solid += areal / yarns[type].fibre.density_kg_m3; // 1 g/m2 over 1 kg/m3 is 1 mm
    }
    return mass;
}

/// Loops and hairs on one system, per mm2 of fabric: volume in mm3, surface in mm2.
struct Flyaways {
    double volume = 0, surface = 0;
};
/// Fibres of plied yarns are taken to lie along the yarn.
Flyaways flyaways_of(const Fabric& fabric, const YarnOrder& order, const std::vector<FittedYarn>& yarns, bool warp, double length_per_mm2)
{
    const Flyaway& flyaway = fabric.flyaway;
    Flyaways all;
    for (std::size_t type = 0; type < yarns.size(); ++type) {
        const Yarn& yarn = yarn_in(fabric, warp, order.yarns[type]);
        const double turns = yarn.plies > 1 ? 0 : 1e-3 * yarn.twist_per_m;
        const double loop = mean_loop_length(flyaway.loop_height_mm, turns, std::sqrt(section_area(yarns[type].section) / pi));
        const double per_mm = flyaway.loop_density_per_mm * loop + flyaway.hair_density_per_mm * flyaway.hair_length_mm;
        const double radius = 1e-3 * yarns[type].fibre.fibre_radius_um;
        const double length = order.share[type] * length_per_mm2 * per_mm;
        all.volume += length * pi * radius * radius;
        all.surface += length * 2 * pi * radius;
    }
    return all;
}

/// The yarns' name begins the sentence: "The warp yarns".
void note_section(std::vector<Message>& notes, const Message& name, const FittedYarn& fitted, bool to_fit, double pitch)
{
    const FreeYarn& free = fitted.free;
    const Section& section = fitted.section;
    if (fitted.flattened)
        notes.push_back(say("{}, {:.3g} across when free, are flattened to {:.3g} of height {}.", name, Amount{free.diameter, Stored::mm},
                            Amount{section.height, Stored::mm}, to_fit ? say("to fit the thickness") : say("to bend round each other")));
    if (fitted.narrowed)
        notes.push_back(say("{} are narrowed to {:.3g}, 98 % of their pitch of {:.3g}; their packing factor rises from "
                            "{:.3g} to {:.3g}.",
                            name, Amount{section.width, Stored::mm}, Amount{pitch, Stored::mm}, free.packing_factor,
                            fitted.packing_factor));
    else if (fitted.flattened)
        notes.push_back(say("{} become {:.3g} wide where they cross.", name, Amount{section.width, Stored::mm}));
    if (fitted.loosened > 1 + 1e-6)
        notes.push_back(say("{} are loosened from a packing of {:.3g} to {:.3g}, to fill the thickness.", name, free.packing_factor,
                            free.packing_factor / fitted.loosened));
    if (fitted.area_share < 0.99)
        notes.push_back(say("{} have {:.0f} % of their area on average, as the crossed yarns squeeze them between crossings; they "
                            "are packed to {:.3g}.",
                            name, 100 * fitted.area_share, fitted.packing_factor));
}

void note_sections(std::vector<Message>& notes, const WovenYarns& yarns, bool warp)
{
    const bool to_fit = yarns.fabric.thickness_mm.has_value();
    for (std::size_t type = 0; type < yarns.types(warp).size(); ++type) {
        const int yarn = yarns.order(warp).yarns[type];
        const Message name = yarn > 0 ? warp ? say("The ends of extra yarn {}", yarn) : say("The picks of extra yarn {}", yarn)
                             : warp ? say("The warp yarns")
                                      : say("The weft yarns");
        note_section(notes, name, yarns.types(warp)[type], to_fit, yarns.pitch_mm(warp));
    }
}

} // namespace

FabricQuantities quantities_of(const Fabric& fabric, const FittedYarns& fitted)
{
    const WovenYarns yarns = woven_yarns(fabric, fitted);
    FabricQuantities q;
    q.warp = yarn_quantities(yarns, true, 0);
    q.weft = yarn_quantities(yarns, false, 0);
    q.warp.cover = mean_cover(yarns, true);
    q.weft.cover = mean_cover(yarns, false);
    q.jammed = fitted.jammed;

    q.cover_factor = 1 - open_share(fitted, q.warp.pitch_mm, q.weft.pitch_mm, yarns.warp_changes, yarns.weft_changes);
    const SystemMass warp_mass = mass_of(yarns, true), weft_mass = mass_of(yarns, false);
    q.areal_density_g_m2 = warp_mass.areal + weft_mass.areal;

    q.yarn_layer_thickness_mm = fitted.thickness();
    q.thickness_mm = fabric.thickness_mm.value_or(q.yarn_layer_thickness_mm + 2 * fabric.flyaway.loop_height_mm);
    q.thickness_1kpa_mm = fabric.thickness_mm.value_or(q.yarn_layer_thickness_mm + fitted.surface());
    const double fibre_mm = warp_mass.solid + weft_mass.solid;
    q.porosity = 1 - fibre_mm / q.thickness_mm;
    q.fibre_volume_fraction = fibre_mm / q.yarn_layer_thickness_mm;
    const Flyaways on_warp = flyaways_of(fabric, fitted.warp_order, fitted.warp, true, (1 + 0.01 * q.warp.crimp_percent) / q.warp.pitch_mm),
                   on_weft =
                       flyaways_of(fabric, fitted.weft_order, fitted.weft, false, (1 + 0.01 * q.weft.crimp_percent) / q.weft.pitch_mm);
    q.finish_depth = fabric.finish_depth.value_or(default_finish_depth);
    q.finish_holes = fabric.finish_holes.value_or(0);
    q.hair_surface = 0.5 * (on_warp.surface + on_weft.surface);
    q.smoothness = std::max(0.0, 1 - (on_warp.volume + on_weft.volume) / q.thickness_mm);
    q.rough_porosity = std::max(0.01, q.porosity - (1 - q.smoothness));
    q.gap_warp_mm = q.warp.pitch_mm * (1 - q.warp.cover);
    q.gap_weft_mm = q.weft.pitch_mm * (1 - q.weft.cover);
    q.inter_yarn_pore_radius_um = 1e3 * q.gap_warp_mm * q.gap_weft_mm / (q.gap_warp_mm + q.gap_weft_mm);

    for (bool warp : {true, false}) note_sections(q.notes, yarns, warp);
    const double hair = q.thickness_mm - q.yarn_layer_thickness_mm;
    if (fabric.thickness_mm && hair > 0.005 * q.thickness_mm)
        q.notes.push_back(say("The interlaced yarns are {:.3g} thick; the other {:.3g} of the given thickness are flyaway fibres.",
                              Amount{q.yarn_layer_thickness_mm, Stored::mm}, Amount{hair, Stored::mm}));
    const auto note_crimp = [&](const Message& name, const std::optional<double>& set, double reached) {
        if (set && std::abs(*set - reached) > 0.5)
            q.notes.push_back(
                say("The {}'s crimp is set to {:.3g} %; yarns of these sections and setts can have {:.3g} %.", name, *set, reached));
    };
    note_crimp(say("warp"), fabric.warp_crimp_percent ? fabric.warp_crimp_percent : fabric.measured.crimp_percent, q.warp.crimp_percent);
    note_crimp(say("weft"), fabric.weft_crimp_percent ? fabric.weft_crimp_percent : fabric.measured.crimp_percent, q.weft.crimp_percent);
    if (q.jammed) q.notes.push_back(say("Yarns are flattened at crossings: the sett is too dense for round yarns (Peirce)."));
    return q;
}

double fibre_scale(const FabricQuantities& q, const Measured& measured)
{
    if (measured.areal_density_g_m2) return *measured.areal_density_g_m2 / q.areal_density_g_m2;
    if (measured.porosity) return (1 - *measured.porosity) / (1 - q.porosity);
    return 1;
}

FabricQuantities with_measured(FabricQuantities q, const Measured& measured)
{
    const double scale = fibre_scale(q, measured);
    for (YarnQuantities* yarn : {&q.warp, &q.weft}) {
        yarn->pore_radius_um *= (1 - scale * yarn->packing_factor_in_fabric) / (scale * (1 - yarn->packing_factor_in_fabric));
        yarn->linear_density_tex *= scale;
        yarn->packing_factor *= scale;
        yarn->packing_factor_in_fabric *= scale;
    }
    q.areal_density_g_m2 *= scale;
    q.fibre_volume_fraction *= scale;
    q.porosity = measured.porosity.value_or(1 - scale * (1 - q.porosity));
    q.rough_porosity = std::max(0.01, q.porosity - (1 - q.smoothness));
    return q;
}

} // namespace hygroloom
