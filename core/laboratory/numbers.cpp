// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/laboratory/numbers.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/design/evenness.h"
#include "core/laboratory/air_permeability.h"
#include "core/laboratory/heat_vapour.h"
#include "core/laboratory/wet_cloth.h"
#include "core/physics/water.h"
#include "core/room/kept_tables.h"

#include <fmt/format.h>

namespace hygroloom {
namespace {

constexpr int room_voxels = 16; // in the mean pitch, as `live` has them
constexpr const char* not_compared = "";

Estimate exact(double value) { return {value, value, value}; }

void add_air(std::vector<LaboratoryNumber>& numbers, const Textile& textile, bool thickness_given)
{
    const AirPermeability air(textile, thickness_given);
    const char* compared = "sold cloths, on some of which the yarns' spread is calibrated: verify measured_air";
    for (const int pressure : {100, 125, 200}) {
        const Estimate speed = scaled(air.speed(pressure), 1e3);
        const std::string key = pressure == 100 ? "air_permeability_mm_s" : fmt::format("air_permeability_{}_pa_mm_s", pressure);
        numbers.push_back(
            {key, fmt::format("Air permeability at {} Pa", pressure), "mm/s", "ISO 9237", "1 mm/s is 1 l/(m² s)", speed, compared});
    }
    constexpr double mm_s_of_cfm = 5.08; // one cubic foot a minute through one square foot
    numbers.push_back({"air_permeability_cfm", "Air permeability at 125 Pa", "cfm/ft²", "ASTM D737", "",
                       scaled(air.speed(125), 1e3 / mm_s_of_cfm), compared});
}

void add_resistances(std::vector<LaboratoryNumber>& numbers, const Textile& textile, bool thickness_given, bool holds_water)
{
    const PlateResistances plate = plate_resistances(textile, thickness_given);
    const char* over_still_air =
        "resists 1.6 to 2.3 times as still air as thick at fibre shares of 0.25 to 0.37; Fourt and Harris measured 2 to 4";
    const std::string on_plate = "plate of 35 °C, its boundary layer subtracted; cloth lies flat on it";
    numbers.push_back({"rct_m2k_w", "Thermal resistance Rct", "m² K/W", "ISO 11092", on_plate, plate.thermal, not_compared});
    numbers.push_back({"ret_m2pa_w", "Water-vapour resistance Ret", "m² Pa/W", "ISO 11092", on_plate, plate.evaporative, over_still_air});
    numbers.push_back(
        {"permeability_index", "Permeability index", "", "ISO 11092", "60 Pa/K x Rct / Ret", plate.permeability_index(), not_compared});
    constexpr double heat_of_vapour = 0.672; // Wh/g at 35 C, as ISO 11092 has it
    const Estimate& ret = plate.evaporative;
    numbers.push_back({"vapour_permeability_g_m2_pa_h",
                       "Vapour permeability",
                       "g/(m² Pa h)",
                       "ISO 11092",
                       "1/(0.672 Wh/g x Ret)",
                       {1 / (heat_of_vapour * ret.value), 1 / (heat_of_vapour * ret.high), 1 / (heat_of_vapour * ret.low)},
                       not_compared});
    constexpr double per_day = 86400e3; // g/(m2 day) of kg/(m2 s)
    for (const VapourSetUp& set_up : vapour_set_ups()) {
        if (set_up.water_on_cloth && !holds_water) continue; // it would run out
        std::string conditions = fmt::format("{:g} °C, {:g} to {:g} % humidity, {:g} mm of air inside", set_up.celsius, 100 * set_up.humid,
                                             100 * set_up.dry, mm_from_metre(set_up.inner));
        if (set_up.air_speed >= 0) conditions += fmt::format(", {:g} m/s over it", set_up.air_speed);
        numbers.push_back({set_up.key, set_up.title, "g/(m² d)", set_up.standard, conditions,
                           scaled(vapour_transmission(set_up, ret), per_day), not_compared});
    }
}

void add_water(std::vector<LaboratoryNumber>& numbers, const Textile& textile, const RoomTables& tables, double dry)
{
    const WaterHeld held = water_held(textile, tables);
    const auto add = [&](const char* key, const char* title, const char* unit, const char* standard, const std::string& conditions,
                         const Estimate& estimate) {
        numbers.push_back({key, title, unit, standard, conditions, estimate, not_compared});
    };
    const std::string hangs = fmt::format("hangs {:g} cm high", 100 * hanging_height);
    add("absorption_full_g_m2", "Absorption capacity, full", "g/m²", "", "out of a bath of 5 cm, not drained", scaled(held.full, 1e3));
    add("absorption_full_percent", "Absorption capacity, full", "%", "", "out of a bath of 5 cm, not drained",
        scaled(held.full, 1e5 / dry));
    add("absorption_drained_g_m2", "Absorption capacity, drained", "g/m²", "DIN 53923", hangs, scaled(held.drained, 1e3));
    add("absorption_drained_percent", "Absorption capacity, drained", "%", "DIN 53923", hangs, scaled(held.drained, 1e5 / dry));
    add("retention_after_spinning_percent", "Retention after spinning", "%", "10 CFR 430 J3",
        fmt::format("{:g} g, {:g} kg/m² of wall", spin_acceleration, spin_load), scaled(held.spun, 1e5 / dry));
    for (const YarnKind along : {YarnKind::warp, YarnKind::weft})
        add(along == YarnKind::warp ? "wicking_speed_warp_mm_sqrt_s" : "wicking_speed_weft_mm_sqrt_s",
            along == YarnKind::warp ? "Speed of wicking along the warp" : "Speed of wicking along the weft", "mm/√s", "",
            "level strip, front against the root of time", scaled(wicking_speed(textile, tables, along), 1e3));
}

} // namespace

std::vector<LaboratoryNumber> quick_numbers(const FittedFabric& fitted)
{
    const FabricQuantities& q = fitted.measured;
    return {
        {"mass_g_m2", "Mass", "g/m²", "ISO 3801", "", exact(q.areal_density_g_m2), ""},
        {"thickness_mm", "Thickness at 1 kPa", "mm", "ISO 5084", "", exact(q.thickness_1kpa_mm), "sold cloths: verify measured_thickness"},
        {"cover_percent", "Cover", "%", "", "seen from above", exact(100 * q.cover_factor), ""},
        {"open_area_percent", "Open area", "%", "", "seen from above", exact(100 * (1 - q.cover_factor)), ""},
        {"thickness_drawn_mm", "Thickness, as drawn", "mm", "", "yarns with their loops, unpressed", exact(q.thickness_mm), ""},
        {"porosity_percent", "Porosity, as drawn", "%", "", "air in the volume of the cloth as drawn", exact(100 * q.porosity), ""}};
}

void add_computed(LaboratoryNumbers& numbers, const char* what, const std::function<void(std::vector<LaboratoryNumber>&)>& compute)
{
    std::vector<LaboratoryNumber> found;
    try {
        compute(found);
    } catch (const Error& error) {
        numbers.missing.push_back(fmt::format("{} is missing. {}", what, error.what()));
        return;
    }
    numbers.found.insert(numbers.found.end(), found.begin(), found.end());
}

LaboratoryNumbers laboratory_numbers(const Design& design, const Fabric& fabric, const FittedFabric& fitted)
{
    const Textile textile = build_textile(fabric, fitted, {0, 0, 1, 1});
    const bool thickness_given = fabric.thickness_mm.has_value();
    const auto cv = [&](const Yarn& yarn) { return yarn.irregularity_cv.value_or(typical_unevenness(design, yarn).cv); };
    const double mm_of_water = 1e3 / (water_density(kelvin_from_celsius(20)) * gravity_acceleration);
    const auto tables = room_tables(textile, room_voxels);
    const Estimate head = scaled(hydrostatic_pressure(textile, *tables, cv(fabric.warp), cv(fabric.weft)), mm_of_water);
    LaboratoryNumbers numbers{quick_numbers(fitted), {}};
    add_computed(numbers, "Air permeability", [&](auto& found) { add_air(found, textile, thickness_given); });
    add_computed(numbers, "What the cloth resists to heat and to vapour",
                 [&](auto& found) { add_resistances(found, textile, thickness_given, head.value > 0); });
    numbers.found.push_back({"hydrostatic_head_mm", "Hydrostatic head", "mm", "ISO 811",
                             "third drop on 100 cm²; 0: yarns wet and no face holds water off", head, not_compared});
    add_water(numbers.found, textile, *tables, fitted.measured.areal_density_g_m2);
    return numbers;
}

} // namespace hygroloom
