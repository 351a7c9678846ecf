// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Air, and what it exchanges with a fabric's face. Temperatures in K.
#pragma once

#include "core/physics/water.h"

namespace hygroloom {

constexpr double air_specific_heat = 1006.0;        // J/(kg K), 20 C
constexpr double air_conductivity = 0.0257;         // W/(m K), 20 C
constexpr double air_kinematic_viscosity = 1.51e-5; // m2/s, 20 C
constexpr double air_prandtl = 0.71;
constexpr double lewis_number = 0.865;          // heat diffusivity / vapour diffusivity, 20 C
constexpr double still_air_heat_transfer = 3.5; // W/(m2 K), free convection (ASHRAE 3.1 below 0.2 m/s; 3 to 4)
constexpr double stefan_boltzmann = 5.670374419e-8;

/// Density of air at standard pressure, kg/m3; ideal gas.
HL_FN double air_density(double temperature) { return standard_pressure * 0.0289647 / (gas_constant * temperature); }

/// Diffusivity of vapour in air, m2/s. Massman 1998, within 3 %.
HL_FN double vapour_diffusivity(double temperature) { return 2.178e-5 * std::pow(temperature / zero_celsius, 1.81); }

/// The same where air fills only this share of the space, m2/s (Bruggeman 1935).
HL_FN double vapour_diffusivity_between(double temperature, double open_share)
{
    return vapour_diffusivity(temperature) * std::pow(open_share, 1.5);
}

/// Convective heat transfer at a face, W/(m2 K): laminar flow along a plate of the given length, not less than still air.
HL_FN double convective_heat_transfer(double air_speed, double length)
{
    const double reynolds = air_speed * length / air_kinematic_viscosity;
    const double forced = 0.664 * std::sqrt(reynolds) * std::cbrt(air_prandtl) * air_conductivity / length;
    return forced > still_air_heat_transfer ? forced : still_air_heat_transfer;
}

/// Radiative heat transfer at a face to surroundings of the air's temperature, W/(m2 K); emissivity 0.95.
HL_FN double radiative_heat_transfer(double temperature) { return 4.0 * 0.95 * stefan_boltzmann * temperature * temperature * temperature; }

/// Mass transfer coefficient that goes with a convective heat transfer, m/s (Chilton and Colburn 1934).
HL_FN double mass_transfer(double heat_transfer, double temperature)
{
    return heat_transfer / (air_density(temperature) * air_specific_heat * std::pow(lewis_number, 2.0 / 3.0));
}

} // namespace hygroloom
