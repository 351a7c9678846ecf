// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A bracketed search that always ends.
#pragma once

#include "core/base/portable.h"

namespace hygroloom {

/// Where a balance that rises with a trial closes: between low, where it is less than nothing, and high. Illinois' rule; where three trials
/// have not halved what lies between, as on balances that are nearly steps, the next one does.
struct Bracket {
    double low, high, at_low, at_high;
    double wide = high - low; ///< at the last of every four trials
    int side = 0, trials = 0;

    HL_FN double next()
    {
        if (++trials % 4 == 0) {
            const bool slow = high - low > 0.5 * wide;
            wide = slow ? 0.5 * (high - low) : high - low;
            if (slow) return 0.5 * (low + high);
        }
        const double trial = (low * at_high - high * at_low) / (at_high - at_low);
        return trial > low && trial < high ? trial : 0.5 * (low + high);
    }
    HL_FN void narrow(double trial, double balance)
    {
        const int now = balance > 0 ? 1 : -1;
        if (now > 0) {
            high = trial;
            at_high = balance;
            if (side == now) at_low *= 0.5;
        } else {
            low = trial;
            at_low = balance;
            if (side == now) at_high *= 0.5;
        }
        side = now;
    }
};

} // namespace hygroloom
