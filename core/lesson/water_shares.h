// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the water of drops is, counted in drops, so that people can add it up.
#pragma once

#include "core/scene/frame.h"

namespace hygroloom {

/// In tenths of a drop; they add up to ten times the drops. What fibres held at the start and gave since is less than 0 in them, what air
/// has given to the cloth is less than 0 in the air.
struct WaterShares {
    int drops = 0;
    int in_yarns = 0;  ///< liquid and vapour
    int in_fibres = 0; ///< bound, more than at the start
    int in_air = 0;
    int standing = 0; ///< on the cloth, or falling
    int run_off = 0;
    bool operator==(const WaterShares&) const = default;
};

/// Rounded so that the sum is kept: the largest remainders are rounded up. bound_at_start in kg. Of no drops all is 0.
WaterShares water_shares(const Ledger& ledger, double bound_at_start, int drops);

} // namespace hygroloom
