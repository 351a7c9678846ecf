// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Heat in wet yarns and the phase change in their pores.
#pragma once

#include "core/physics/air.h"

namespace hygroloom {

constexpr double pore_mass_transfer = 0.17;  // m/s, h_lg of the paper's table A1: at the pore, not at the fabric's face
constexpr double wet_area_saturation = 0.05; // saturation from which all fibre surface counts as wet

/// Conductivity of fibre, liquid and air side by side, W/(m K): along a yarn. Fractions of the volume.
HL_FN double parallel_conductivity(double fibre_fraction, double fibre_conductivity, double liquid_fraction)
{
    const double air_fraction = 1.0 - fibre_fraction - liquid_fraction;
    return fibre_fraction * fibre_conductivity + liquid_fraction * water_conductivity + air_fraction * air_conductivity;
}

/// Conductivity across fibre, liquid and air, W/(m K): geometric mean.
HL_FN double mean_conductivity(double fibre_fraction, double fibre_conductivity, double liquid_fraction)
{
    const double air_fraction = 1.0 - fibre_fraction - liquid_fraction;
    return std::pow(fibre_conductivity, fibre_fraction) * std::pow(water_conductivity, liquid_fraction) *
           std::pow(air_conductivity, air_fraction);
}

/// Share of the fibre surface that is wet, for evaporation (f of the corrected eq. 15).
HL_FN double wet_share(double saturation)
{
    const double share = saturation * (1.0 / wet_area_saturation);
    return share < 0 ? 0.0 : share > 1 ? 1.0 : share;
}

/// Rate at which pores come to saturation, 1/s: h_lg S_v per volume of pores, S_v = 2 x fibre fraction / radius. Fibre and pores as
/// fractions or as areas of a section.
HL_FN double phase_change_rate(double fibre, double fibre_radius, double pores)
{
    return pore_mass_transfer * 2.0 * fibre * plain_inverse(fibre_radius * pores);
}

/// Share by which its own cooling slows what evaporates from a wet face: the psychrometer's balance of heat (W/(m2 K)) and vapour (m/s)
/// with the air, with the slope of the saturation curve at the air's temperature (K) taken as its chord over 1 K.
HL_FN double cooling_slows_evaporation(double heat_transfer, double mass_transfer, double temperature)
{
    const double slope = saturation_concentration(temperature) - saturation_concentration(temperature - 1.0);
    const double latent = mass_transfer * heat_of_evaporation(temperature);
    return latent * slope / (heat_transfer + latent * slope);
}

/// How much colder than the air such a face settles, K, by the same balance. Humidity 0..1.
HL_FN double wet_bulb_depression(double heat_transfer, double mass_transfer, double temperature, double humidity)
{
    const double slope = saturation_concentration(temperature) - saturation_concentration(temperature - 1.0);
    const double slows = cooling_slows_evaporation(heat_transfer, mass_transfer, temperature);
    return slows * (1.0 - humidity) * saturation_concentration(temperature) / slope;
}

} // namespace hygroloom
