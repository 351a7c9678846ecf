// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Water as a function of temperature (K). Valid 263 to 373 K unless said; below 273 K the liquid is supercooled.
#pragma once

#include "core/base/units.h"

#include <cmath>

namespace hygroloom {

constexpr double water_specific_heat = 4186.0;                          // J/(kg K), 20 C
constexpr double water_conductivity = 0.60;                             // W/(m K), 20 C
constexpr double vapour_gas_constant = gas_constant / water_molar_mass; // J/(kg K)

/// Surface tension against air, N/m. IAPWS release on surface tension (1994/2014).
HL_FN double water_surface_tension(double temperature)
{
    const double tau = 1.0 - temperature / 647.096;
    return 0.2358 * std::pow(tau, 1.256) * (1.0 - 0.625 * tau);
}

/// Dynamic viscosity, Pa s. IAPWS fit at 0.1 MPa, 253 to 383 K (Patek et al. 2009).
HL_FN double water_viscosity(double temperature)
{
    const double x = temperature / 300.0;
    return 1e-6 * (280.68 * std::pow(x, -1.9) + 511.45 * std::pow(x, -7.7) + 61.131 * std::pow(x, -19.6) + 0.45903 * std::pow(x, -40.0));
}

/// Density, kg/m3. Kell 1975.
HL_FN double water_density(double temperature)
{
    const double t = celsius_from_kelvin(temperature);
    const double numerator =
        999.83952 + t * (16.945176 + t * (-7.9870401e-3 + t * (-46.170461e-6 + t * (105.56302e-9 - 280.54253e-12 * t))));
    return numerator / (1.0 + 16.879850e-3 * t);
}

/// Heat of evaporation, J/kg; within 0.1 % from -10 to 60 C.
HL_FN double heat_of_evaporation(double temperature) { return 1e3 * (2501.0 - 2.361 * celsius_from_kelvin(temperature)); }

/// Vapour pressure over water, Pa. Buck 1996; within 0.04 % from -10 to 60 C.
HL_FN double saturation_pressure(double temperature)
{
    const double t = celsius_from_kelvin(temperature);
    return 611.21 * std::exp((18.678 - t * (1.0 / 234.5)) * t * plain_inverse(257.14 + t));
}

/// Vapour concentration over water, kg/m3 (C* of the paper).
HL_FN double saturation_concentration(double temperature)
{
    return saturation_pressure(temperature) * plain_inverse(vapour_gas_constant * temperature);
}

/// The same with its slope with temperature, kg/(m3 K).
struct Saturation {
    double concentration, slope;
};
HL_FN Saturation saturation_at(double temperature)
{
    const double t = celsius_from_kelvin(temperature), below = plain_inverse(257.14 + t), part = t * (1.0 / 234.5);
    const double exponent = (18.678 - part) * t * below, inverse = plain_inverse(temperature);
    const double concentration = 611.21 / vapour_gas_constant * std::exp(exponent) * inverse;
    return {concentration, concentration * ((18.678 - 2.0 * part - exponent) * below - inverse)};
}
HL_FN double saturation_concentration_slope(double temperature) { return saturation_at(temperature).slope; }

} // namespace hygroloom
