// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Drops that stand on a face as caps: their shape, and how fast their contact line goes. Angles in radian, everything else SI.
#pragma once

#include "core/physics/air.h"

#include <cmath>

namespace hygroloom {

/// So little of a drop on a cloth is not seen: spread over where it stood, it is a film no thicker than a fibre, which mirrors nothing. An
/// assumption; the last of a drop depends on which crossings its rim happens to lie on.
constexpr double unseen_share = 0.01;

/// Height of a ball's cap over the radius of its base (angle below pi).
HL_FN double cap_steepness(double contact_angle) { return std::tan(0.5 * contact_angle); }

/// Volume of a ball's cap over the cube of its base's radius.
HL_FN double cap_fullness(double contact_angle)
{
    const double height = cap_steepness(contact_angle);
    return pi / 6.0 * height * (3.0 + height * height);
}

/// Radius of the base of a ball's cap, m; contact angle over 0 and below pi.
HL_FN double cap_base(double volume, double contact_angle) { return std::cbrt(volume / cap_fullness(contact_angle)); }

/// Contact angle of a ball's cap on a base, from 0 to pi; the inverse of cap_fullness().
HL_FN double cap_angle(double volume, double base)
{
    const double height = 2.0 * std::sinh(std::asinh(3.0 * volume / (pi * base * base * base)) / 3.0);
    return 2.0 * std::atan(height);
}

/// How fast a contact line advances, m/s, by viscous loss in the wedge of liquid at it (Voinov 1976; Tanner 1979): the cube of its angle
/// exceeds that at rest by 9 times the capillary number times the logarithm of the outer length over the inner one. That logarithm is
/// taken as 12: millimetres over the nanometres of molecules.
HL_FN double speed_of_contact_line(double surface_tension, double viscosity, double angle, double angle_at_rest)
{
    constexpr double logarithm = 12;
    const double drives = angle * angle * angle - angle_at_rest * angle_at_rest * angle_at_rest;
    return drives > 0 ? surface_tension * drives / (9.0 * logarithm * viscosity) : 0.0;
}

/// How fast inertia lets the base of a drop grow, m/s, from a ball of this radius that came at a speed: by surface tension its radius is
/// 1.14 times the root of time over the ball's own (Biance, Clanet and Quere 2004), by the impact that of the circle in which the
/// undeformed ball would cut the plane (Rioboo, Marengo and Tropea 2002).
HL_FN double speed_of_inertia(double surface_tension, double density, double ball, double speed, double base)
{
    constexpr double squared = 1.14 * 1.14;
    return (0.5 * squared * std::sqrt(surface_tension * ball / density) + ball * speed) / base;
}

/// Radius to which an impact alone spreads a drop, m: the fourth root of its Weber number, by its diameter, times that of the ball
/// (Clanet, Beguin, Richard and Quere 2004).
HL_FN double impact_base(double surface_tension, double density, double ball, double speed)
{
    return ball * std::sqrt(std::sqrt(2.0 * ball * density * speed * speed / surface_tension));
}

/// Whether a drop splashes: Weber's number to the half times Reynolds' to the quarter, by its diameter, exceeds 57.7 (Mundo, Sommerfeld
/// and Tropea 1995; smooth and rough plates).
HL_FN bool splashes(double surface_tension, double viscosity, double density, double ball, double speed)
{
    const double weber = 2.0 * ball * density * speed * speed / surface_tension, reynolds = 2.0 * ball * density * speed / viscosity;
    return std::sqrt(weber) * std::sqrt(std::sqrt(reynolds)) > 57.7;
}

/// What is integrated from 0 to infinity for the diffusion from a cap: the air's answer to a contact angle (below pi) at a place.
/// evaporation_factor() is sin / (1 + cos) of the angle + 4 times the integral (Picknett and Bexon 1977; Popov 2005).
HL_FN double evaporation_integrand(double contact_angle, double place)
{
    const double outer = pi - contact_angle;
    const double over = 2.0 * std::exp(-2.0 * pi * place) + std::exp(-2.0 * outer * place) + std::exp(-2.0 * (pi + contact_angle) * place);
    return over / -std::expm1(-4.0 * pi * place) * std::tanh(outer * place);
}

/// m3/s that still air takes from a cap for a difference of vapour concentrations of 1 kg/m3, with the factor of its contact angle; the
/// same of heat (W/K) with a conductivity in place of the diffusivity.
HL_FN double diffusion_from_cap(double base, double diffusivity, double factor) { return pi * base * diffusivity * factor; }

/// By how much wind speeds this up: Froessling's law of a ball in a stream (1938), by its diameter. The Schmidt number in case of vapour,
/// the Prandtl number in that of heat.
HL_FN double drop_in_wind(double speed, double diameter, double schmidt)
{
    return 1.0 + 0.276 * std::sqrt(speed * diameter / air_kinematic_viscosity) * std::cbrt(schmidt);
}

} // namespace hygroloom
