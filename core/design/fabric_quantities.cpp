// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/fabric_quantities.h"

#include "core/base/units.h"
#include "core/design/yarn_sections.h"

#include <fmt/format.h>

#include <algorithm>

namespace hygroloom {

namespace {

YarnQuantities describe(const FreeYarn& free, const FittedYarn& fitted, const Material& fibre, const Fabric& fabric, double sett)
{
    YarnQuantities yarn;
    yarn.linear_density_tex = free.linear_density_tex;
    yarn.diameter_mm = free.diameter;
    yarn.packing_factor = free.packing_factor;
    yarn.section_mm = fitted.section;
    yarn.packing_factor_in_fabric = fitted.packing_factor;
    yarn.pitch_mm = 10 / sett;
    yarn.cover = fitted.section.width / yarn.pitch_mm;
    // Void area over wetted perimeter of parallel cylinders, twice.
    yarn.pore_radius_um = fibre.fibre_radius_um * (1 - fitted.packing_factor) / fitted.packing_factor;
    yarn.contact_angle_deg = fabric.contact_angle_deg.value_or(fibre.contact_angle_deg);
    yarn.flattened = fitted.flattened || fitted.narrowed;
    return yarn;
}

/// Volume of loops and hairs on both yarns, mm3 per mm2 of fabric; a loop is half a circle as high as it is.
double flyaway_volume(const Fabric& fabric, const Material& warp_fibre, const Material& weft_fibre)
{
    const Flyaway& flyaway = fabric.flyaway;
    const double per_mm = flyaway.loop_density_per_mm * pi * flyaway.loop_height_mm + flyaway.hair_density_per_mm * flyaway.hair_length_mm;
    const auto fibre_area = [](const Material& fibre) { return pi * 1e-6 * fibre.fibre_radius_um * fibre.fibre_radius_um; };
    return per_mm * 0.1 * (fabric.ends_per_cm * fibre_area(warp_fibre) + fabric.picks_per_cm * fibre_area(weft_fibre));
}

void note_section(std::vector<std::string>& notes, const char* name, const FreeYarn& free, const FittedYarn& fitted, double pitch)
{
    const Section& section = fitted.section;
    if (fitted.flattened)
        notes.push_back(fmt::format("The {} yarns, {:.3g} mm across when free, are flattened to {:.3g} mm of height to fit the thickness.",
                                    name, free.diameter, section.height));
    if (fitted.narrowed)
        notes.push_back(
            fmt::format("The {} yarns are narrowed to {:.3g} mm, 98 % of their pitch of {:.3g} mm; their packing factor rises from "
                        "{:.3g} to {:.3g}.",
                        name, section.width, pitch, free.packing_factor, fitted.packing_factor));
    else if (fitted.flattened)
        notes.push_back(fmt::format("The {} yarns become {:.3g} mm wide, keeping their area.", name, section.width));
}

} // namespace

FabricQuantities derive_quantities(const Design& design, const Fabric& fabric)
{
    const Material warp_fibre = blended_material(design, fabric.warp.material);
    const Material weft_fibre = blended_material(design, fabric.weft.material);
    const FreeYarn warp = free_yarn(fabric.warp, warp_fibre.density_kg_m3);
    const FreeYarn weft = free_yarn(fabric.weft, weft_fibre.density_kg_m3);
    const FittedYarns fitted = fit_yarns(fabric, warp, weft);

    FabricQuantities q;
    q.warp = describe(warp, fitted.warp, warp_fibre, fabric, fabric.ends_per_cm);
    q.weft = describe(weft, fitted.weft, weft_fibre, fabric, fabric.picks_per_cm);

    // A yarn runs longer than the fabric only where it changes sides.
    const double warp_changes = share_of_changes(fabric.weave, true);
    const double weft_changes = share_of_changes(fabric.weave, false);
    const Interlacing warp_path = interlace(q.weft.pitch_mm, q.warp.section_mm, q.weft.section_mm);
    const Interlacing weft_path = interlace(q.warp.pitch_mm, q.weft.section_mm, q.warp.section_mm);
    q.warp.crimp_percent = 100 * (warp_path.length / warp_path.pitch - 1) * warp_changes;
    q.weft.crimp_percent = 100 * (weft_path.length / weft_path.pitch - 1) * weft_changes;
    q.jammed = (warp_changes > 0 && warp_path.jammed) || (weft_changes > 0 && weft_path.jammed);

    q.cover_factor = q.warp.cover + q.weft.cover - q.warp.cover * q.weft.cover;
    // tex x 1/cm is 0.1 g/m2.
    const double warp_mass = fabric.ends_per_cm * warp.linear_density_tex * (1 + 0.01 * q.warp.crimp_percent) / 10;
    const double weft_mass = fabric.picks_per_cm * weft.linear_density_tex * (1 + 0.01 * q.weft.crimp_percent) / 10;
    q.areal_density_g_m2 = warp_mass + weft_mass;

    q.yarn_layer_thickness_mm = q.warp.section_mm.height + q.weft.section_mm.height;
    q.thickness_mm = fabric.thickness_mm.value_or(q.yarn_layer_thickness_mm + 2 * fabric.flyaway.loop_height_mm);
    // 1 g/m2 over 1 kg/m3 is 1 mm of solid fibre.
    const double fibre_mm = warp_mass / warp_fibre.density_kg_m3 + weft_mass / weft_fibre.density_kg_m3;
    q.porosity = 1 - fibre_mm / q.thickness_mm;
    q.fibre_volume_fraction = fibre_mm / q.yarn_layer_thickness_mm;
    q.smoothness = std::max(0.0, 1 - flyaway_volume(fabric, warp_fibre, weft_fibre) / q.thickness_mm);
    q.gap_warp_mm = q.warp.pitch_mm - q.warp.section_mm.width;
    q.gap_weft_mm = q.weft.pitch_mm - q.weft.section_mm.width;
    q.inter_yarn_pore_radius_um = 1e3 * q.gap_warp_mm * q.gap_weft_mm / (q.gap_warp_mm + q.gap_weft_mm);

    note_section(q.notes, "warp", warp, fitted.warp, q.warp.pitch_mm);
    note_section(q.notes, "weft", weft, fitted.weft, q.weft.pitch_mm);
    const double hair = q.thickness_mm - q.yarn_layer_thickness_mm;
    if (fabric.thickness_mm && hair > 0.005 * q.thickness_mm)
        q.notes.push_back(
            fmt::format("The interlaced yarns are {:.3g} mm thick; the other {:.3g} mm of the given thickness are flyaway fibres.",
                        q.yarn_layer_thickness_mm, hair));
    if (q.jammed)
        q.notes.push_back("The yarns lie too close to bend round each other in full arcs; they are squeezed where they change sides.");
    return q;
}

} // namespace hygroloom
