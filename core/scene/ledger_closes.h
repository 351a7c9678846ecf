// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether a run kept its water.
#pragma once

#include "core/scene/frame.h"
#include "core/scene/scene.h"

#include <cmath>

namespace hygroloom {

/// True where what is missing is at most a billionth of all that was there, came or evaporated. What dry cloth took as vapour and gave
/// back is in none of these any more, but rounding of it is left: a billionth of what would fill the cloth counts as well. That is far less
/// than any result shows and far more than rounding; both billionths are choices.
inline bool ledger_closes(const Ledger& ledger, const Scene& scene)
{
    const Cloth& cloth = scene.cloth;
    const double full = scene.climate.density * cloth.crossings() * cloth.cell_area * 2 * cloth.half_thickness;
    const double at_stake = ledger.water_initial + ledger.water_delivered + std::abs(ledger.water_evaporated) + 1e-9 * full;
    return std::abs(ledger.water_imbalance()) <= 1e-9 * at_stake;
}

} // namespace hygroloom
