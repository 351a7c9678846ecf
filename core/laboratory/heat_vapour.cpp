// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/laboratory/heat_vapour.h"

#include "core/base/units.h"
#include "core/physics/laboratory.h"
#include "core/room/conduction.h"
#include "core/room/room_tables.h"

namespace hygroloom {
namespace {

const double plate_temperature = kelvin_from_celsius(35);
constexpr int voxels = 20, coarse_voxels = 10; // in the mean pitch

/// W/(m K) at 35 C: with the temperature's ratio to the power of 0.8, as usual near room temperature.
double air_on_plate() { return air_conductivity * std::pow(plate_temperature / kelvin_from_celsius(20), 0.8); }

/// Metres that fibres stand out of the yarns, both faces together, under the cloth's own weight.
double standing_fibres(const Textile& textile, bool thickness_given)
{
    const FabricQuantities& q = textile.quantities;
    const double pressed = metre_from_mm(std::max(0.0, q.thickness_1kpa_mm - q.yarn_layer_thickness_mm));
    const double weight = 1e-3 * q.areal_density_g_m2 * gravity_acceleration;
    return thickness_given ? pressed : height_of_hairs(pressed, 1000, weight);
}

/// Resistances over that of still air as thick as the yarns.
struct OverAir {
    double heat = 1, vapour = 1;
};
OverAir over_air(const Textile& textile, int per_pitch, double fibre_factor)
{
    const DrawnRepeat repeat = drawn_repeat(textile, per_pitch);
    double heat = 0, vapour = 0; // of yarns, mean of both systems
    for (const YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const YarnType& type = textile.system(kind).types[0];
        heat += 0.5 * conductivity_across_fibres(type.packing, fibre_factor * type.fibre.thermal_conductivity_w_mk, air_on_plate());
        vapour += 0.5 * conductivity_across_fibres(type.packing, 0, 1);
    }
    constexpr double least = 1e-4; // of air: yarns of one filament
    return {air_on_plate() / conductivity_through(repeat.layer, repeat.growth, air_on_plate(), heat),
            1 / conductivity_through(repeat.layer, repeat.growth, 1, std::max(least, vapour))};
}

/// What of a touch is not known.
struct Touch {
    double seconds = touch_seconds;
    double fibres = 0;       ///< m that stand between plate and yarns
    double fibre_factor = 1; ///< of their conductivity
};

/// W s^1/2/(m2 K), of what lies uppermost: mean of both systems.
double effusivity_of_yarns(const Textile& textile, double fibre_factor)
{
    double sum = 0;
    for (const YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const YarnType& type = textile.system(kind).types[0];
        const double conductivity =
            conductivity_across_fibres(type.packing, fibre_factor * type.fibre.thermal_conductivity_w_mk, air_conductivity);
        sum += 0.5 * std::sqrt(conductivity * type.packing * type.fibre.density_kg_m3 * type.fibre.specific_heat_j_kgk);
    }
    return sum;
}

double touch_heat(const Textile& textile, int per_pitch, const Touch& touch)
{
    const DrawnRepeat repeat = drawn_repeat(textile, per_pitch);
    const DrawnLayer& layer = repeat.layer;
    const double effusivity = effusivity_of_yarns(textile, touch.fibre_factor);
    double sum = 0;
    for (int y = 0; y < layer.grid.ny; ++y)
        for (int x = 0; x < layer.grid.nx; ++x) {
            int z = layer.last();
            while (z >= layer.first() && layer.outside[layer.grid.at(x, y, z)] > repeat.growth) --z;
            if (z < layer.first()) continue; // a hole
            const double air = touch.fibres + (layer.last() - z + 0.5) * layer.dz;
            sum += contact_heat(touch_kelvin, air_conductivity / air, effusivity, touch.seconds);
        }
    return sum / (static_cast<double>(layer.grid.nx) * layer.grid.ny);
}

} // namespace

Estimate warm_cool_feeling(const Textile& textile, bool thickness_given)
{
    const FabricQuantities& q = textile.quantities;
    const double stand = 0.5 * metre_from_mm(std::max(0.0, q.thickness_1kpa_mm - q.yarn_layer_thickness_mm)); // on one face
    const double less = thickness_given ? 1 : 0.5, more = thickness_given ? 1 : 2;
    const double fine = touch_heat(textile, voxels, {touch_seconds, stand});
    const double coarse = touch_heat(textile, coarse_voxels, {touch_seconds, stand});
    const auto over = [&](const Touch& touch) { return fine * touch_heat(textile, coarse_voxels, touch) / coarse; };
    return estimate_of(fine, {{coarse, fine * fine / coarse},
                              {over({0.5 * touch_seconds, stand}), over({2 * touch_seconds, stand})},
                              {over({touch_seconds, less * stand}), over({touch_seconds, more * stand})},
                              {over({touch_seconds, stand, 0.7}), over({touch_seconds, stand, 1.3})}});
}

Estimate PlateResistances::permeability_index() const
{
    constexpr double per_kelvin = 60; // Pa/K, of the standard
    const double index = per_kelvin * thermal.value / evaporative.value;
    // Thicker hairs raise both, so what each alone may be off is not added up.
    return {index, per_kelvin * thermal.low / evaporative.low, per_kelvin * thermal.high / evaporative.high};
}

PlateResistances plate_resistances(const Textile& textile, bool thickness_given)
{
    const double layer = textile.thickness, fibres = standing_fibres(textile, thickness_given);
    const OverAir fine = over_air(textile, voxels, 1), coarse = over_air(textile, coarse_voxels, 1),
                  conducts = over_air(textile, coarse_voxels, 1.3), insulates = over_air(textile, coarse_voxels, 0.7);
    const auto thermal = [&](double over, double standing) { return (over * layer + standing) / air_on_plate(); };
    const auto evaporative = [&](double over, double standing) {
        return evaporative_resistance(over * layer + standing, plate_temperature);
    };
    const double less = thickness_given ? 1 : 0.5, more = thickness_given ? 1 : 2;
    const double by_conductivity[] = {fine.heat * conducts.heat / coarse.heat, fine.heat * insulates.heat / coarse.heat};
    return {estimate_of(thermal(fine.heat, fibres), {{thermal(fine.heat, less * fibres), thermal(fine.heat, more * fibres)},
                                                     {thermal(by_conductivity[0], fibres), thermal(by_conductivity[1], fibres)},
                                                     {thermal(coarse.heat, fibres), thermal(fine.heat * fine.heat / coarse.heat, fibres)}}),
            estimate_of(evaporative(fine.vapour, fibres),
                        {{evaporative(fine.vapour, less * fibres), evaporative(fine.vapour, more * fibres)},
                         {evaporative(coarse.vapour, fibres), evaporative(fine.vapour * fine.vapour / coarse.vapour, fibres)}})};
}

const std::vector<VapourSetUp>& vapour_set_ups()
{
    static const std::vector<VapourSetUp> set_ups{
        {"vapour_e96_b_g_m2_day", "Vapour transmission, upright cup with water", "ASTM E96 B", 23, 1, 0.5, 0.019, 0.2},
        {"vapour_e96_bw_g_m2_day", "Vapour transmission, inverted cup with water", "ASTM E96 BW", 23, 1, 0.5, 0, 0.2, true},
        {"vapour_jis_a1_g_m2_day", "Vapour transmission, cup with calcium chloride", "JIS L1099 A-1", 40, 0.9, 0, 0.003, 0.5}};
    return set_ups;
}

Estimate vapour_transmission(const VapourSetUp& set_up, const Estimate& resistance)
{
    const auto with = [&](double of_cloth, double air_speed, double gap) {
        VapourSetUp other = set_up;
        other.air_speed *= air_speed;
        other.inner *= gap;
        return vapour_transmission(other, of_cloth);
    };
    return estimate_of(with(resistance.value, 1, 1), {{with(resistance.low, 1, 1), with(resistance.high, 1, 1)},
                                                      {with(resistance.value, 0.5, 1), with(resistance.value, 2, 1)},
                                                      {with(resistance.value, 1, 0.8), with(resistance.value, 1, 1.2)}});
}

double vapour_transmission(const VapourSetUp& set_up, double resistance)
{
    const double temperature = kelvin_from_celsius(set_up.celsius), diffusivity = vapour_diffusivity(temperature);
    constexpr double cup = 0.07;
    const double still_air = resistance / evaporative_resistance(1, plate_temperature); // m
    const double boundary =
        set_up.air_speed < 0 ? 0.0 : 1 / mass_transfer(convective_heat_transfer(set_up.air_speed, cup), temperature); // s/m
    const double difference = (set_up.humid - set_up.dry) * saturation_concentration(temperature);
    return difference / ((still_air + set_up.inner) / diffusivity + boundary);
}

} // namespace hygroloom
