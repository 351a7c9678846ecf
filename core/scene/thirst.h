// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What fibres could still take up, and how warm that would make them: what a run watches of parts that it leaves out.
#pragma once

#include "core/physics/heat_moisture.h"
#include "core/scene/scene.h"

namespace hygroloom {

/// Regain that fibres can gain from liquid after the start, kg/kg.
HL_FN double thirst_of(const YarnParameters& yarn, double temperature)
{
    const double more = equilibrium_regain(yarn.isotherm, 1.0, temperature) - yarn.initial_regain;
    return more > 0 ? more : 0.0;
}

/// What a segment holds, per kg of dry fibre.
struct WaterOnFibre {
    double regain, liquid;
    double wet;    ///< wet_share() of its saturation
    double thirst; ///< see thirst_of()
};

/// By what fibres have taken up or given since the start and by what they can still take from the liquid about them, if nothing of the heat
/// had escaped, K. latent: J/kg of what they have taken so far, 0 where it was liquid. humidity: of the climate.
HL_FN double warming_of(const WaterOnFibre& water, const YarnParameters& yarn, double humidity, double latent)
{
    const double sorbed = yarn.sorption_heat_scale * heat_of_sorption(humidity < 1 ? humidity : 1.0);
    const double gained = water.regain - yarn.initial_regain, left = water.thirst - gained;
    const double released = (gained > 0 ? gained : -gained) * (sorbed + latent) + water.wet * (left > 0 ? left : 0.0) * sorbed;
    return released / (yarn.fibre_specific_heat + (water.regain + water.liquid) * water_specific_heat);
}

} // namespace hygroloom
