// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Water in the fibre: how much at equilibrium, how fast, with what heat. Regain in kg/kg, humidity 0..1, temperature in K.
#pragma once

#include "core/base/units.h"

#include <cmath>

namespace hygroloom {

constexpr double isotherm_temperature = 293.15; // K, at which isotherms were measured

/// What a fibre's equilibrium with humidity depends on.
struct Isotherm {
    double standard_regain = 0;   ///< at 65 %
    double saturation_regain = 0; ///< at 100 %
    double monolayer_regain = 0;  ///< GAB; 0: master curve
    double gab_c = 0;
    double gab_k = 0;
    bool shifts = true; ///< with temperature
};

/// Differential heat of sorption from the liquid and its slope with humidity, J/kg water; humidity is the fibre's own. Gibson's law,
/// 195e3 (1 - a) (1 / (0.2 + a) + 1 / (1.05 - a)); within 15 % of the integral heats of wetting in Morton and Hearle's table 8.1.
struct SorptionHeat {
    double heat, slope;
};
HL_FN SorptionHeat sorption_heat_at(double humidity)
{
    const double wet = 1.0 - humidity, both = plain_inverse((0.2 + humidity) * (1.05 - humidity)), part = 195e3 * 1.25 * both;
    return {part * wet, -part * (1.0 + wet * both * (0.85 - 2.0 * humidity))};
}
HL_FN double heat_of_sorption(double humidity) { return sorption_heat_at(humidity).heat; }

/// Regain at 20 C, a quotient of second degree in humidity: scale a / (b0 + b1 a + b2 a2).
struct RegainLaw {
    double scale, b0, b1, b2;
};
/// GAB where fitted, else the master curve of Lotens and Havenith, 0.578 w65 a (1 / (a + 0.321) + 1 / (1.262 - a)).
HL_FN RegainLaw regain_law(const Isotherm& isotherm)
{
    if (isotherm.monolayer_regain > 0) {
        const double c = isotherm.gab_c, k = isotherm.gab_k;
        return {isotherm.monolayer_regain * c * k, 1.0, (c - 2.0) * k, (1.0 - c) * k * k};
    }
    constexpr double low = 0.321, high = 1.262;
    return {0.578 * isotherm.standard_regain * (low + high), low * high, high - low, -1.0};
}

/// What depends on humidity, or on what depends on it, with its slope.
struct WithSlope {
    double value, slope;
};

/// Regain at 20 C, never above saturation; with a slope of 0 where it is cut off there.
HL_FN WithSlope regain_at_reference(const RegainLaw& law, double saturation_regain, double humidity)
{
    const double a = humidity < 0 ? 0.0 : humidity > 1 ? 1.0 : humidity;
    const double inverse = plain_inverse(law.b0 + a * (law.b1 + a * law.b2)), part = law.scale * inverse, regain = part * a;
    if (regain >= saturation_regain) return {saturation_regain, 0.0};
    return {regain, part * inverse * (law.b0 - law.b2 * a * a)};
}
HL_FN double regain_at_reference(const Isotherm& isotherm, double humidity)
{
    return regain_at_reference(regain_law(isotherm), isotherm.saturation_regain, humidity).value;
}

/// Heat released from dry to saturated at 20 C by heat_of_sorption(), J per kg of dry fibre.
inline double heat_of_wetting(const Isotherm& isotherm)
{
    constexpr int steps = 2000;
    double heat = 0, before = 0;
    for (int i = 0; i < steps; ++i) {
        const double after = regain_at_reference(isotherm, (i + 1.0) / steps);
        heat += heat_of_sorption((i + 0.5) / steps) * (after - before);
        before = after;
    }
    return heat;
}

/// By how much ln humidity over a fibre of unchanged regain rises with temperature, per heat of sorption (Clausius and Clapeyron), kg/J.
HL_FN double isotherm_shift(double temperature)
{
    return (water_molar_mass / gas_constant) * (1.0 / isotherm_temperature - plain_inverse(temperature));
}

/// e^x; of little x by its series, to 1e-14.
HL_FN double exp_of_little(double x)
{
    if (std::abs(x) > 0.03) return std::exp(x);
    return 1.0 + x * (1.0 + x * (1.0 / 2 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120 + x * (1.0 / 720))))));
}

