// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reads the library that was compiled in from resources/materials/fibres.json.
#include "core/design/material.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace hygroloom {

extern const char fibres_json[];

namespace {

const nlohmann::json& library_file()
{
    static const nlohmann::json file = nlohmann::json::parse(fibres_json);
    return file;
}

/// The entry of a library's fibre, or nullptr.
const nlohmann::json* entry_named(const std::string& name)
{
    for (const auto& entry : library_file().at("materials"))
        if (entry.at("name") == name) return &entry;
    return nullptr;
}

const CrossSection& shape_named(const std::string& name)
{
    const std::vector<CrossSection>& all = cross_sections();
    return *std::find_if(all.begin(), all.end(), [&](const CrossSection& section) { return section.shape == name; });
}

std::vector<Material> read_library()
{
    std::vector<Material> library;
    for (const auto& entry : library_file().at("materials")) {
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
        if (entry.contains("cross_section")) material.cross_section = shape_named(entry.at("cross_section").get<std::string>());
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

const std::vector<CrossSection>& cross_sections()
{
    static const std::vector<CrossSection> all = [] {
        std::vector<CrossSection> shapes;
        for (const auto& entry : library_file().at("cross_sections"))
            shapes.push_back({entry.at("perimeter_factor").at("value").get<double>(), entry.at("name").get<std::string>()});
        return shapes;
    }();
    return all;
}

const Material* find_library_material(const std::string& name)
{
    for (const Material& material : material_library())
        if (material.name == name) return &material;
    return nullptr;
}

std::string library_name(const Material& material)
{
    return find_library_material(material.name) || material.based_on.empty() ? material.name : material.based_on;
}

AngleRange contact_angle_range(const std::string& library_material)
{
    const nlohmann::json& angle = entry_named(library_material)->at("contact_angle_deg");
    return {angle.at("low").get<double>(), angle.at("high").get<double>(), angle.at("source").get<std::string>()};
}

double assumed_hysteresis_deg(const Material& material)
{
    const nlohmann::json* entry = entry_named(library_name(material));
    return entry ? entry->at("contact_angle_hysteresis_deg").at("value").get<double>()
                 : 20; // as of the library's fibres that do not swell; an assumption
}

double receding_angle_under(const Material& material, double contact_angle_deg)
{
    if (material.receding_angle_deg) return std::min(*material.receding_angle_deg, contact_angle_deg);
    return std::max(0.0, contact_angle_deg - assumed_hysteresis_deg(material));
}

std::string two_stage_law(const Material& material)
{
    for (const char* law : {"cotton", "wool"})
        if (material.name == law || material.based_on == law) return law;
    return {};
}

} // namespace hygroloom
