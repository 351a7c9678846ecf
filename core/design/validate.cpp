// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Materials and how the parts fit together; fabrics and experiments stand in files of their own.
#include "core/design/validate.h"

#include "core/base/units.h"
#include "core/design/holes.h"
#include "core/design/issue_list.h"

#include <algorithm>

namespace hygroloom {

namespace {

constexpr double most_crossings = 30e6;
void validate_size(const Fabric& fabric, const Experiment& experiment, const Place& where, IssueList& list)
{
    const auto [width, height] = sample_extent_mm(experiment);
    const double ends = 0.1 * width * fabric.ends_per_cm;
    const double picks = 0.1 * height * fabric.picks_per_cm;
    const Place size = where / info_of(experiment.type).sample_key;
    if (!(ends * picks <= most_crossings))
        list.error("sample_too_large", size,
                   say("A sample of {:.4g} x {:.4g} of \"{}\" has {:.3g} million crossings; at most {:.3g} million are allowed.",
                       Bare{width, Stored::mm}, Amount{height, Stored::mm}, fabric.name, 1e-6 * ends * picks, 1e-6 * most_crossings));
    else if (ends < 1 || picks < 1)
        list.add(Severity::warning, "sample_too_small", size,
                 say("A sample of {:.4g} x {:.4g} is smaller than one crossing of \"{}\"; one crossing is taken.", Bare{width, Stored::mm},
                     Amount{height, Stored::mm}, fabric.name));
}

} // namespace

void validate_material(const Material& material, const Place& where, IssueList& list)
{
    if (!material.based_on.empty() && !find_library_material(material.based_on))
        list.error("unknown_material", where / "based_on", say("The library has no material \"{}\".", material.based_on));
    const bool sound = list.fields(where, material);
    if (sound && material.saturation_regain < material.standard_regain)
        list.error("range", where / "saturation_regain",
                   say("The regain at 100 % relative humidity, {}, cannot be less than the one at 65 %, {}.", material.saturation_regain,
                       material.standard_regain));
    if (const GabIsotherm& gab = material.gab; gab.given() && list.fields(where / "isotherm", gab)) {
        const double ka = 0.65 * gab.k;
        const double at_65 = gab.monolayer_regain * gab.c * ka / ((1 - ka) * (1 - ka + gab.c * ka));
        if (std::abs(at_65 - material.standard_regain) > 0.2 * material.standard_regain)
            list.add(Severity::warning, "isotherm_disagrees", where / "isotherm",
                     say("The isotherm gives a regain of {:.3g} at 65 % relative humidity, standard_regain says {}; the isotherm is used.",
                         at_65, material.standard_regain));
    }
    if (material.diffusion.two_stage && two_stage_law(material).empty())
        list.error("no_two_stage_law", where / "fibre_diffusivity_m2_s",
                   say("A two-stage diffusion law is known for cotton and wool, and for materials based on them; give a number in m2/s."));
    if (!material.diffusion.two_stage)
        list.range(where / "fibre_diffusivity_m2_s", say("diffusivity of water in the fibre"), material.diffusion.constant_m2_s, 1e-30,
                   1e-9, Stored::m2_per_second);
    if (sound && material.receding_angle_deg > material.contact_angle_deg)
        list.error("receding_above_advancing", where / "receding_angle_deg",
                   say("The receding angle, {} degrees, cannot be above the contact angle, {}.", *material.receding_angle_deg,
                       material.contact_angle_deg));
    list.range(where / "cross_section", say("perimeter of a fibre over that of a circle of the same area"),
               material.cross_section.perimeter_factor, 1, 3);
}

std::vector<Issue> validate(const Design& design) { return validate_and_fit(design).issues; }

Validation validate_and_fit(const Design& design)
{
    IssueList list;
    std::vector<std::shared_ptr<const FittedFabric>> fitted(design.fabrics.size());
    std::set<std::string> materials, liquids, fabrics, experiments, garments;
    for (std::size_t i = 0; i < design.materials.size(); ++i) {
        const Place where = Place("materials") / i;
        list.name(where / "name", design.materials[i].name, materials);
        validate_material(design.materials[i], where, list);
    }
    const int material_errors = list.errors();
    for (std::size_t i = 0; i < design.liquids.size(); ++i) {
        const Place where = Place("liquids") / i;
        list.name(where / "name", design.liquids[i].name, liquids);
        validate_liquid(design.liquids[i], where, list);
    }
    std::vector<bool> sound(design.fabrics.size());
    for (std::size_t i = 0; i < design.fabrics.size(); ++i) {
        const Place where = Place("fabrics") / i;
        const int before = list.errors();
        list.name(where / "name", design.fabrics[i].name, fabrics);
        fitted[i] = validate_fabric(design, design.fabrics[i], where, list);
        sound[i] = list.errors() == before && material_errors == 0;
        if (!sound[i]) fitted[i] = nullptr;
    }
    for (std::size_t i = 0; i < design.experiments.size(); ++i) {
        const Place where = Place("experiments") / i;
        const int before = list.errors();
        list.name(where / "name", design.experiments[i].name, experiments);
        validate_experiment(design, design.experiments[i], where, list);
        if (list.errors() != before) continue;
        for (std::size_t f = 0; f < design.fabrics.size(); ++f) {
            if (!sound[f]) continue;
            validate_size(design.fabrics[f], design.experiments[i], where, list);
            if (const auto hole = falls_through(design.fabrics[f], *fitted[f], design.experiments[i]))
                list.add(Severity::warning, "falls_through", where, *hole);
        }
    }
    for (std::size_t i = 0; i < design.wears.size(); ++i) { // they stand behind the others
        const Place where = Place("experiments") / (design.experiments.size() + i);
        list.name(where / "name", design.wears[i].name, experiments);
        validate_wear(design, design.wears[i], where, list);
    }
    for (std::size_t i = 0; i < design.garments.size(); ++i) {
        const Place where = Place("garments") / i;
        list.name(where / "name", design.garments[i].name, garments);
        validate_garment(design, design.garments[i], where, list);
    }
    return {std::move(list.issues), std::move(fitted)};
}

} // namespace hygroloom
