// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Formulas behind the numbers that a textile laboratory measures on dry cloth. SI.
#pragma once

#include "core/physics/air.h"

namespace hygroloom {

constexpr double air_viscosity_20 = 1.818e-5; // Pa s, 20 C

/// Permeability of straight fibres that stand in all directions, m2, which fill a share of space below a quarter (Jackson and James 1986).
HL_FN double permeability_of_hairs(double fibre_radius, double share)
{
    return 3.0 * fibre_radius * fibre_radius / (20.0 * share) * (-std::log(share) - 0.931);
}

/// Speed at which viscous x speed + inertial x speed^2 is the pressure, m/s; viscous in Pa s/m and above 0, inertial in Pa s2/m2.
HL_FN double speed_of_air(double pressure, double viscous, double inertial)
{
    return 2.0 * pressure / (viscous + std::sqrt(viscous * viscous + 4.0 * inertial * pressure)); // also where inertial is 0
}

/// Conductivity across parallel fibres that fill a share of the space, in the unit of the two given: of the fibres and of what is between
/// them. First term of Rayleigh's series (1892), which is Maxwell's for cylinders; shares to about 0.7.
HL_FN double conductivity_across_fibres(double share, double fibres, double between)
{
    const double contrast = (fibres - between) / (fibres + between);
    return between * (1.0 + contrast * share) / (1.0 - contrast * share);
}

/// How high fibres stand under a pressure (Pa) that are so high under another: p grows with the cube of how close they lie (van Wyk 1946).
HL_FN double height_of_hairs(double height, double under, double pressure) { return height * std::cbrt(under / pressure); }

/// Heat that a body so much warmer gives a half space, W/m2, a time (s) after they touched through a conductance (W/(m2 K)); effusivity of
/// the half space, W s^1/2/(m2 K). Carslaw and Jaeger 1959, 2.7.
HL_FN double contact_heat(double warmer, double conductance, double effusivity, double time)
{
    const double x = conductance * std::sqrt(time) / effusivity;
    constexpr double far = 20, root_of_pi = 1.7724538509055160; // from there on its series is exact to 1e-5
    const double share = x < far ? std::exp(x * x) * std::erfc(x) : (1.0 - 0.5 / (x * x)) / (root_of_pi * x);
    return warmer * conductance * share;
}

/// Resistance of a layer to the heat that vapour carries, m2 Pa/W: still air as thick as said lets as much through. ISO 11092 at 35 C.
HL_FN double evaporative_resistance(double air_thickness, double temperature)
{
    return air_thickness * vapour_gas_constant * temperature / (vapour_diffusivity(temperature) * heat_of_evaporation(temperature));
}

} // namespace hygroloom
