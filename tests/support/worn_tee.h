// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A garment that tests wear.
#pragma once

#include "core/project/library.h"

namespace hygroloom {

/// Adds the shipped fabric of that name.
inline void add_shipped(Design& design, const std::string& fabric)
{
    for (const Preset& preset : shipped_presets())
        if (preset.fabric().name == fabric) add_preset(design, preset);
}

/// Adds a tee of one fabric, and an experiment "wear" of so many seconds in which it is worn. Returns the tee.
inline Garment& add_worn_tee(Design& design, const std::string& fabric, double duration_s)
{
    Garment& tee = design.garments.emplace_back();
    tee.name = "tee";
    tee.panels["*"] = {fabric};
    WearExperiment& wear = design.wears.emplace_back();
    wear.name = "wear";
    wear.garment = "tee";
    wear.duration_s = duration_s;
    return tee;
}

} // namespace hygroloom
