// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/idle_keys.h"

#include <algorithm>

namespace hygroloom {
namespace {

/// Whether liquid can come to the cloth, or out of the air.
bool meets_liquid(const Experiment& experiment)
{
    const auto condenses = [](const Climate& climate) { return climate.relative_humidity > 1; };
    return info_of(experiment.type).source != WaterSource::air || condenses(experiment.climate) || condenses(experiment.initial) ||
           std::any_of(experiment.climates.begin(), experiment.climates.end(),
                       [&](const ClimateMoment& m) { return condenses(m.climate); });
}

bool counts_filaments(const Fabric& fabric)
{
    const auto counts = [](const Yarn& yarn) { return yarn.filament_count.has_value(); };
    return counts(fabric.warp) && counts(fabric.weft) && std::all_of(fabric.extra_yarns.begin(), fabric.extra_yarns.end(), counts);
}

/// Whether no yarn's section follows its twist.
bool told_shape(const Fabric& fabric)
{
    const auto told = [](const Yarn& yarn) {
        return yarn.diameter_mm || (yarn.yarn_class ? *yarn.yarn_class >= YarnClass::flat : yarn.filament_count.has_value());
    };
    return told(fabric.warp) && told(fabric.weft) && std::all_of(fabric.extra_yarns.begin(), fabric.extra_yarns.end(), told);
}

/// Whether all yarns are spun, of a given diameter: packed and round as that says.
bool sized_and_spun(const Fabric& fabric)
{
    const auto sized = [](const Yarn& yarn) { return yarn.diameter_mm && yarn.yarn_class && *yarn.yarn_class < YarnClass::flat; };
    return sized(fabric.warp) && sized(fabric.weft) && std::all_of(fabric.extra_yarns.begin(), fabric.extra_yarns.end(), sized);
}

struct Row {
    bool idle;
    const char* because;
    std::vector<const char*> keys;
};

std::vector<Row> rows_of(const Fabric& fabric, const Experiment& experiment, const ModelPlan& plan)
{
    const bool by_suction = experiment.closure == Closure::pores, printed = experiment.closure == Closure::paper;
    const auto out = [&](const char* part) { return !plan.on(part) && !plan.watches(part); };
    const bool lie_alike = told_shape(fabric); // other yarns lie the flatter the less they are twisted
    const bool turned_over_alike =
        !wets_a_spot(experiment.type) && info_of(experiment.type).source != WaterSource::face && !fabric.finish_face && !fabric.finish_back;
    return {
        {!by_suction,
         "only the closure pores reads it",
         {"material.receding_angle_deg", "material.cross_section", "yarn.ply_twist_per_m", "yarn.irregularity_cv", "fabric.finish_face",
          "fabric.finish_back", "fabric.finish_depth", "fabric.finish_holes", "fabric.flyaway.loop_density_per_mm",
          "fabric.flyaway.hair_density_per_mm", "fabric.flyaway.hair_length_mm"}},
        {lie_alike && (!by_suction || !meets_liquid(experiment)),
         "sections of filament yarns and of given diameters do not follow it",
         {"yarn.twist_per_m", "yarn.plies"}},
        {sized_and_spun(fabric), "spun yarns of given diameters are packed as these say, and round", {"yarn.yarn_class"}},
        {by_suction && falling_drops(experiment).empty(),
         "no drop falls, which hairs would hold off",
         {"fabric.flyaway.loop_density_per_mm", "fabric.flyaway.hair_density_per_mm", "fabric.flyaway.hair_length_mm"}},
        {!fabric.finish_face && !fabric.finish_back, "no face has a finish of its own", {"fabric.finish_depth", "fabric.finish_holes"}},
        {!wets_a_spot(experiment.type), "no drop or pool stands on a face", {"fabric.finish_holes"}},
        {turned_over_alike, "no face differs from the other", {"draft.rising_shed"}},
        {out("vapour"), "vapour is left out", {"experiment.climate.relative_humidity"}},
        {!meets_liquid(experiment),
         "no liquid comes to the cloth",
         {"material.contact_angle_deg", "material.receding_angle_deg", "material.cross_section", "yarn.ply_twist_per_m",
          "fabric.contact_angle_deg", "fabric.finish_face", "fabric.finish_back", "fabric.finish_depth", "fabric.finish_holes",
          "experiment.liquid", "liquid.surface_tension_mn_m", "liquid.viscosity_mpa_s", "liquid.density_kg_m3"}},
        {fabric.contact_angle_deg.has_value(), "the fabric's contact_angle_deg counts", {"material.contact_angle_deg"}},
        {printed, "the closure paper gives all fibres the contact angle of cotton", {"material.contact_angle_deg"}},
        {counts_filaments(fabric), "filament_count says how thick the fibres are", {"material.fibre_radius_um"}},
        {fabric.measured.tortuosity.has_value(), "the measured tortuosity counts", {"yarn.ply_twist_per_m"}},
        {lie_alike && fabric.measured.tortuosity.has_value(), "the measured tortuosity counts", {"yarn.twist_per_m", "yarn.plies"}},
        {out("sorption"),
         "sorption is left out",
         {"material.saturation_regain", "material.fibre_diffusivity_m2_s", "material.heat_of_wetting_j_g", "material.sorption_heat_j_g"}},
        {out("heat"),
         "heat is left out",
         {"material.thermal_conductivity_w_mk", "material.specific_heat_j_kgk", "material.heat_of_wetting_j_g",
          "material.sorption_heat_j_g"}},
    };
}

} // namespace

std::vector<IdleKey> idle_keys(const Fabric& fabric, const Experiment& experiment, const ModelPlan& plan)
{
    std::vector<IdleKey> keys;
    for (const Row& row : rows_of(fabric, experiment, plan))
        for (const char* key : row.keys)
            if (row.idle && std::none_of(keys.begin(), keys.end(), [&](const IdleKey& known) { return known.key == key; }))
                keys.push_back({key, row.because});
    return keys;
}

} // namespace hygroloom
