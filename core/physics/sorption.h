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

/// Differential heat of sorption from the liquid and its slope with humidity, J/kg water; humidity is the fibre's own. Gibson's law;
/// within 15 % of the integral heats of wetting in Morton and Hearle's table 8.1.
struct SorptionHeat {
    double heat, slope;
};
HL_FN SorptionHeat sorption_heat_at(double humidity)
{
    const double wet = 1.0 - humidity, dry = 0.2 + humidity, damp = 1.05 - humidity, both = 1.0 / (dry * damp);
    const double first = damp * both, second = dry * both;
    return {195e3 * wet * (first + second), 195e3 * (wet * (second * second - first * first) - first - second)};
}
HL_FN double heat_of_sorption(double humidity) { return sorption_heat_at(humidity).heat; }

/// Regain at 20 C: GAB where fitted, else the master curve of Lotens and Havenith; never above saturation.
HL_FN double regain_at_reference(const Isotherm& isotherm, double humidity)
{
    const double a = humidity < 0 ? 0.0 : humidity > 1 ? 1.0 : humidity;
    double regain;
    if (isotherm.monolayer_regain > 0) {
        const double ka = isotherm.gab_k * a;
        regain = isotherm.monolayer_regain * isotherm.gab_c * ka / ((1.0 - ka) * (1.0 - ka + isotherm.gab_c * ka));
    } else {
        regain = 0.578 * isotherm.standard_regain * a * (1.0 / (a + 0.321) + 1.0 / (1.262 - a));
    }
    return regain < isotherm.saturation_regain ? regain : isotherm.saturation_regain;
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
    return (water_molar_mass / gas_constant) * (1.0 / isotherm_temperature - 1.0 / temperature);
}

/// The humidity at 20 C that holds the same water as this humidity does where isotherms are shifted: the least root of
/// ln r + q(r) shift = ln a, by Newton's steps kept in a bracket, from a guess if there is one (greater than 0).
HL_FN double reference_humidity(double humidity, double shift, double guess)
{
    if (humidity <= 0) return 0;
    // Above 30 C the root nearest to 1 is 1 itself, and no limit of those below: fibres hold less there.
    const double most = shift > 0 ? 1.0 - 1e-9 : 1.0;
    const double a = humidity > most ? most : humidity;
    const double target = std::log(a);
    double low = shift > 0 ? 0.0 : a, high = shift > 0 ? a : 1.0;
    double r = guess > low && guess < high ? guess : a;
    for (int round = 0; round < 60; ++round) {
        const SorptionHeat q = sorption_heat_at(r);
        const double excess = std::log(r) + q.heat * shift - target;
        if (excess >= 0)
            high = r;
        else
            low = r;
        double next = r - excess * r / (1.0 + q.slope * r * shift);
        const bool inside = next >= low && next <= high && next > 0;
        if (!inside) next = 0.5 * (low + high);
        const double moved = next > r ? next - r : r - next;
        r = next;
        if (moved < (inside ? 1e-6 * r : 1e-14)) break; // what a Newton step leaves goes with its square
    }
    return r;
}
/// The same at a temperature.
HL_FN double reference_humidity(double humidity, double temperature)
{
    return reference_humidity(humidity, isotherm_shift(temperature), 0.0);
}

/// The humidity at 20 C that a fibre of this regain is in equilibrium with: the inverse of regain_at_reference().
HL_FN double humidity_at_reference(const Isotherm& isotherm, double regain)
{
    if (regain <= 0) return 0;
    // Both laws are quotients of second degree: b2 a2 + b1 a + b0 = 0, whose root between 0 and 1 is asked for.
    double b2, b1, b0, scale = 1.0;
    if (isotherm.monolayer_regain > 0) {
        const double part = regain / isotherm.monolayer_regain;
        b2 = -part * (isotherm.gab_c - 1.0);
        b1 = part * (isotherm.gab_c - 2.0) - isotherm.gab_c;
        b0 = part;
        scale = isotherm.gab_k;
    } else {
        const double part = regain / (0.578 * isotherm.standard_regain);
        b2 = -part;
        b1 = part * (1.262 - 0.321) - (1.262 + 0.321);
        b0 = part * 0.321 * 1.262;
    }
    const double inside = b1 * b1 - 4.0 * b2 * b0;
    const double root = std::sqrt(inside > 0 ? inside : 0.0);
    const double a = 2.0 * b0 / (-b1 + root) / scale; // the small root, without cancellation
    return a < 0 ? 0.0 : a < 1 ? a : 1.0;
}

/// Slope of regain_at_reference() with humidity, where that gives this regain; 0 where it is cut off at saturation.
HL_FN double regain_slope_at_reference(const Isotherm& isotherm, double humidity, double regain)
{
    if (regain >= isotherm.saturation_regain) return 0;
    if (isotherm.monolayer_regain > 0) {
        const double ka = isotherm.gab_k * humidity, c = isotherm.gab_c;
        const double dry = 1.0 - ka, bound = 1.0 - ka + c * ka;
        return isotherm.monolayer_regain * c * isotherm.gab_k * (dry * bound + ka * (bound - (c - 1.0) * dry)) /
               (dry * dry * bound * bound);
    }
    const double low = humidity + 0.321, high = 1.262 - humidity, both = 1.0 / (low * high), first = high * both, second = low * both;
    return 0.578 * isotherm.standard_regain * (first + second + humidity * (second * second - first * first));
}

/// Equilibrium regain at a humidity and temperature.
HL_FN double equilibrium_regain(const Isotherm& isotherm, double humidity, double temperature)
{
    return regain_at_reference(isotherm, reference_humidity(humidity, isotherm.shifts ? temperature : isotherm_temperature));
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
        return diffusivity.constant * std::exp(-diffusivity.activation_energy / gas_constant * (1.0 / temperature - 1.0 / 293.15));
    const bool cotton = diffusivity.law == DiffusionLaw::cotton_two_stage;
    const double first = cotton ? (0.8481 + w * (50.6 - 1100.0 * w)) * 1e-14 : (1.04 + w * (68.20 - 1342.59 * w)) * 1e-14;
    const double second =
        cotton ? 2.5e-14 * (1.0 - std::exp(-3.5385 * std::exp(-45.0 * w))) : 1.614e-14 * (1.0 - std::exp(-18.163 * std::exp(-28.0 * w)));
    const double floor = cotton ? 5e-16 : 1e-15;
    const double larger = first > second ? first : second;
    return larger > floor ? larger : floor;
}

} // namespace hygroloom
