// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The closure `pores` against the pores of a fabric as it is drawn, by full morphology.
#include "core/base/error.h"
#include "core/physics/between_yarns.h"
#include "core/physics/water.h"
#include "core/verify/drawn_pores.h"
#include "core/verify/fits.h"
#include "core/verify/pore_set_ups.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

constexpr int radii = 24, sections = 4;
constexpr double most_voxels = 3e7;

/// One repeat, its yarns round and without finishes: as fibres are drawn.
Textile plain_repeat(const Fabric& fabric)
{
    Fabric cloth = fabric;
    cloth.finish_face.reset();
    cloth.finish_back.reset();
    Experiment experiment = standard_experiment(ExperimentType::horizontal_wicking);
    experiment.closure = Closure::pores;
    const Design design = design_of(cloth, experiment);
    Textile textile = textile_of_run(design, design.fabrics[0], design.experiments[0], {0, 0, fabric.weave.ends(), fabric.weave.picks()});
    if (textile.warp.types.size() > 1 || textile.weft.types.size() > 1)
        throw Error(fmt::format("fabric: Must have one type of warp and one of weft; {} has {} and {}.", fabric.name,
                                textile.warp.types.size(), textile.weft.types.size()));
    for (YarnSystem* system : {&textile.warp, &textile.weft}) system->types[0].perimeter_factor = 1;
    return textile;
}

/// Cosines of a contact angle as menisci see it while pores fill, and while they empty.
struct Cosines {
    double filling, emptying;
};
Cosines cosines_of(const YarnType& type)
{
    const double advancing = std::min(type.contact_angle, radian_from_degree(85)); // as the curves of the closure take it
    return {std::cos(advancing), std::cos(std::min(advancing, type.receding_angle))};
}

/// Of a class of pores; Pa where they are suctions.
struct Suctions {
    double entry, half, shape, hysteresis, residual;
};
/// A meniscus pulls with curvature x tension x cosine over a ball's radius: 1 as a cylinder, 2 as a ball.
Suctions suctions_of(const MorphologyCurves& curves, double voxel, double curvature, double tension, const Cosines& cosines)
{
    const double pull = curvature * tension / voxel, half = pull * cosines.filling / radius_at(curves.filling, 0.5);
    const BrooksCorey fitted = fitted_to(curves.filling);
    double residual = 0; // what no longer hangs together
    for (const MorphologyPoint& p : curves.emptying)
        if (!p.spans) residual = std::max(residual, p.saturation);
    return {pull * cosines.filling / fitted.entry_radius, half, fitted.shape,
            pull * cosines.emptying / radius_at(curves.emptying, 0.5) / half, residual};
}

/// Why closure and geometry differ, and by how many times at most for it to be known.
struct Reason {
    std::string why;
    double entry, half, shape, hysteresis;
};
// The factors are those of the library's fabrics, rounded up.
const Reason of_yarns{"Drawn fibres crowd at the axis and leave wide pores between; a disc leaves out how menisci bend across a pore.", 6,
                      4.5, 5.5, 3};
const Reason of_plies{"Plies are drawn into half of the outline, through each other; most of the pores lie between plies.", 80, 45, 5.5, 3};
const Reason of_room{"Hollows of both faces empty first, and air comes from both.", 1, 7.5, 1, 1};

VerifyResult compared(const std::string& name, double closure, double geometry, double tolerance, double most, const std::string& why)
{
    const VerifyResult result{name, closure, geometry, tolerance * geometry};
    return known_miss(result, why, (closure > geometry ? most - 1 : 1 - 1 / most) * geometry);
}

/// A class of pores by the closure and by the geometry.
void add_results(std::vector<VerifyResult>& results, const std::string& of, const Retention& closure, const Suctions& drawn,
                 double tolerance, const Reason& reason)
{
    const auto add = [&](const char* what, double computed, double expected, double share, double most) {
        results.push_back(compared(of + what, computed, expected, share, most, reason.why));
    };
    add("_entry_pa", closure.entry, drawn.entry, tolerance, reason.entry);
    add("_half_pa", suction_filling(closure, 0.5), drawn.half, tolerance, reason.half);
    add("_shape", 0.5 * closure.twice_shape, drawn.shape, tolerance, reason.shape);
    add("_hysteresis", closure.emptying / closure.entry, drawn.hysteresis, 0.3, reason.hysteresis);
}

