// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Materials, experiments, and how the parts fit together; fabrics stand in validate_fabric.cpp.
#include "core/design/validate.h"

#include "core/base/units.h"
#include "core/design/issue_list.h"

#include <algorithm>

namespace hygroloom {

namespace {

constexpr double most_crossings = 30e6;
constexpr std::size_t most_droplets = 64;

double drop_radius_mm(const Droplet& drop) { return std::cbrt(3 * drop.volume_ul / (4 * pi)); }

void validate_droplet(const Experiment& experiment, const Droplet& drop, const std::string& where, IssueList& list)
{
    bool sound = true;
    if (!(std::isfinite(drop.volume_ul) && drop.volume_ul >= 1e-6 && drop.volume_ul <= 5000)) {
        list.error("range", where + ".volume_ul",
                   fmt::format("A droplet's volume must be from 1e-6 ul (1 pl) to 5000 ul; given is {}.", drop.volume_ul));
        sound = false;
    }
    list.range(where + ".time_s", "time when a droplet appears", drop.time_s, 0, 86400, "s");
    if (experiment.duration_s > 0 && drop.time_s >= experiment.duration_s)
        list.error(
            "droplet_after_end", where + ".time_s",
            fmt::format("The droplet appears at {} s, not before the experiment's end at {} s.", drop.time_s, experiment.duration_s));
    list.range(where + ".height_mm", "height of a droplet over the fabric", drop.height_mm, 0, 100, "mm");
    list.range(where + ".speed_m_s", "droplet's speed", drop.speed_m_s, 0, 5, "m/s");
    bool reaches_over = false;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double at = drop.at_mm[axis], half = 0.5 * experiment.sample_mm[axis];
        if (!(std::abs(at) <= half)) {
            list.error("droplet_off_sample", fmt::format("{}.at_mm[{}]", where, axis),
                       fmt::format("The droplet must land on the sample, from {} to {} mm {}; given is {}.", -half, half,
                                   axis == 0 ? "along the weft" : "along the warp", at));
            return;
        }
        reaches_over = reaches_over || (sound && std::abs(at) + drop_radius_mm(drop) > half);
    }
    if (reaches_over)
        list.add(Severity::warning, "droplet_over_edge", where + ".at_mm",
                 fmt::format("The droplet, {:.3g} mm across, reaches over the sample's edge; some of it will miss the fabric.",
                             2 * drop_radius_mm(drop)));
}

void validate_overlaps(const Experiment& experiment, const std::string& where, IssueList& list)
{
    const auto& drops = experiment.droplets;
    for (std::size_t a = 0; a < drops.size(); ++a)
        for (std::size_t b = a + 1; b < drops.size(); ++b) {
            if (std::abs(drops[a].time_s - drops[b].time_s) > 1e-3) continue;
            const double apart = std::hypot(drops[a].at_mm[0] - drops[b].at_mm[0], drops[a].at_mm[1] - drops[b].at_mm[1],
                                            drops[a].height_mm + drop_radius_mm(drops[a]) - drops[b].height_mm - drop_radius_mm(drops[b]));
            const double needed = drop_radius_mm(drops[a]) + drop_radius_mm(drops[b]);
            if (apart < needed)
                list.error("droplets_overlap", fmt::format("{}.droplets[{}]", where, b),
                           fmt::format("Droplets {} and {} appear at the same time and overlap: {:.3g} mm apart, {:.3g} mm needed.", a, b,
                                       apart, needed));
        }
}

void validate_size(const Fabric& fabric, const Experiment& experiment, const std::string& where, IssueList& list)
{
    const double ends = 0.1 * experiment.sample_mm[0] * fabric.ends_per_cm;
    const double picks = 0.1 * experiment.sample_mm[1] * fabric.picks_per_cm;
    if (!(ends * picks <= most_crossings))
        list.error("sample_too_large", where + ".sample_mm",
                   fmt::format("A sample of {} x {} mm of \"{}\" has {:.3g} million crossings; at most {:.3g} million are allowed.",
                               experiment.sample_mm[0], experiment.sample_mm[1], fabric.name, 1e-6 * ends * picks, 1e-6 * most_crossings));
    else if (ends < 1 || picks < 1)
        list.add(Severity::warning, "sample_too_small", where + ".sample_mm",
                 fmt::format("A sample of {} x {} mm is smaller than one crossing of \"{}\"; one crossing is taken.",
                             experiment.sample_mm[0], experiment.sample_mm[1], fabric.name));
}

} // namespace

