// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/plan/idle_keys.h"

#include "core/design/fields.h"

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

struct Lack {
    Need need;
    bool is_so;
    const char* because;
};

/// What is not so in a run, and why.
std::vector<Lack> lacks_of(const Fabric& fabric, const Experiment& experiment, const ModelPlan& plan)
{
    const bool by_suction = experiment.closure == Closure::pores, printed = experiment.closure == Closure::paper;
    const auto out = [&](const char* part) { return !plan.on(part) && !plan.watches(part); };
    const bool lie_alike = told_shape(fabric); // other yarns lie the flatter the less they are twisted
    return {{Need::pores, !by_suction, "only the closure pores reads it"},
            {Need::shape_by_twist, lie_alike && (!by_suction || !meets_liquid(experiment)),
             "sections of filament yarns and of given diameters do not follow it"},
            {Need::shape_by_class, sized_and_spun(fabric), "spun yarns of given diameters are packed as these say, and round"},
            {Need::drops, by_suction && falling_drops(experiment).empty(), "no drop falls, which hairs would hold off"},
            {Need::finish, !fabric.finish_face && !fabric.finish_back, "no face has a finish of its own"},
            {Need::spot, !wets_a_spot(experiment.type), "no drop or pool stands on a face"},
            {Need::vapour, out("vapour"), "vapour is left out"},
            {Need::liquid, !meets_liquid(experiment), "no liquid comes to the cloth"},
            {Need::fibre_angle, fabric.contact_angle_deg.has_value(), "the fabric's contact_angle_deg counts"},
            {Need::fibre_angle, printed, "the closure paper gives all fibres the contact angle of cotton"},
            {Need::fibre_radius, counts_filaments(fabric), "filament_count says how thick the fibres are"},
            {Need::tortuosity, fabric.measured.tortuosity.has_value(), "the measured tortuosity counts"},
            {Need::shape_by_twist, lie_alike && fabric.measured.tortuosity.has_value(), "the measured tortuosity counts"},
            {Need::sorption, out("sorption"), "sorption is left out"},
            {Need::heat, out("heat"), "heat is left out"}};
}

struct Reader {
    std::string key;
    Needs needs;
};

template <typename Owner> void add_rows(std::vector<Reader>& all, const std::string& object)
{
    for (const Field<Owner>& field : fields_of<Owner>()) all.push_back({object + "." + field.key, field.needs});
}

/// The keys that change water in some runs only: those of rows, and those of values that are no numbers.
std::vector<Reader> readers()
{
    std::vector<Reader> all{{"material.cross_section", Need::pores | Need::liquid},
                            {"material.fibre_diffusivity_m2_s", Need::sorption},
                            {"material.sorption_heat_j_g", Need::sorption | Need::heat},
                            {"experiment.liquid", Need::liquid}};
    add_rows<Material>(all, "material");
    add_rows<Yarn>(all, "yarn");
    add_rows<Fabric>(all, "fabric");
    add_rows<Flyaway>(all, "fabric.flyaway");
    add_rows<Climate>(all, "experiment.climate");
    add_rows<Liquid>(all, "liquid");
    return all;
}

} // namespace

std::vector<IdleKey> idle_keys(const Fabric& fabric, const Experiment& experiment, const ModelPlan& plan)
{
    std::vector<IdleKey> keys;
    const std::vector<Lack> lacks = lacks_of(fabric, experiment, plan);
    for (const Reader& reader : readers()) {
        const auto lack =
            std::find_if(lacks.begin(), lacks.end(), [&](const Lack& each) { return each.is_so && reader.needs.has(each.need); });
        if (lack != lacks.end()) keys.push_back({reader.key, lack->because});
    }
    if (!wets_a_spot(experiment.type) && info_of(experiment.type).source != WaterSource::face && !fabric.finish_face && !fabric.finish_back)
        keys.push_back({"draft.rising_shed", "no face differs from the other"});
    return keys;
}

} // namespace hygroloom
