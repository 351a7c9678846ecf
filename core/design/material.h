// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fibre materials and their blends. Values as a designer or a data sheet gives them, in the unit their name ends with.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

/// Sorption isotherm of Guggenheim, Anderson and de Boer, regain against relative humidity. All zero: use the master curve.
struct GabIsotherm {
    double monolayer_regain = 0; ///< wm, kg water per kg dry fibre
    double c = 0;
    double k = 0;
    bool operator==(const GabIsotherm&) const = default;
    bool given() const { return monolayer_regain != 0 || c != 0 || k != 0; }
};

/// How water moves inside a fibre.
struct FibreDiffusion {
    bool two_stage = false;   ///< Li and Luo's two-stage law of cotton or wool, see physics/sorption.h
    double constant_m2_s = 0; ///< used when not two_stage
    bool operator==(const FibreDiffusion&) const = default;
};

/// How much surface a fibre has: its perimeter over that of a circle of the same area.
struct CrossSection {
    double perimeter_factor = 1; ///< 1 .. 3
    std::string shape;           ///< of cross_sections(), whose factor it is; empty: given as a number, or round
    bool operator==(const CrossSection&) const = default;
};

/// Shapes that have a name, with their factors: round, trilobal, bean, channelled. Sources stand in resources/materials/fibres.json.
const std::vector<CrossSection>& cross_sections();

constexpr double least_fibre_radius_um = 0.001, most_fibre_radius_um = 200;

/// One fibre substance, dry.
struct Material {
    std::string name;
    std::string based_on; ///< library material a project's own one starts from; empty for the library's
    double density_kg_m3 = 0;
    double fibre_radius_um = 0;
    double standard_regain = 0;   ///< at 65 % relative humidity and 20 C, absorption, fraction
    double saturation_regain = 0; ///< at 100 % relative humidity, fraction
    GabIsotherm gab;
    FibreDiffusion diffusion;
    double contact_angle_deg = 0;             ///< of water, advancing
    std::optional<double> receding_angle_deg; ///< of water; without it, as receding_angle_under() assumes
    CrossSection cross_section;
    double thermal_conductivity_w_mk = 0;
    double specific_heat_j_kgk = 0;
    double heat_of_wetting_j_g = 0; ///< from dry to saturated, per g of fibre; 0: what the law of sorption heats gives
    bool operator==(const Material&) const = default;
};

/// Part of a blend, by mass.
struct MaterialShare {
    std::string name;
    double share = 1.0;
    bool operator==(const MaterialShare&) const = default;
};

/// The library that ships with the program (resources/materials, compiled in), in the order of its file.
const std::vector<Material>& material_library();

/// nullptr when the library has none of that name.
const Material* find_library_material(const std::string& name);

/// Its own name where the library has it, else that of the fibre that it starts from; that of no library's fibre where there is none.
std::string library_name(const Material& material);

/// Between which contact angles of water, in degrees, a library's fibre lies as mills use it.
struct AngleRange {
    double low = 0, high = 0;
    std::string source;
};
/// Precondition: the library has the fibre.
AngleRange contact_angle_range(const std::string& library_material);

/// How far the receding angle is taken to lie below the contact angle where none is given, degrees; 180: it is 0 whatever the contact
/// angle.
double assumed_hysteresis_deg(const Material& material);

/// The receding angle of water on a fibre, or on a finish of another contact angle: as given; else less than the contact angle by what
/// the library assumes of the fibre that the material is, or is based on (fibres.json: all of it for celluloses, 20 degrees for others).
/// Never above the contact angle, never below 0. Degrees.
double receding_angle_under(const Material& material, double contact_angle_deg);

/// "cotton" or "wool", whichever two-stage diffusion law the material has by its own name or by what it is based on; empty for others.
std::string two_stage_law(const Material& material);

} // namespace hygroloom
