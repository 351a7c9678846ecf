// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A small project for runs: one drop on cotton, quick to simulate. Its stain goes on growing, as the closure `paper` has it.
#pragma once

#include "core/verify/set_ups.h"

namespace hygroloom {

inline Design drop_design(double contact_angle = 35, double duration = 0.5)
{
    Design design = drop_on_cotton(2, duration, contact_angle);
    design.fabrics[0].name = "cloth";
    design.experiments[0].closure = Closure::paper;
    design.experiments[0].sample_mm = {8, 8};
    design.experiments[0].droplets[0].height_mm = 0.5;
    return design;
}

} // namespace hygroloom
