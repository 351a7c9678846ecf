// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reads the library that was compiled in from resources/materials/fibres.json.
#include "core/design/material.h"

#include <nlohmann/json.hpp>

namespace hygroloom {

extern const char fibres_json[];

namespace {

std::vector<Material> read_library()
{
    const nlohmann::json file = nlohmann::json::parse(fibres_json);
    std::vector<Material> library;
    for (const auto& entry : file.at("materials")) {
        const auto value = [&](const char* key) { return entry.at(key).at("value").get<double>(); };
        Material material;
        material.name = entry.at("name").get<std::string>();
        material.density_kg_m3 = value("density_kg_m3");
        material.fibre_radius_um = value("fibre_radius_um");
        material.standard_regain = value("standard_regain");
        material.saturation_regain = value("saturation_regain");
        if (entry.contains("gab")) {
            const auto& gab = entry.at("gab");
            material.gab.monolayer_regain = gab.at("monolayer_regain").at("value").get<double>();
            material.gab.c = gab.at("c").at("value").get<double>();
            material.gab.k = gab.at("k").at("value").get<double>();
        }
        material.diffusion.constant_m2_s = value("fibre_diffusivity_m2_s");
        material.contact_angle_deg = value("contact_angle_deg");
        material.thermal_conductivity_w_mk = value("thermal_conductivity_w_mk");
        material.specific_heat_j_kgk = value("specific_heat_j_kgk");
        material.heat_of_wetting_j_g = value("heat_of_wetting_j_g");
        library.push_back(material);
    }
    return library;
}

} // namespace

const std::vector<Material>& material_library()
{
    static const std::vector<Material> library = read_library();
    return library;
}

const Material* find_library_material(const std::string& name)
{
    for (const Material& material : material_library())
        if (material.name == name) return &material;
    return nullptr;
}

std::string two_stage_law(const Material& material)
{
    for (const char* law : {"cotton", "wool"})
        if (material.name == law || material.based_on == law) return law;
    return {};
}

} // namespace hygroloom