/// A voxel in m: what is asked for, or the usual one. Throws Error where pores are not seen, or where the grid has too many; `grid` is that
/// of the usual one.
double voxel_of(const char* name, const VerifyValues& v, double usual_um, double largest_um, const VoxelGrid& grid, int dimensions)
{
    const double asked = value(v, name), given = asked > 0 ? asked : usual_um;
    const double smallest = 1.01 * usual_um * std::pow(static_cast<double>(grid.size()) / most_voxels, 1.0 / dimensions);
    if (given < smallest || given > largest_um)
        throw Error(fmt::format("{}: must be a number from {:.3g} to {:.3g} for {}, at most {:.0f} million voxels; {:g} was given.", name,
                                smallest, largest_um, v.at("fabric").word, 1e-6 * most_voxels, given));
    return metre_from_um(given);
}

void add_yarn(std::vector<VerifyResult>& results, const VerifyValues& v, const Textile& textile, YarnKind kind, const LiquidInPores& liquid)
{
    const YarnType& type = textile.type(kind, 0);
    const double fibre_um = type.fibre.fibre_radius_um, usual_um = fibre_um / 16;
    const std::vector<DrawnSection> drawn = drawn_sections(textile, kind, 0, sections);
    const double voxel = voxel_of("fibre_voxel_um", v, usual_um, fibre_um / 4, grid_of_sections(drawn, metre_from_um(usual_um)), 2);
    const PoreImage image = image_of_sections(drawn, voxel, 2 * value(v, "skin_fibres") * drawn[0].fibres[0].radius);
    const Suctions geometry = suctions_of(morphology_curves(image, radii), voxel, 1, liquid.surface_tension, cosines_of(type));
    const Retention closure = yarn_by_suction(type, textile, kind, liquid).at_bottom.retention;
    add_results(results, kind == YarnKind::warp ? "warp" : "weft", closure, geometry, 0.25, type.plies > 1 ? of_plies : of_yarns);
}

void add_room(std::vector<VerifyResult>& results, const VerifyValues& v, const Textile& textile, const LiquidInPores& liquid)
{
    const double thick_um = um_from_metre(textile.thickness), usual_um = thick_um / 40;
    const double voxel = voxel_of("voxel_um", v, usual_um, thick_um / 12, grid_of_room(textile, metre_from_um(usual_um)), 3);
    const double layer = textile.thickness * textile.warp.pitch * textile.weft.pitch;
    const VoxelGrid grid = grid_of_room(textile, voxel);
    const MorphologyCurves curves = morphology_curves(image_of_room(textile, voxel), radii);
    const YarnType &warp = textile.warp.types[0], &weft = textile.weft.types[0];
    const auto on_both = [&](double Cosines::*angle) { // yarns are wet
        return 1 - 0.5 * (warp.packing * (1 - cosines_of(warp).*angle) + weft.packing * (1 - cosines_of(weft).*angle));
    };
    const Cosines wet{on_both(&Cosines::filling), on_both(&Cosines::emptying)};
    const Suctions geometry = suctions_of(curves, voxel, 2, liquid.surface_tension, wet);
    const BetweenParameters closure = room_of_crossing(textile, 0, 0, liquid, {});
    const double per_layer = textile.thickness / voxel * grid.nx * grid.ny;
    results.push_back(compared("between_share", closure.volume / layer, curves.pores / per_layer, 0.4, 12, of_room.why));
    // Balls do not feel what two free faces cost, by which the closure's suction may fall below nothing.
    const VerifyResult half{"between_half_pa", suction_filling(closure.retention[both_wet], 0.5), geometry.half, 0.4 * geometry.half};
    results.push_back(known_miss(half, of_room.why, (of_room.half - 1) * geometry.half));
}

std::vector<VerifyResult> retention_by_morphology(const VerifyValues& v, Backend&)
{
    const Textile textile = plain_repeat(library_fabric(v.at("fabric").word));
    const LiquidInPores liquid{water_surface_tension(pore_temperature), water_viscosity(pore_temperature)};
    std::vector<VerifyResult> results;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) add_yarn(results, v, textile, kind, liquid);
    add_room(results, v, textile, liquid);
    return results;
}

} // namespace

std::vector<VerifyCase> morphology_cases()
{
    return {
        {"retention_by_morphology",
         "Suctions of a fabric's pores by the closure, against balls that fit between its drawn fibres and yarns; a voxel of 0: chosen.",
         {{"fabric", 0, 0, 0, "Textile F"}, {"voxel_um", 0, 0, 500, ""}, {"fibre_voxel_um", 0, 0, 10, ""}, {"skin_fibres", 1, 0, 3, ""}},
         retention_by_morphology}};
}

} // namespace hygroloom
