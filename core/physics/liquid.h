// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A liquid at a temperature (K), and how much easier it flows where it is warmer: its own values at 20 C, changing as water's do. How fast
// its surface moves it.
#pragma once

#include "core/physics/water.h"

namespace hygroloom {

struct LiquidAt {
    double surface_tension, viscosity, density; ///< N/m, Pa s, kg/m3
};

/// Time in which surface tension (N/m) brings a volume (m3) of this density (kg/m3) into shape, s.
HL_FN double capillary_time(double volume, double density, double surface_tension) { return std::sqrt(density * volume / surface_tension); }

/// From what it is at 20 C.
inline LiquidAt liquid_at(const LiquidAt& at_20_c, double temperature)
{
    constexpr double known = 293.15;
    return {at_20_c.surface_tension * water_surface_tension(temperature) / water_surface_tension(known),
            at_20_c.viscosity * water_viscosity(temperature) / water_viscosity(known),
            at_20_c.density * water_density(temperature) / water_density(known)};
}

/// Surface tension over viscosity as a parabola of the warmth (K over a temperature), over its value at none.
struct FlowOfWarmLiquid {
    double slope = 0; ///< 1/K
    double curve = 0; ///< 1/K2
};

/// Through water's values at the temperature, 15 K below and 15 K above.
inline FlowOfWarmLiquid flow_of_warm_liquid(double temperature)
{
    constexpr double apart = 15;
    const auto ease = [](double at) { return water_surface_tension(at) / water_viscosity(at); };
    const double middle = ease(temperature), cold = ease(temperature - apart) / middle, warm = ease(temperature + apart) / middle;
    return {(warm - cold) / (2 * apart), (warm + cold - 2) / (2 * apart * apart)};
}

/// How much faster liquid of this warmth (K) flows; between a fifth and five times, where the parabola leaves what is known.
HL_FN double flow_factor(const FlowOfWarmLiquid& flow, double warmth)
{
    const double factor = 1.0 + warmth * (flow.slope + warmth * flow.curve);
    return factor < 0.2 ? 0.2 : factor > 5.0 ? 5.0 : factor;
}

} // namespace hygroloom
