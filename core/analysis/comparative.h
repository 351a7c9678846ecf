// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#pragma once

#include "core/analysis/outcomes.h"

namespace hygroloom {

/// The word for a greater number, or for a lesser one: a radius is larger, a time longer, any other number higher.
inline const char* comparative(const OutcomeInfo& info, bool more)
{
    if (info.unit == "s") return more ? "longer" : "shorter";
    const bool is_size = info.unit == "mm" || info.unit == "mm²";
    if (is_size && info.title != "height") return more ? "larger" : "smaller";
    return more ? "higher" : "lower";
}

} // namespace hygroloom
