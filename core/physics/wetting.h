// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Wetting: Young's law and what follows from it. Angles in radian, everything else SI.
#pragma once

#include "core/base/units.h"

#include <cmath>

namespace hygroloom {

/// Adhesion tension gamma_sv - gamma_sl, N/m (Young; Departs from the paper: its eq. 7 has the wrong sign).
HL_FN double adhesion_tension(double surface_tension, double contact_angle) { return surface_tension * std::cos(contact_angle); }

/// Work of adhesion per area, J/m2 (Young and Dupre).
HL_FN double work_of_adhesion(double surface_tension, double contact_angle) { return surface_tension * (1.0 + std::cos(contact_angle)); }

/// Suction of a pore, Pa; positive draws liquid in (eq. 8). Radius > 0.
HL_FN double capillary_pressure(double surface_tension, double contact_angle, double pore_radius)
{
    return 2.0 * adhesion_tension(surface_tension, contact_angle) / pore_radius;
}

/// Height at which a column hangs in a vertical pore, m (Jurin; eq. 9).
HL_FN double equilibrium_height(double surface_tension, double contact_angle, double pore_radius, double density)
{
    return capillary_pressure(surface_tension, contact_angle, pore_radius) / (density * gravity_acceleration);
}

/// Cosine of the angle that a drop shows on a fabric whose yarns cover so much of it, with air between them (Cassie and Baxter 1944).
HL_FN double cosine_on_fabric(double contact_angle, double cover) { return cover * (1.0 + std::cos(contact_angle)) - 1.0; }

/// Area under a drop over its volume to the power 2/3: a spherical cap of that angle's cosine, which is over -1 and below 1.
HL_FN double base_of_drop(double cosine)
{
    const double sine2 = 1.0 - cosine * cosine;
    const double height = (2.0 - 3.0 * cosine + cosine * cosine * cosine) / (3.0 * sine2 * std::sqrt(sine2)); // mean, in radii of the base
    return std::cbrt(pi / (height * height));
}

/// Share of a dry face that liquid on it touches between hairs, which keep air under themselves until they are wet. Surface of hairs over
/// the face's area: seen from above a quarter of it, in the mean over directions (Cauchy); what hairs at random leave open (Corte and
/// Kallmes 1962). Air is taken to be as wide as the hair over it, an assumption of the order.
HL_FN double share_between_hairs(double hair_surface) { return std::exp(-0.25 * hair_surface); }

} // namespace hygroloom
