// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Liquid in the pores between a yarn's fibres. SI; saturation 0..1 of the pore volume.
#pragma once

#include "core/physics/wetting.h"

namespace hygroloom {

/// Effective pore radius of a bundle, m: twice the pore area over the wetted perimeter. 0 < packing < 1.
HL_FN double bundle_pore_radius(double fibre_radius, double packing) { return fibre_radius * (1.0 - packing) / packing; }

/// Permeability along a hexagonal bundle, m2 (Gebart 1992). Valid for packing above about 0.35.
HL_FN double permeability_along(double fibre_radius, double packing)
{
    const double pores = 1.0 - packing;
    return 8.0 * fibre_radius * fibre_radius / 53.0 * pores * pores * pores / (packing * packing);
}

/// The same along rods at random, which leave wider ways: 1.03, 1.11, 1.18, 1.21, 1.16 times as much at packings of 0.35, 0.45, 0.5, 0.6,
/// 0.7, from flow past hard discs at random (108 discs, four samples), rounded to a line up to 0.5 and a constant beyond.
HL_FN double permeability_along_random(double fibre_radius, double packing)
{
    const double looser = (packing - 0.40) * 10.0, part = looser < 0 ? 0.0 : looser > 1 ? 1.0 : looser;
    return (1.0 + 0.18 * part) * permeability_along(fibre_radius, packing);
}

/// Permeability across a hexagonal bundle, m2 (Gebart 1992); 0 from packing 0.9069.
HL_FN double permeability_across(double fibre_radius, double packing)
{
    const double closest = 0.9068996821; // pi / (2 sqrt 3)
    if (packing >= closest) return 0.0;
    return 0.2310 * std::pow(std::sqrt(closest / packing) - 1.0, 2.5) * fibre_radius * fibre_radius;
}

/// Whether pores draw a liquid in: below 90 degrees.
HL_FN bool wets_pores(double surface_tension, double contact_angle)
{
    return adhesion_tension(surface_tension, contact_angle) > 1e-12 * surface_tension;
}

/// Liquid diffusivity along parallel pores at full saturation, m2/s; 0 when the liquid does not wet (eq. 14 corrected).
HL_FN double saturated_liquid_diffusivity(double surface_tension, double contact_angle, double pore_radius, double viscosity)
{
    if (!wets_pores(surface_tension, contact_angle)) return 0.0;
    return adhesion_tension(surface_tension, contact_angle) * pore_radius / (20.0 * viscosity);
}

/// What the closure `paper` says of flow along a yarn: D = diffusivity x saturation.
struct PoreFlow {
    double diffusivity = 0; ///< m2/s at saturation, tortuosity included; 0: does not wick
    double fall = 0;        ///< s, speed of the liquid of full pores per acceleration along them
};

/// The pores' permeability and suction are one closure with D: permeability x suction / viscosity = D / porosity, so that a column that
/// hangs in liquid ends as high as Jurin says, s = 1 - z / h. Suction in Pa at an empty pore.
HL_FN PoreFlow pore_flow(double diffusivity, double suction, double density)
{
    return {diffusivity, suction > 0 ? diffusivity * density / suction : 0.0};
}

/// Integral of D from dry to s, divided by that at saturation: flux = diffusivity x difference of this / distance.
HL_FN double spreading_potential(double saturation) { return 0.5 * saturation * saturation; }

} // namespace hygroloom
