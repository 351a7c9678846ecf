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

} // namespace hygroloom
