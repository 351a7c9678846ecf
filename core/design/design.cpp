// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/design.h"

#include <cmath>

namespace hygroloom {

namespace {

template <typename T> const T* find_by_name(const std::vector<T>& items, const std::string& name)
{
    for (const T& item : items)
        if (item.name == name) return &item;
    return nullptr;
}

double gab_at(const GabIsotherm& gab, double humidity)
{
    const double ka = gab.k * humidity;
    return gab.monolayer_regain * gab.c * ka / ((1 - ka) * (1 - ka + gab.c * ka));
}

std::string percent(double share)
{
    std::string text = std::to_string(std::lround(1000 * share) / 10.0);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text + " %";
}

} // namespace

const Material* find_material(const Design& design, const std::string& name)
{
    const Material* own = find_by_name(design.materials, name);
    return own ? own : find_library_material(name);
}

const Liquid* find_liquid(const Design& design, const std::string& name)
{
    const Liquid* own = find_by_name(design.liquids, name);
    return own ? own : find_by_name(library_liquids(), name);
}

double receding_angle_of(const Design& design, const std::vector<MaterialShare>& shares, std::optional<double> finish_deg)
{
    double mean = 0;
    for (const MaterialShare& part : shares) {
        const Material& fibre = *find_material(design, part.name);
        mean += part.share * receding_angle_under(fibre, finish_deg.value_or(fibre.contact_angle_deg));
    }
    return mean;
}

const Fabric* find_fabric(const Design& design, const std::string& name) { return find_by_name(design.fabrics, name); }
const Experiment* find_experiment(const Design& design, const std::string& name) { return find_by_name(design.experiments, name); }
const Garment* find_garment(const Design& design, const std::string& name) { return find_by_name(design.garments, name); }
const WearExperiment* find_wear(const Design& design, const std::string& name) { return find_by_name(design.wears, name); }

Material blended_material(const Design& design, const std::vector<MaterialShare>& shares)
{
    if (shares.size() == 1) return *find_material(design, shares.front().name);

    Material blend;
    double volume = 0, surface = 0, perimeter = 0, monolayer = 0; // per kg of the blend
    std::string law;
    bool all_two_stage = true, all_heats = true;
    for (const MaterialShare& part : shares) {
        const Material& fibre = *find_material(design, part.name);
        const double share = part.share;
        blend.name += (blend.name.empty() ? "" : ", ") + percent(share) + " " + fibre.name;
        volume += share / fibre.density_kg_m3;
        surface += 2 * share / (fibre.density_kg_m3 * fibre.fibre_radius_um);
        blend.standard_regain += share * fibre.standard_regain;
        blend.saturation_regain += share * fibre.saturation_regain;
        blend.diffusion.constant_m2_s += share * fibre.diffusion.constant_m2_s;
        blend.contact_angle_deg += share * fibre.contact_angle_deg;
        perimeter += 2 * share / (fibre.density_kg_m3 * fibre.fibre_radius_um) * fibre.cross_section.perimeter_factor;
        blend.thermal_conductivity_w_mk += share * fibre.thermal_conductivity_w_mk;
        blend.specific_heat_j_kgk += share * fibre.specific_heat_j_kgk;
        blend.heat_of_wetting_j_g += share * fibre.heat_of_wetting_j_g;
        all_heats = all_heats && fibre.heat_of_wetting_j_g > 0;
        // c and k by the water their fibres hold, so that a dry fibre in the blend does not bend the curve.
        monolayer += share * fibre.gab.monolayer_regain;
        blend.gab.c += share * fibre.gab.monolayer_regain * fibre.gab.c;
        blend.gab.k += share * fibre.gab.monolayer_regain * fibre.gab.k;
        const std::string own_law = two_stage_law(fibre);
        all_two_stage = all_two_stage && fibre.diffusion.two_stage && (law.empty() || law == own_law);
        law = own_law;
    }
    blend.density_kg_m3 = 1 / volume;
    blend.fibre_radius_um = 2 * volume / surface;
    blend.cross_section.perimeter_factor = perimeter / surface; // of the fibres' real surface over that of round ones
    blend.receding_angle_deg = receding_angle_of(design, shares, {});
    if (monolayer > 0) {
        blend.gab.c /= monolayer;
        blend.gab.k /= monolayer;
        blend.gab.monolayer_regain = 1;
        blend.gab.monolayer_regain = blend.standard_regain / gab_at(blend.gab, 0.65);
    } else {
        blend.gab = {};
    }
    if (!all_heats) blend.heat_of_wetting_j_g = 0;
    blend.diffusion.two_stage = all_two_stage;
    if (all_two_stage) blend.based_on = law;
    return blend;
}

Material yarn_substance(const Design& design, const Yarn& yarn)
{
    const Material cover = blended_material(design, yarn.material);
    if (!yarn.core) return cover;
    std::vector<MaterialShare> all = yarn.material;
    for (MaterialShare& part : all) part.share *= 1 - yarn.core->share;
    all.push_back({yarn.core->material, yarn.core->share});
    Material mean = blended_material(design, all);
    mean.based_on = two_stage_law(cover);
    mean.fibre_radius_um = cover.fibre_radius_um;
    mean.cross_section = cover.cross_section;
    mean.diffusion = cover.diffusion;
    mean.contact_angle_deg = cover.contact_angle_deg;
    mean.receding_angle_deg = cover.receding_angle_deg;
    return mean;
}

double core_of_solids(const Design& design, const Yarn& yarn)
{
    if (!yarn.core) return 0;
    const double core = yarn.core->share / find_material(design, yarn.core->material)->density_kg_m3;
    return core / (core + (1 - yarn.core->share) / blended_material(design, yarn.material).density_kg_m3);
}

} // namespace hygroloom
