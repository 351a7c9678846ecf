// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/liquid.h"

namespace hygroloom {

const std::vector<Liquid>& library_liquids()
{
    static const std::vector<Liquid> liquids{
        {"water", 72.74, 1.0016, 998.2},
        {"saline", 72.99, 1.014, 1004.6},
        {"sweat", 70.0, 1.01, 1003.0},
    };
    return liquids;
}

} // namespace hygroloom
