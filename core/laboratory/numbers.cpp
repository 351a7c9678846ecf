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

#include <algorithm>
#include <optional>
#include <string_view>

namespace hygroloom {
namespace {

constexpr int room_voxels = 16; // in the mean pitch, as `live` has them

// What verify finds of the cases measured_air and measured_thickness, for who reads a card.
const char* const sold_air = "Air permeability was compared with 16 sold cloths: half of them came out within 3 times the measured value, "
                             "the worst 10 times off; 13 lay in their range.";
const char* const sold_thickness =
    "The thickness at 1 kPa was compared with 11 sold cloths: 8 came out within 25 %, two raised ones at less than half.";
const char* const over_still_air =
    "Ret is rather too low: cloths of a fibre share of 0.25 to 0.37 resist 1.6 to 2.3 times as still air as thick; Fourt and Harris "
    "measured 2 to 4 times.";

/// A number as all cards have it; vapour_set_ups() has those of the cups.
struct NumberRow {
    const char *key, *title, *unit, *standard, *model = "";
};
const NumberRow quick_rows[] = {{"mass_g_m2", "Mass", "g/m²", "ISO 3801"},
                                {"thickness_mm", "Thickness at 1 kPa", "mm", "ISO 5084", sold_thickness},
                                {"cover_percent", "Cover", "%", ""},
                                {"open_area_percent", "Open area", "%", ""},
                                {"thickness_drawn_mm", "Thickness, as drawn", "mm", ""},
                                {"porosity_percent", "Porosity, as drawn", "%", ""}};
const NumberRow dry_rows[] = {{"air_permeability_mm_s", "Air permeability at 100 Pa", "mm/s", "ISO 9237", sold_air},
                              {"air_permeability_125_pa_mm_s", "Air permeability at 125 Pa", "mm/s", "ISO 9237", sold_air},
                              {"air_permeability_200_pa_mm_s", "Air permeability at 200 Pa", "mm/s", "ISO 9237", sold_air},
                              {"air_permeability_cfm", "Air permeability at 125 Pa", "cfm/ft²", "ASTM D737", sold_air},
                              {"rct_m2k_w", "Thermal resistance Rct", "m² K/W", "ISO 11092"},
                              {"ret_m2pa_w", "Water-vapour resistance Ret", "m² Pa/W", "ISO 11092", over_still_air},
                              {"permeability_index", "Permeability index", "", "ISO 11092"},
                              {"vapour_permeability_g_m2_pa_h", "Vapour permeability", "g/(m² Pa h)", "ISO 11092"},
                              {"q_max_w_cm2", "Warm-cool feeling q-max", "W/cm²", "JIS L1927"}};
constexpr NumberRow wet_rows[] = {{"hydrostatic_head_mm", "Hydrostatic head", "mm", "ISO 811"},
                                  {"absorption_full_g_m2", "Absorption capacity, full", "g/m²", ""},
                                  {"absorption_full_percent", "Absorption capacity, full", "%", ""},
                                  {"absorption_drained_g_m2", "Absorption capacity, drained", "g/m²", "DIN 53923"},
                                  {"absorption_drained_percent", "Absorption capacity, drained", "%", "DIN 53923"},
                                  {"retention_after_spinning_percent", "Retention after spinning", "%", "10 CFR 430 J3"},
                                  {"wicking_speed_warp_mm_sqrt_s", "Speed of wicking along the warp, level strip", "mm/√s", ""},
                                  {"wicking_speed_weft_mm_sqrt_s", "Speed of wicking along the weft, level strip", "mm/√s", ""}};

const std::vector<NumberRow>& all_rows()
{
    static const std::vector<NumberRow> rows = [] {
        std::vector<NumberRow> all(std::begin(quick_rows), std::end(quick_rows));
        all.insert(all.end(), std::begin(dry_rows), std::end(dry_rows));
        for (const VapourSetUp& cup : vapour_set_ups()) all.push_back({cup.key, cup.title, "g/(m² d)", cup.standard});
        all.insert(all.end(), std::begin(wet_rows), std::end(wet_rows));
        return all;
    }();
    return rows;
}

LaboratoryNumber number(std::string_view key, const std::string& conditions, const Estimate& estimate)
{
    const auto row = std::find_if(all_rows().begin(), all_rows().end(), [&](const NumberRow& each) { return each.key == key; });
    return {row->key, row->title, row->unit, row->standard, conditions, estimate, row->model};
}

LaboratoryNumber exact(const char* key, double value, const std::string& conditions = {})
{
    return number(key, conditions, {value, value, value});
}

/// Whether a given thickness may be meant without the loops: instruments press them flat, the field counts them as they stand.
bool may_lack_loops(const Fabric& fabric) { return fabric.thickness_mm && fabric.flyaway.loop_height_mm > 0; }

/// Of a cloth whose given thickness is that of its yarns, the loops pressed flat. Precondition: may_lack_loops().
AirPermeability with_flat_loops(const Design& design, Fabric fabric, const Textile& textile)
{
    fabric.flyaway.loop_height_mm = 0;
    Textile flat = build_textile(fabric, fit_fabric(design, fabric), {0, 0, 1, 1});
    flat.flyaway = textile.flyaway;
    return {flat, true};
}

void add_air(std::vector<LaboratoryNumber>& numbers, const Design& design, const Fabric& fabric, const Textile& textile)
{
    const AirPermeability air(textile, fabric.thickness_mm.has_value());
    const auto flat = may_lack_loops(fabric) ? std::optional(with_flat_loops(design, fabric, textile)) : std::nullopt;
    const auto speed = [&](double pressure) {
        Estimate own = air.speed(pressure);
        if (!flat) return own;
        const Estimate other = flat->speed(pressure);
        return Estimate{own.value, std::min(own.low, other.low), std::max(own.high, other.high)};
    };
    for (const int pressure : {100, 125, 200}) {
        const std::string key = pressure == 100 ? "air_permeability_mm_s" : fmt::format("air_permeability_{}_pa_mm_s", pressure);
        numbers.push_back(number(key, "1 mm/s is 1 l/(m² s)", scaled(speed(pressure), 1e3)));
    }
    constexpr double mm_s_of_cfm = 5.08; // one cubic foot a minute through one square foot
    numbers.push_back(number("air_permeability_cfm", "", scaled(speed(125), 1e3 / mm_s_of_cfm)));
}

void add_resistances(std::vector<LaboratoryNumber>& numbers, const Textile& textile, bool thickness_given, bool holds_water)
{
    const PlateResistances plate = plate_resistances(textile, thickness_given);
    const Estimate& ret = plate.evaporative;
    const char* on_plate = "plate of 35 °C, its boundary layer subtracted; cloth lies flat on it";
    numbers.push_back(number("rct_m2k_w", on_plate, plate.thermal));
    numbers.push_back(number("ret_m2pa_w", on_plate, ret));
    numbers.push_back(number("permeability_index", "60 Pa/K x Rct / Ret", plate.permeability_index()));
    constexpr double heat_of_vapour = 0.672; // Wh/g at 35 C, as ISO 11092 has it
    numbers.push_back(number("vapour_permeability_g_m2_pa_h", "1/(0.672 Wh/g x Ret)",
                             {1 / (heat_of_vapour * ret.value), 1 / (heat_of_vapour * ret.high), 1 / (heat_of_vapour * ret.low)}));
    constexpr double cm2_in_m2 = 1e4;
    numbers.push_back(
        number("q_max_w_cm2",
               fmt::format("plate {:g} K warmer, pressed with 1 kPa, {:g} s after the touch (assumed)", touch_kelvin, touch_seconds),
               scaled(warm_cool_feeling(textile, thickness_given), 1 / cm2_in_m2)));
    constexpr double per_day = 86400e3; // g/(m2 day) of kg/(m2 s)
    for (const VapourSetUp& set_up : vapour_set_ups()) {
        if (set_up.water_on_cloth && !holds_water) continue; // it would run out
        std::string conditions = fmt::format("{:g} °C, {:g} to {:g} % humidity, {:g} mm of air inside", set_up.celsius, 100 * set_up.humid,
                                             100 * set_up.dry, mm_from_metre(set_up.inner));
        if (set_up.air_speed >= 0) conditions += fmt::format(", {:g} m/s over it", set_up.air_speed);
        numbers.push_back(number(set_up.key, conditions, scaled(vapour_transmission(set_up, ret), per_day)));
    }
}

void add_water(std::vector<LaboratoryNumber>& numbers, const Textile& textile, const RoomTables& tables, double dry)
{
    const WaterHeld held = water_held(textile, tables);
    const auto add = [&](const char* key, const std::string& conditions, const Estimate& estimate) {
        numbers.push_back(number(key, conditions, estimate));
    };
    const std::string hangs = fmt::format("hangs {:g} cm high", 100 * hanging_height);
    add("absorption_full_g_m2", "out of a bath of 5 cm, not drained", scaled(held.full, 1e3));
    add("absorption_full_percent", "out of a bath of 5 cm, not drained", scaled(held.full, 1e5 / dry));
    add("absorption_drained_g_m2", hangs, scaled(held.drained, 1e3));
    add("absorption_drained_percent", hangs, scaled(held.drained, 1e5 / dry));
    add("retention_after_spinning_percent", fmt::format("{:g} g, {:g} kg/m² of wall", spin_acceleration, spin_load),
        scaled(held.spun, 1e5 / dry));
    for (const YarnKind along : {YarnKind::warp, YarnKind::weft})
        add(along == YarnKind::warp ? "wicking_speed_warp_mm_sqrt_s" : "wicking_speed_weft_mm_sqrt_s",
            "strip lies level, front over the root of time; yarns and the rooms between them draw together",
            scaled(wicking_speed(textile, tables, along), 1e3));
}

/// Says why a range tells a mill little.
void note_wide_air(LaboratoryNumbers& numbers, const Fabric& fabric)
{
    constexpr double wide = 10; // high over low
    for (const LaboratoryNumber& number : numbers.found) {
        if (number.key != "air_permeability_mm_s" || !(number.estimate.high > wide * number.estimate.low)) continue;
        std::string note = fmt::format("Air permeability is known to a factor of {:.0f} only: how far the yarns spread into the holes is "
                                       "not known. Only a measurement of it tells more.",
                                       number.estimate.high / number.estimate.low);
        if (may_lack_loops(fabric))
            note += fmt::format(" The given thickness of {:.3g} mm is taken with the loops on both faces, {:.3g} mm each; the range also "
                                "holds the cloth whose yarns alone are so thick.",
                                *fabric.thickness_mm, fabric.flyaway.loop_height_mm);
        numbers.notes.push_back(std::move(note));
    }
}

/// How the thickness differs from what the fabric's field takes.
std::string under_pressure(const FabricQuantities& q)
{
    if (q.thickness_1kpa_mm == q.thickness_mm) return {};
    return fmt::format("loops and hairs pressed down; the fabric's field Thickness means them as they stand, here {:.3g} mm",
                       q.thickness_mm);
}

} // namespace

std::vector<LaboratoryNumber> numbers_of_cards()
{
    std::vector<LaboratoryNumber> numbers;
    for (const NumberRow& row : all_rows()) numbers.push_back(number(row.key, "", {}));
    return numbers;
}

std::vector<LaboratoryNumber> quick_numbers(const FittedFabric& fitted)
{
    const FabricQuantities& q = fitted.measured;
    return {exact("mass_g_m2", q.areal_density_g_m2),
            exact("thickness_mm", q.thickness_1kpa_mm, under_pressure(q)),
            exact("cover_percent", 100 * q.cover_factor, "seen from above"),
            exact("open_area_percent", 100 * (1 - q.cover_factor), "seen from above"),
            exact("thickness_drawn_mm", q.thickness_mm, "yarns with their loops, unpressed"),
            exact("porosity_percent", 100 * q.porosity, "air in the volume of the cloth as drawn")};
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
    add_computed(numbers, "Air permeability", [&](auto& found) { add_air(found, design, fabric, textile); });
    add_computed(numbers, "What the cloth resists to heat and to vapour",
                 [&](auto& found) { add_resistances(found, textile, thickness_given, head.value > 0); });
    numbers.found.push_back(number("hydrostatic_head_mm", "third drop on 100 cm²; 0: yarns wet and no face holds water off", head));
    add_water(numbers.found, textile, *tables, fitted.measured.areal_density_g_m2);
    note_wide_air(numbers, fabric);
    return numbers;
}

} // namespace hygroloom
