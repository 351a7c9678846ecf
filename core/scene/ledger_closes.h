// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whether a run kept its water.
#pragma once

#include "core/scene/frame.h"
#include "core/scene/scene.h"

#include <cmath>

namespace hygroloom {

/// True where what is missing is at most a billionth of all that was there, came or evaporated. What dry cloth took as vapour and gave
/// back is in none of these any more, but rounding of it is left: a billionth of what would fill the cloth counts as well.
inline bool ledger_closes(const Ledger& ledger, const Cloth& cloth)
{
    constexpr double density = 1000; // kg/m3
    const double full = density * cloth.crossings() * cloth.cell_area * 2 * cloth.half_thickness;
    const double at_stake = ledger.water_initial + ledger.water_delivered + std::abs(ledger.water_evaporated) + 1e-9 * full;
    return std::abs(ledger.water_imbalance()) <= 1e-9 * at_stake;
}

} // namespace hygroloom