void validate_material(const Material& material, const std::string& where, IssueList& list)
{
    if (!material.based_on.empty() && !find_library_material(material.based_on))
        list.error("unknown_material", where + ".based_on", fmt::format("The library has no material \"{}\".", material.based_on));
    list.range(where + ".density_kg_m3", "density of a fibre", material.density_kg_m3, 500, 3000, "kg/m3");
    list.range(where + ".fibre_radius_um", "radius of a fibre", material.fibre_radius_um, 0.5, 200, "um");
    list.range(where + ".standard_regain", "regain at 65 % relative humidity", material.standard_regain, 0, 0.5);
    if (list.range(where + ".saturation_regain", "regain at 100 % relative humidity", material.saturation_regain, 0, 2) &&
        material.saturation_regain < material.standard_regain)
        list.error("range", where + ".saturation_regain",
                   fmt::format("The regain at 100 % relative humidity, {}, cannot be less than the one at 65 %, {}.",
                               material.saturation_regain, material.standard_regain));
    if (const GabIsotherm& gab = material.gab; gab.given()) {
        const bool sound = list.range(where + ".isotherm.monolayer_regain", "monolayer regain", gab.monolayer_regain, 1e-5, 0.5) &
                           list.range(where + ".isotherm.c", "isotherm's c", gab.c, 0.01, 1000) &
                           list.range(where + ".isotherm.k", "isotherm's k", gab.k, 0.01, 0.99);
        const double ka = 0.65 * gab.k;
        const double at_65 = gab.monolayer_regain * gab.c * ka / ((1 - ka) * (1 - ka + gab.c * ka));
        if (sound && std::abs(at_65 - material.standard_regain) > 0.2 * material.standard_regain)
            list.add(Severity::warning, "isotherm_disagrees", where + ".isotherm",
                     fmt::format(
                         "The isotherm gives a regain of {:.3g} at 65 % relative humidity, standard_regain says {}; the isotherm is used.",
                         at_65, material.standard_regain));
    }
    if (material.diffusion.two_stage && two_stage_law(material).empty())
        list.error("no_two_stage_law", where + ".fibre_diffusivity_m2_s",
                   "A two-stage diffusion law is known for cotton and wool, and for materials based on them; give a number in m2/s.");
    if (!material.diffusion.two_stage)
        list.range(where + ".fibre_diffusivity_m2_s", "diffusivity of water in the fibre", material.diffusion.constant_m2_s, 1e-18, 1e-9,
                   "m2/s");
    list.range(where + ".contact_angle_deg", "contact angle", material.contact_angle_deg, 0, 180, "degrees");
    list.range(where + ".thermal_conductivity_w_mk", "thermal conductivity of a fibre", material.thermal_conductivity_w_mk, 0.005, 10,
               "W/(m K)");
    list.range(where + ".specific_heat_j_kgk", "specific heat of a fibre", material.specific_heat_j_kgk, 100, 10000, "J/(kg K)");
}

void validate_experiment(const Experiment& experiment, const std::string& where, IssueList& list)
{
    const Climate& climate = experiment.climate;
    if (list.range(where + ".climate.temperature_c", "temperature", climate.temperature_c, -10, 60, "C") && climate.temperature_c < 0)
        list.add(Severity::warning, "supercooled", where + ".climate.temperature_c",
                 fmt::format("At {} C the water is taken as supercooled liquid; freezing is not modelled.", climate.temperature_c));
    list.range(where + ".climate.relative_humidity", "relative humidity", climate.relative_humidity, 0, 1);
    list.range(where + ".climate.air_speed_m_s", "air speed", climate.air_speed_m_s, 0, 20, "m/s");
    if (experiment.liquid != "water")
        list.error("unknown_liquid", where + ".liquid", fmt::format("The liquid must be \"water\"; given is \"{}\".", experiment.liquid));
    for (std::size_t axis = 0; axis < 2; ++axis)
        list.range(fmt::format("{}.sample_mm[{}]", where, axis), "sample's size", experiment.sample_mm[axis], 0.1, 2000, "mm");
    if (!(std::isfinite(experiment.duration_s) && experiment.duration_s > 0 && experiment.duration_s <= 86400))
        list.error("range", where + ".duration_s",
                   fmt::format("The duration must be more than 0 and at most 86400 s; given is {}.", experiment.duration_s));

    const int before = list.errors();
    if (experiment.droplets.empty())
        list.add(Severity::warning, "no_droplet", where + ".droplets", "The experiment has no droplet; nothing will get wet.");
    if (experiment.droplets.size() > most_droplets) {
        list.error("range", where + ".droplets",
                   fmt::format("At most {} droplets are allowed; given are {}.", most_droplets, experiment.droplets.size()));
        return;
    }
    for (std::size_t i = 0; i < experiment.droplets.size(); ++i)
        validate_droplet(experiment, experiment.droplets[i], fmt::format("{}.droplets[{}]", where, i), list);
    if (list.errors() == before) validate_overlaps(experiment, where, list);
}

std::vector<Issue> validate(const Design& design)
{
    IssueList list;
    std::set<std::string> materials, fabrics, experiments;
    for (std::size_t i = 0; i < design.materials.size(); ++i) {
        const std::string where = fmt::format("materials[{}]", i);
        list.name(where + ".name", design.materials[i].name, materials);
        validate_material(design.materials[i], where, list);
    }
    const int material_errors = list.errors();
    std::vector<bool> sound(design.fabrics.size());
    for (std::size_t i = 0; i < design.fabrics.size(); ++i) {
        const std::string where = fmt::format("fabrics[{}]", i);
        const int before = list.errors();
        list.name(where + ".name", design.fabrics[i].name, fabrics);
        validate_fabric(design, design.fabrics[i], where, list);
        sound[i] = list.errors() == before && material_errors == 0;
    }
    for (std::size_t i = 0; i < design.experiments.size(); ++i) {
        const std::string where = fmt::format("experiments[{}]", i);
        const int before = list.errors();
        list.name(where + ".name", design.experiments[i].name, experiments);
        validate_experiment(design.experiments[i], where, list);
        if (list.errors() != before) continue;
        for (std::size_t f = 0; f < design.fabrics.size(); ++f)
            if (sound[f]) validate_size(design.fabrics[f], design.experiments[i], where, list);
    }
    return list.issues;
}

bool has_error(const std::vector<Issue>& issues)
{
    return std::any_of(issues.begin(), issues.end(), [](const Issue& issue) { return issue.severity == Severity::error; });
}

} // namespace hygroloom
