// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A weave in words, for tests.
#pragma once

#include "core/design/weave.h"

#include <string>

namespace hygroloom {

/// Rows as on point paper, last pick first.
inline std::string drawn(const Weave& weave)
{
    std::string text;
    for (int pick = weave.picks() - 1; pick >= 0; --pick) {
        for (int end = 0; end < weave.ends(); ++end) text += weave.warp_up(end, pick) ? '1' : '0';
        if (pick > 0) text += ' ';
    }
    return text;
}

} // namespace hygroloom