/// The humidity at 20 C that holds the same water as a humidity does where isotherms are shifted.
struct ReferenceHumidity {
    double humidity = 0;
    double ratio = 1; ///< to the humidity that was asked for
    double rise = 0;  ///< ln ratio
    SorptionHeat held{0, 0};
};
/// The root of rise + q(a e^rise) shift = 0 for a humidity a, by Newton's steps kept in a bracket, from a guess of the rise.
HL_FN ReferenceHumidity reference_humidity(double humidity, double shift, double rise)
{
    // Above 30 C the root nearest to 1 is 1 itself, and no limit of those below: fibres hold less there.
    const double most = shift > 0 ? 1.0 - 1e-9 : 1.0;
    const double a = humidity > most ? most : humidity > 0 ? humidity : 0.0;
    const double farthest = -shift * heat_of_sorption(0.0);
    double low = shift > 0 ? farthest : 0.0, high = shift > 0 ? 0.0 : farthest;
    ReferenceHumidity r;
    r.rise = rise > low && rise < high ? rise : 0.0;
    double moved = 0;
    for (int round = 0; round < 60; ++round) {
        r.ratio = exp_of_little(r.rise);
        r.humidity = a * r.ratio < 1.0 ? a * r.ratio : 1.0;
        r.held = sorption_heat_at(r.humidity);
        const double excess = r.rise + r.held.heat * shift;
        if (excess >= 0)
            high = r.rise;
        else
            low = r.rise;
        const double bend = r.held.slope * r.humidity * shift, loose = near_inverse(1.0 + bend);
        double next = r.rise - excess * loose;
        const bool inside = next >= low && next <= high;
        if (!inside) next = 0.5 * (low + high);
        moved = next - r.rise;
        r.rise = next;
        // A Newton step leaves half of its square times curvature over slope; r q'' is nowhere more than 40 q'.
        if (inside ? 20.0 * std::abs(bend * loose) * moved * moved < 5e-10 && std::abs(moved) < 1e-3 : std::abs(moved) < 1e-14) break;
    }
    r.ratio *= 1.0 + moved * (1.0 + moved * (0.5 + moved * (1.0 / 6.0)));
    r.humidity = a * r.ratio < 1.0 ? a * r.ratio : 1.0;
    return r;
}

/// The humidity at 20 C that a fibre of this regain is in equilibrium with, the inverse of regain_at_reference(), and its slope with
/// regain.
HL_FN WithSlope humidity_at_reference(const RegainLaw& law, double regain)
{
    if (regain <= 0) return {0, law.scale > 0 ? law.b0 / law.scale : 0.0};
    // b2 w a2 + (b1 w - scale) a + b0 w = 0, whose root between 0 and 1 is asked for.
    const double b0 = law.b0 * regain, b1 = law.b1 * regain - law.scale, b2 = law.b2 * regain;
    const double inside = b1 * b1 - 4.0 * b2 * b0, root = plain_root(inside > 1e-30 ? inside : 1e-30);
    const double a = 2.0 * b0 * plain_inverse(root - b1); // the small root, without cancellation
    if (a >= 1) return {1, 0};
    return {a, (law.b0 + a * (law.b1 + a * law.b2)) * near_inverse(root)};
}

/// Equilibrium regain at a humidity and temperature.
HL_FN double equilibrium_regain(const Isotherm& isotherm, double humidity, double temperature)
{
    const double shift = isotherm.shifts ? isotherm_shift(temperature) : 0.0;
    return regain_at_reference(isotherm, reference_humidity(humidity, shift, 0.0).humidity);
}

enum class DiffusionLaw { constant, cotton_two_stage, wool_two_stage };

/// Diffusivity of water in a fibre.
struct FibreDiffusivity {
    DiffusionLaw law = DiffusionLaw::constant;
    double constant = 0;             ///< m2/s at 20 C
    double activation_energy = 35e3; ///< J/mol, of the constant
};

/// Li and Luo's two stages as the larger of both, without their switch in time, with a floor; or a constant with an activation
/// energy. m2/s. Departs from the paper: its printed law is ten times too large and negative above 4.6 % regain.
HL_FN double fibre_diffusivity(const FibreDiffusivity& diffusivity, double regain, double temperature)
{
    const double w = regain < 0 ? 0.0 : regain;
    if (diffusivity.law == DiffusionLaw::constant)
        return diffusivity.constant *
               std::exp(diffusivity.activation_energy * (1.0 / gas_constant) * (1.0 / 293.15 - plain_inverse(temperature)));
    const bool cotton = diffusivity.law == DiffusionLaw::cotton_two_stage;
    const double first = cotton ? (0.8481 + w * (50.6 - 1100.0 * w)) * 1e-14 : (1.04 + w * (68.20 - 1342.59 * w)) * 1e-14;
    const double second =
        cotton ? 2.5e-14 * (1.0 - std::exp(-3.5385 * std::exp(-45.0 * w))) : 1.614e-14 * (1.0 - std::exp(-18.163 * std::exp(-28.0 * w)));
    const double floor = cotton ? 5e-16 : 1e-15;
    const double larger = first > second ? first : second;
    return larger > floor ? larger : floor;
}

} // namespace hygroloom
